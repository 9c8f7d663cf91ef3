#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "input/InputMap.h"

namespace mapconv
{
/** The options that every subcommand shares that makes 2D maps of an input. */
struct InputOptions
{
  InputRequest input;
  std::string outputDir;
  int threads = 0;
  bool json = false;
};

void addInputOptions(CLI::App& app, InputOptions& options);

/** The options for where results go and how the summary is printed. */
void addOutputOptions(CLI::App& app, std::string& dir, bool& json);
/** The options for where the poses of a rawlog come from. */
void addPoseOptions(CLI::App& app, mrpt_mapconv::observation::RawlogOptions& options);

/** The option for the number of threads. */
void addThreadsOption(CLI::App& app, int& threads);

/** Accepts finite numbers above 0. */
CLI::Validator isPositive();

/** Accepts finite numbers from 0 on. */
CLI::Validator isNotNegative();

/** Accepts all finite numbers. */
CLI::Validator isFinite();

/** Accepts coordinates of any system: -1e9 to 1e9. */
CLI::Validator isOnEarth();

/** Accepts whatever number the parser reads but NaN. */
CLI::Validator isNumber();

}  // namespace mapconv
