#pragma once

#include <array>
#include <string>
#include <vector>

namespace mrpt_mapconv::testing
{
/** A GeoTIFF as GDAL reads it. */
struct Raster
{
  int width = 0, height = 0;
  std::array<double, 6> transform{};
  struct Band
  {
    std::string name, type;
    bool noDataIsNan = false;
    double offset = 0;          //!< to be added to the cells
    std::vector<double> cells;  //!< by rows from the lowest y, so from the file's last row
  };
  std::vector<Band> bands;
};

/** \exception std::runtime_error if GDAL cannot read the file */
Raster readRaster(const std::string& path);

/** Compares cell by cell to float accuracy; NaN equals NaN. */
void expectCells(const std::vector<double>& expected, const std::vector<double>& actual,
                 const std::string& name);

}  // namespace mrpt_mapconv::testing
