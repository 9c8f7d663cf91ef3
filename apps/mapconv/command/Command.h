#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "input/UsageError.h"

namespace mapconv
{
/** Runs a subcommand whose options have been parsed; gives the program's exit status. */
using Command = std::function<int()>;

/** Each declares a subcommand and its options on `app` and returns what runs it. @{ */
std::pair<CLI::App*, Command> addConvert(CLI::App& app);
std::pair<CLI::App*, Command> addProject(CLI::App& app);
std::pair<CLI::App*, Command> addInsert(CLI::App& app);
std::pair<CLI::App*, Command> addTerrain(CLI::App& app);
std::pair<CLI::App*, Command> addGround(CLI::App& app);
std::pair<CLI::App*, Command> addInfo(CLI::App& app);
std::pair<CLI::App*, Command> addParams(CLI::App& app);
std::pair<CLI::App*, Command> addRun(CLI::App& app, std::vector<std::string> program);
std::pair<CLI::App*, Command> addSampleMap(CLI::App& app);
std::pair<CLI::App*, Command> addPlan(CLI::App& app);
std::pair<CLI::App*, Command> addLift(CLI::App& app);
std::pair<CLI::App*, Command> addSimulate(CLI::App& app);
std::pair<CLI::App*, Command> addExperiment(CLI::App& app);
/** @} */

/** Takes the program and its arguments off "mapconv run -- PROGRAM ARGS…": they are not ours, and
 * the parser would take what looks like an option of ours. Without "run" nothing is taken. */
std::vector<std::string> takeProgram(std::vector<std::string>& arguments);

}  // namespace mapconv
