#include "Raster.h"

#include <gdal.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace mrpt_mapconv::testing
{
namespace
{
Raster::Band readBand(GDALRasterBandH band, int width, int height)
{
  Raster::Band out;
  out.name = GDALGetDescription(band);
  out.type = GDALGetDataTypeName(GDALGetRasterDataType(band));
  out.offset = GDALGetRasterOffset(band, nullptr);
  int hasNoData = 0;
  const double noData = GDALGetRasterNoDataValue(band, &hasNoData);
  out.noDataIsNan = hasNoData && std::isnan(noData);
  for (int row = height - 1; row >= 0; --row)
  {
    std::vector<double> cells(static_cast<std::size_t>(width));
    if (GDALRasterIO(band, GF_Read, 0, row, width, 1, cells.data(), width, 1, GDT_Float64, 0, 0) !=
        CE_None)
      throw std::runtime_error("cannot read row " + std::to_string(row));
    out.cells.insert(out.cells.end(), cells.begin(), cells.end());
  }
  return out;
}
}  // namespace

Raster readRaster(const std::string& path)
{
  GDALAllRegister();
  GDALDatasetH file = GDALOpen(path.c_str(), GA_ReadOnly);
  if (!file) throw std::runtime_error("GDAL cannot open " + path);
  Raster raster;
  raster.width = GDALGetRasterXSize(file);
  raster.height = GDALGetRasterYSize(file);
  GDALGetGeoTransform(file, raster.transform.data());
  for (int i = 1; i <= GDALGetRasterCount(file); ++i)
    raster.bands.push_back(readBand(GDALGetRasterBand(file, i), raster.width, raster.height));
  GDALClose(file);
  return raster;
}

void expectCells(const std::vector<double>& expected, const std::vector<double>& actual,
                 const std::string& name)
{
  ASSERT_EQ(expected.size(), actual.size()) << name;
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (std::isnan(expected[i]))
      EXPECT_TRUE(std::isnan(actual[i])) << name << " cell " << i << " is " << actual[i];
    else
      EXPECT_NEAR(expected[i], actual[i], 1e-6) << name << " cell " << i;
}

}  // namespace mrpt_mapconv::testing
