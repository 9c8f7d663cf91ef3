#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace mrpt_mapconv::maps
{
/** What a map says about itself beside its cells, as `mapconv info` prints it. */
struct SelfDescription
{
  using Value = std::variant<bool, std::int32_t, double, std::string>;

  std::vector<std::pair<std::string, std::string>> lines;  //!< labels and texts, for people
  std::string name;  //!< of the object that holds the values, e.g. "parameters"
  std::vector<std::pair<std::string, Value>> values;  //!< for programs
};

/** A map class of ours that has something to say. */
class SelfDescribing
{
 public:
  virtual ~SelfDescribing() = default;
  virtual SelfDescription describe() const = 0;

 protected:
  SelfDescribing() = default;
  SelfDescribing(const SelfDescribing&) = default;
  SelfDescribing& operator=(const SelfDescribing&) = default;
};

}  // namespace mrpt_mapconv::maps
