#pragma once

#include <string>

namespace mapconv
{
/** \exception std::runtime_error if gnuplot cannot be run */
void checkGnuplot();

/** Runs a gnuplot script, which sets its own terminal and output.
 * \exception std::runtime_error with gnuplot's own words, or that it is not installed */
void runGnuplot(const std::string& script);

}  // namespace mapconv
