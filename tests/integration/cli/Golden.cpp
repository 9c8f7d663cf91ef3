#include "Golden.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>

#include "support/TempDir.h"

namespace mrpt_mapconv::testing
{
namespace
{
void replaceAll(std::string& text, const std::string& from, const std::string& to)
{
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

const std::string kNumber = R"((-?[0-9][-+.0-9eE]*|null))";
}  // namespace

std::string withPlaceholders(std::string text, const Placeholders& placeholders)
{
  for (const auto& [from, to] : placeholders) replaceAll(text, from, to);
  return text;
}

std::string withoutTimes(const std::string& json)
{
  static const std::regex single("(\"(seconds|[A-Za-z]*PerSecond)\": )" + kNumber);
  static const std::regex object("\"seconds\": \\{[^}]*\\}");
  static const std::regex number(": " + kNumber);
  std::string text = std::regex_replace(json, single, "$1T");
  std::smatch found;
  if (!std::regex_search(text, found, object)) return text;
  return found.prefix().str() + std::regex_replace(found.str(), number, ": T") +
         found.suffix().str();
}

std::string goldenPath(const std::string& name)
{
  return std::string(MRPT_MAPCONV_SOURCE_DIR "/tests/integration/cli/golden/") + name;
}

bool writesGolden() { return std::getenv("MAPCONV_WRITE_GOLDEN") != nullptr; }

void expectGolden(const std::string& name, const std::string& text)
{
  if (writesGolden()) std::ofstream(goldenPath(name), std::ios::binary) << text;
  EXPECT_EQ(readBytes(goldenPath(name)), text) << name;
}

}  // namespace mrpt_mapconv::testing
