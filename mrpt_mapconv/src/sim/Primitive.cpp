#include <mrpt_mapconv/sim/Primitive.h>

#include <map>

namespace mrpt_mapconv::sim
{
namespace
{
/** Filled while the program starts, by the PrimitiveKinds that are defined in it. */
std::map<std::string, PrimitiveKind::Reader>& registry()
{
  static std::map<std::string, PrimitiveKind::Reader> kinds;
  return kinds;
}
}  // namespace

PrimitiveKind::PrimitiveKind(const char* kind, Reader read) { registry()[kind] = read; }

std::vector<std::string> PrimitiveKind::names()
{
  std::vector<std::string> names;
  for (const auto& [name, read] : registry()) names.push_back(name);
  return names;
}

PrimitiveKind::Reader PrimitiveKind::reader(const std::string& kind)
{
  const auto it = registry().find(kind);
  return it == registry().end() ? nullptr : it->second;
}

}  // namespace mrpt_mapconv::sim
