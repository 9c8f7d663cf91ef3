#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <functional>
#include <string>

// What map classes of ours that derive from MRPT's grid have in common where they are saved.

namespace mrpt_mapconv::maps
{
/** Saves a grid as COccupancyGridMap2D does, PREFIX.png and PREFIX_limits.txt, and further files
 * beside them; each appears whole or not at all.
 * \param saveMore stages the further files, given where and the prefix without its folder
 * \exception std::runtime_error naming the file and the reason if one cannot be written */
void saveStaged(const mrpt::maps::COccupancyGridMap2D& grid, const std::string& prefix,
                const std::function<void(files::OutputDir&, const std::string&)>& saveMore);

/** The options that COccupancyGridMap2D leaves out of its own stream. */
void writeOmittedOptions(mrpt::serialization::CArchive& out,
                         const mrpt::maps::COccupancyGridMap2D& grid);
void readOmittedOptions(mrpt::serialization::CArchive& in, mrpt::maps::COccupancyGridMap2D& grid);

/** All options of a COccupancyGridMap2D, for a map whose cells follow from other data. */
void writeGridOptions(mrpt::serialization::CArchive& out,
                      const mrpt::maps::COccupancyGridMap2D& grid);
void readGridOptions(mrpt::serialization::CArchive& in, mrpt::maps::COccupancyGridMap2D& grid);

/** A layer with its frame. */
void writeLayer(mrpt::serialization::CArchive& out, const grid::Layer<float>& layer);
/** \exception std::runtime_error if the stream does not hold one; the layer then stays as it was */
void readLayer(mrpt::serialization::CArchive& in, grid::Layer<float>& layer);

}  // namespace mrpt_mapconv::maps
