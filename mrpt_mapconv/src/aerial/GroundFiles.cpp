#include <mrpt_mapconv/aerial/GroundFiles.h>

namespace mrpt_mapconv::aerial
{
void exportGround(files::OutputDir& out, const GroundLayers& layers, const GroundParams& params,
                  grid::ExportFormats formats, const std::function<void(double)>& progress)
{
  formats.metadata = grid::metadataOf(params);
  grid::exportLayers(out, styled(layers), formats, progress);
}

}  // namespace mrpt_mapconv::aerial
