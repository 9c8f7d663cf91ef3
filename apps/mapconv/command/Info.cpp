#include <mrpt_mapconv/cloud/CloudFile.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "command/Command.h"
#include "input/CloudInput.h"
#include "input/InputFile.h"
#include "input/NoEffect.h"
#include "output/Console.h"
#include "output/InfoReport.h"
#include "output/Progress.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
struct InfoOptions
{
  std::string file;
  std::string columns;
  bool json = false;
};

int info(const InfoOptions& options)
{
  ResultOutput result;
  InfoReport report;
  report.json.add("file", options.file);
  report.line("file", shownName(options.file));
  {
    Progress progress;
    progress.stage("reading " + shownName(options.file));
    auto stream = openInput(options.file);
    if (const auto bytes = stream.fileSize())
    {
      report.json.add("bytes", *bytes);
      report.line("bytes", std::to_string(*bytes));
    }
    NoEffect noEffect;
    noteColumns(stream, options.columns, noEffect);
    noEffect.warn();
    if (cloud::isCloud(stream))
      describeCloudFile(stream, options.columns, report);
    else if (isOctree(stream))
      describeOctreeFile(stream, report);
    else
      describeObjectFile(std::move(stream), report);
  }
  result.print(options.json ? report.json.text() + "\n" : report.text());
  return 0;
}
}  // namespace

std::pair<CLI::App*, Command> addInfo(CLI::App& app)
{
  CLI::App* sub = app.add_subcommand("info", "Says what a file holds");
  auto options = std::make_shared<InfoOptions>();
  sub->add_option(
         "FILE", options->file,
         std::string("an octree, cloud of points, rawlog, simplemap, gridmap or other MRPT map") +
             kOrStdin)
      ->required()
      ->type_name("");
  addColumnsOption(*sub, options->columns);
  sub->add_flag("--json", options->json, "print one JSON object");
  sub->footer("Example:\n  mapconv info building.bt");
  return {sub, [options] { return info(*options); }};
}

}  // namespace mapconv
