#include <mrpt/serialization/stl_serialization.h>
#include <mrpt_mapconv/grid/LayerPicture.h>
#include <mrpt_mapconv/maps/GridSaving.h>

#include <filesystem>
#include <stdexcept>
#include <utility>
#include <vector>

namespace mrpt_mapconv::maps
{
using Grid = mrpt::maps::COccupancyGridMap2D;

void saveStaged(const Grid& grid, const std::string& prefix,
                const std::function<void(files::OutputDir&, const std::string&)>& saveMore)
{
  const std::filesystem::path whole(prefix);
  const auto name = whole.filename().string();
  files::OutputDir out(whole.has_parent_path() ? whole.parent_path().string() : ".");
  const auto staged = out.path(name + ".png");  // MRPT adds the endings to a prefix
  out.path(name + "_limits.txt");
  grid.Grid::saveMetricMapRepresentationToFile(staged.substr(0, staged.size() - 4));
  grid::requireCompletePng(staged);
  saveMore(out, name);
  out.commit();
}

void writeOmittedOptions(mrpt::serialization::CArchive& out, const Grid& grid)
{
  out << grid.likelihoodOptions.LF_useSquareDist << grid.insertionOptions.maxFreenessUpdateCertainty
      << grid.insertionOptions.maxFreenessInvalidRanges;
}

void readOmittedOptions(mrpt::serialization::CArchive& in, Grid& grid)
{
  in >> grid.likelihoodOptions.LF_useSquareDist >>
      grid.insertionOptions.maxFreenessUpdateCertainty >>
      grid.insertionOptions.maxFreenessInvalidRanges;
}

/** MRPT's own stream of a grid of a few cells carries the options. */
void writeGridOptions(mrpt::serialization::CArchive& out, const Grid& grid)
{
  Grid carrier(-1.0f, 1.0f, -1.0f, 1.0f, 1.0f);
  carrier.insertionOptions = grid.insertionOptions;
  carrier.likelihoodOptions = grid.likelihoodOptions;
  carrier.genericMapParams = grid.genericMapParams;
  out << carrier;
  writeOmittedOptions(out, grid);
}

void readGridOptions(mrpt::serialization::CArchive& in, Grid& grid)
{
  Grid carrier(-1.0f, 1.0f, -1.0f, 1.0f, 1.0f);
  in >> carrier;
  readOmittedOptions(in, carrier);
  grid.insertionOptions = carrier.insertionOptions;
  grid.likelihoodOptions = carrier.likelihoodOptions;
  grid.genericMapParams = carrier.genericMapParams;
}

void writeLayer(mrpt::serialization::CArchive& out, const grid::Layer<float>& layer)
{
  const grid::GridFrame& frame = layer.frame();
  out << frame.resolution << frame.x0 << frame.y0 << frame.width << frame.height << layer.cells();
}

void readLayer(mrpt::serialization::CArchive& in, grid::Layer<float>& layer)
{
  grid::GridFrame frame;
  std::vector<float> cells;
  in >> frame.resolution >> frame.x0 >> frame.y0 >> frame.width >> frame.height >> cells;
  if (frame.width < 0 || frame.height < 0 || cells.size() != frame.size())
    throw std::runtime_error("layer stream: " + std::to_string(cells.size()) + " cells for " +
                             std::to_string(frame.width) + " x " + std::to_string(frame.height));
  layer = grid::Layer<float>(frame, 0);
  layer.cells() = std::move(cells);
}

}  // namespace mrpt_mapconv::maps
