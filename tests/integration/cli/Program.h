#pragma once

#include <string>
#include <vector>

namespace mrpt_mapconv::testing
{
/** What a program said and how it ended. */
struct Outcome
{
  int status = -1;  //!< exit status; 128 + n if signal n ended it
  std::string out, err;
  std::string progress = {};  //!< lines of stderr that say how far the work is, which need time
};

/** Runs a program to its end. \param stdoutFile where its stdout goes; empty: into Outcome::out */
Outcome runProgram(const std::vector<std::string>& command, const std::string& stdoutFile = {});

/** Runs the built `mapconv`. */
Outcome mapconv(std::vector<std::string> arguments, const std::string& stdoutFile = {});

/** One line "mapconv: error: …" and nothing else. */
bool isOneError(const std::string& text);
/** How many lines "mapconv: warning: …" there are. */
int warningsIn(const std::string& text);

}  // namespace mrpt_mapconv::testing
