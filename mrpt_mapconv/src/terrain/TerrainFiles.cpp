#include <mrpt/core/format.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/grid/KnownFrame.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/terrain/TerrainFiles.h>

namespace mrpt_mapconv::terrain
{
using grid::LayerKind;

std::vector<grid::StyledLayer> styled(const TerrainLayers& layers)
{
  return {{"height", &layers.height, "Height", "m", LayerKind::Height},
          {"sigma", &layers.sigma, "Standard deviation of the height", "m", LayerKind::Slope},
          {"plane", &layers.plane, "Planes", "", LayerKind::Plane},
          {"leafSide", &layers.leafSide, "Side of the leaf", "m", LayerKind::Height},
          {"slope", &layers.slope, "Slope of the plane", "m/m", LayerKind::Slope},
          {"traversability", &layers.traversability, "Traversability", "", LayerKind::Occupancy}};
}

grid::StyledLayer styledLeaves(const TerrainLayers& layers)
{
  grid::StyledLayer leaves{"leaves", &layers.plane, "Leaves: squares of cells in one plane", "",
                           LayerKind::Plane};
  leaves.shade = &layers.height;
  leaves.squares = &layers.leafSide;
  return leaves;
}

std::string planesCsv(const std::vector<TerrainPlane>& planes)
{
  std::string text = "plane,cells,x,y,z,slope,slopeX,slopeY,rms,xMin,yMin,xMax,yMax\n";
  std::size_t index = 0;
  for (const TerrainPlane& p : planes)
    text += mrpt::format("%zu,%lld,%.4f,%.4f,%.4f,%.5f,%.5f,%.5f,%.5f,%.4f,%.4f,%.4f,%.4f\n",
                         index++, static_cast<long long>(p.cells), p.x, p.y, p.z, p.slope(),
                         p.slopeX, p.slopeY, p.rms, p.xMin, p.yMin, p.xMax, p.yMax);
  return text;
}

std::string stepsCsv(const std::vector<TerrainStep>& steps)
{
  std::string text = "lower,upper,height,depth,width,x,y,directionX,directionY\n";
  for (const TerrainStep& s : steps)
    text += mrpt::format("%d,%d,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f\n", s.lower, s.upper, s.height,
                         s.depth, s.width, s.x, s.y, s.directionX, s.directionY);
  return text;
}

void exportTerrain(files::OutputDir& out, const TerrainMap& map, const TerrainLayers& layers,
                   grid::ExportFormats formats, const std::function<void(double)>& progress)
{
  const std::vector<grid::StyledLayer> all = styled(layers);
  formats.metadata = grid::metadataOf(map.params());
  files::writeFile(out.path(formats.prefix + "planes.csv"), planesCsv(map.planes()));
  files::writeFile(out.path(formats.prefix + "steps.csv"), stepsCsv(map.steps()));
  if (formats.pictures)
    grid::writeLayerPng(out.path(formats.prefix + "leaves.png"), styledLeaves(layers), {},
                        grid::shownFrame(all));
  grid::exportLayers(out, all, formats, progress);
}

}  // namespace mrpt_mapconv::terrain
