#pragma once

#include <ogr_spatialref.h>

#include <string>

namespace mrpt_mapconv::grid
{
/** What GDAL makes of "EPSG:N" or WKT; files name such systems, so no other file is read for it and
 * nothing is fetched. \return whether GDAL knows it */
inline bool setSystem(OGRSpatialReference& system, const std::string& coordinateSystem)
{
  return system.SetFromUserInput(coordinateSystem.c_str(),
                                 OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) ==
         OGRERR_NONE;
}

/** "EPSG:N" if it has a number, else WKT. */
inline std::string nameOf(const OGRSpatialReference& system)
{
  const char *authority = system.GetAuthorityName(nullptr),
             *code = system.GetAuthorityCode(nullptr);
  if (authority && code) return std::string(authority) + ":" + code;
  char* wkt = nullptr;
  std::string name;
  if (system.exportToWkt(&wkt) == OGRERR_NONE) name = wkt;
  CPLFree(wkt);
  return name;
}

}  // namespace mrpt_mapconv::grid
