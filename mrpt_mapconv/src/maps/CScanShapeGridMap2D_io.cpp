#include <mrpt_mapconv/grid/LayerExport.h>
#include <mrpt_mapconv/maps/CScanShapeGridMap2D.h>
#include <mrpt_mapconv/maps/GridSaving.h>

namespace mrpt_mapconv
{
using Base = mrpt::maps::COccupancyGridMap2D;

uint8_t CScanShapeGridMap2D::serializeGetVersion() const { return 0; }

/** The base class in its own stream format, what this format leaves out or rounds, and our own. */
void CScanShapeGridMap2D::serializeTo(mrpt::serialization::CArchive& out) const
{
  out << Base::serializeGetVersion();
  Base::serializeTo(out);
  out << m_xMin << m_xMax << m_yMin << m_yMax << m_is_empty;
  maps::writeOmittedOptions(out, *this);
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
  in >> read.m_xMin >> read.m_xMax >> read.m_yMin >> read.m_yMax >> read.m_is_empty;
  maps::readOmittedOptions(in, read);
  in >> read.m_cellSize >> read.maxGridCells;
  read.scanInsertionOptions.readFromStream(in);
  // MRPT's particle filters copy maps by streams: the copies' scans are not the first ones.
  if (!read.m_is_empty) read.hasReported();
  *this = read;
}

void CScanShapeGridMap2D::saveMetricMapRepresentationToFile(const std::string& prefix) const
{
  maps::saveStaged(
      *this, prefix,
      [this](files::OutputDir& out, const std::string& name)
      {
        const auto occupancy = probability();
        grid::exportLayers(out, {{"occupancy", &occupancy}}, {name + "_occupancy.tif"});
      });
}

}  // namespace mrpt_mapconv
