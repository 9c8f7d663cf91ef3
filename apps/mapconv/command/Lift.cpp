#include <mrpt_mapconv/files/AtomicFile.h>
#include <mrpt_mapconv/files/FileIo.h>
#include <mrpt_mapconv/path/LiftPath.h>
#include <mrpt_mapconv/path/PieceCheck.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "command/Command.h"
#include "input/InputFile.h"
#include "input/PathFile.h"
#include "input/PathOptions.h"
#include "output/Console.h"
#include "output/PathSummary.h"
#include "output/Summary.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
struct LiftOptions : PathOptions
{
  std::string pathFile;
};

constexpr double kSafetyRadius = 0.3;

/** The lifted path; what is wrong with the file's points is said with its name. */
path::LiftedPath lifted(const std::vector<mrpt::math::TPoint2D>& path2D, const MapFolder& map,
                        const path::LiftParams& params, const std::string& file)
{
  try
  {
    return path::liftPath(path2D, map.layers(), map.params(), params, map.voxels());
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error(file + ": " + error.what());
  }
}

/** \exception std::runtime_error naming the first point that cannot be reached, or from the one
 * before it, with the reason */
void checkPath(const path::LiftedPath& path, const MapFolder& map, const path::LiftParams& params,
               const std::string& file)
{
  if (const auto problem = path.firstProblem())
  {
    const auto bad =
        std::count_if(path.points.begin(), path.points.end(),
                      [](const auto& point) { return point.problem != path::Infeasibility::None; });
    throw std::runtime_error(file + ": " + path.describeProblem(*problem) + " (" +
                             std::to_string(bad) + " of " + std::to_string(path.points.size()) +
                             " points cannot be reached; nothing written)");
  }
  const auto problems =
      path::PieceCheck(map.layers(), map.params(), params, map.voxels()).problems(path);
  if (!problems.empty())
    throw std::runtime_error(file + ": point " + std::to_string(problems.front().index) + " " +
                             problems.front().inWords() + " (nothing written)");
}

int lift(const LiftOptions& options)
{
  checkCsvName(options.outputFile);
  std::error_code ignored;
  if (std::filesystem::equivalent(options.pathFile, options.outputFile, ignored))
    throw UsageError("-o " + options.outputFile + " is the path that is to be lifted");
  ResultOutput result;
  auto path2D = readPath2D(options.pathFile);
  const MapFolder map(options.dir);
  for (auto& point : path2D) point -= {map.reference().origin.x, map.reference().origin.y};
  const auto params =
      liftParamsOf(options, map, std::min(kSafetyRadius, map.params().minClearance / 2));
  const auto path = lifted(path2D, map, params, shownName(options.pathFile));
  checkPath(path, map, params, shownName(options.pathFile));
  files::AtomicFile file(options.outputFile);
  files::writeFile(file.stagingPath(), pathCsv(path));
  file.commit();
  JsonObject json = pathJson(path);
  result.print(options.json
                   ? json.add("output", options.outputFile).text() + "\n"
                   : fromTo(shownName(options.pathFile), options.outputFile) + pathText(path));
  return 0;
}
}  // namespace

std::pair<CLI::App*, Command> addLift(CLI::App& app)
{
  CLI::App* sub = app.add_subcommand("lift", "Gives a 2D path heights on a converted map");
  auto options = std::make_shared<LiftOptions>();
  addPathOptions(*sub, *options, "0.3 or that");
  sub->add_option("PATH", options->pathFile,
                  std::string("CSV file with a point a line: x,y [m], or a header that names the "
                              "columns") +
                      kOrStdin)
      ->required()
      ->type_name("FILE.csv");
  sub->footer(
      "Example:\n  mapconv lift maps path2d.csv --robot aerial --safety-radius 0.3 -o path3d.csv\n"
      "Points are added until they lie no further apart than a cell. If one of them cannot be\n"
      "reached, or not straight from the one before (something occupied in between; for a ground\n"
      "robot also a step too high, or ground that nobody saw), the program says which and why, "
      "and\n"
      "writes nothing.");
  return {sub, [options] { return lift(*options); }};
}

}  // namespace mapconv
