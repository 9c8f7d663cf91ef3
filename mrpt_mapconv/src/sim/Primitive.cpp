#include <mrpt_mapconv/sim/Primitive.h>

#include <map>

namespace mrpt_mapconv::sim
{
namespace
{
/** Filled while the program starts, by the PrimitiveKinds that are defined in it. */
std::map<std::string, PrimitiveKind>& registry()
{
  static std::map<std::string, PrimitiveKind> kinds;
  return kinds;
}
}  // namespace

PrimitiveKind::PrimitiveKind(const char* kind, Reader reader) : read(reader)
{
  registry().emplace(kind, *this);
}

PrimitiveKind::PrimitiveKind(const char* kind, StandingReader reader) : readStanding(reader)
{
  registry().emplace(kind, *this);
}

std::vector<std::string> PrimitiveKind::names()
{
  std::vector<std::string> names;
  for (const auto& [name, kind] : registry()) names.push_back(name);
  return names;
}

const PrimitiveKind* PrimitiveKind::find(const std::string& kind)
{
  const auto it = registry().find(kind);
  return it == registry().end() ? nullptr : &it->second;
}

}  // namespace mrpt_mapconv::sim
