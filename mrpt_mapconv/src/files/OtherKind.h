#pragma once

#include <mrpt_mapconv/files/ForeignKind.h>

#include <string>

namespace mrpt_mapconv::files
{
/** What foreignKindOf() says of kinds that no room reads; empty for clouds of points. */
std::string otherKindOf(const FileTraits& file);

}  // namespace mrpt_mapconv::files
