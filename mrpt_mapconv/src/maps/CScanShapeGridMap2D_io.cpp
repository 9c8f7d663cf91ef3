#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/grid/GeoTiff.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>

#include <filesystem>

namespace mrpt_mapconv
{
using Base = mrpt::maps::COccupancyGridMap2D;

uint8_t CScanShapeGridMap2D::serializeGetVersion() const { return 0; }

/** The base class in its own stream format, what this format leaves out or rounds, and our own. */
void CScanShapeGridMap2D::serializeTo(mrpt::serialization::CArchive& out) const
{
  out << Base::serializeGetVersion();
  Base::serializeTo(out);
  out << m_xMin << m_xMax << m_yMin << m_yMax << m_is_empty << likelihoodOptions.LF_useSquareDist
      << insertionOptions.maxFreenessUpdateCertainty << insertionOptions.maxFreenessInvalidRanges;
  out << m_cellSize << maxGridCells;
  scanInsertionOptions.writeToStream(out);
}

/** Everything is read into another map first, so a bad stream leaves this one as it was. */
void CScanShapeGridMap2D::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version)
{
  if (version != 0) MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  CScanShapeGridMap2D read;
  std::uint8_t baseVersion = 0;
  in >> baseVersion;
  read.Base::serializeFrom(in, baseVersion);
  in >> read.m_xMin >> read.m_xMax >> read.m_yMin >> read.m_yMax >> read.m_is_empty >>
      read.likelihoodOptions.LF_useSquareDist >> read.insertionOptions.maxFreenessUpdateCertainty >>
      read.insertionOptions.maxFreenessInvalidRanges;
  in >> read.m_cellSize >> read.maxGridCells;
  read.scanInsertionOptions.readFromStream(in);
  // MRPT's particle filters copy maps by streams: the copies' scans are not the first ones.
  if (!read.m_is_empty) read.hasReported();
  *this = read;
}

void CScanShapeGridMap2D::saveMetricMapRepresentationToFile(const std::string& prefix) const
{
  const std::filesystem::path whole(prefix);
  const auto name = whole.filename().string();
  files::OutputDir out(whole.has_parent_path() ? whole.parent_path().string() : ".");
  const auto staged = out.path(name + ".png");  // the base class adds the endings to a prefix
  out.path(name + "_limits.txt");
  Base::saveMetricMapRepresentationToFile(staged.substr(0, staged.size() - 4));
  const auto occupancy = probability();
  grid::writeGeoTiff(out.path(name + "_occupancy.tif"), {{"occupancy", &occupancy}});
  out.commit();
}

}  // namespace mrpt_mapconv
