#pragma once

#include <string>
#include <utility>
#include <vector>

/** Texts that the program printed once and is to print for ever: tests/integration/cli/golden.
 *
 * After a change that is wanted, run the tests with MAPCONV_WRITE_GOLDEN=1 in the environment: they
 * write the files anew instead of comparing, and `git diff` shows what has changed. */
namespace mrpt_mapconv::testing
{
/** Pairs of what differs between runs, such as the path of a temporary folder, and what stands for
 * it in a golden file. */
using Placeholders = std::vector<std::pair<std::string, std::string>>;
std::string withPlaceholders(std::string text, const Placeholders& placeholders);

/** A JSON text with T in place of each number that is a time or a rate: those of "seconds", and
 * those whose keys end in PerSecond. */
std::string withoutTimes(const std::string& json);

std::string goldenPath(const std::string& name);
bool writesGolden();
/** Expects a text to be that of a golden file, to the last byte. */
void expectGolden(const std::string& name, const std::string& text);

}  // namespace mrpt_mapconv::testing
