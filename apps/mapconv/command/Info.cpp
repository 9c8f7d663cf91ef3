#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/files/CloudFormat.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "command/Command.h"
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

/** Columns can only be named where there are no names: in a text. */
void warnOfColumns(const InfoOptions& options, files::InputStream& stream)
{
  const auto format = files::cloudFormatOf({stream.name(), stream.preview(), stream.fileSize()});
  if (options.columns.empty() || format == files::CloudFormat::Text) return;
  NoEffect noEffect;
  noEffect.add({"--columns"}, shownName(options.file) + " is no text of points");
  noEffect.warn();
}

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
    warnOfColumns(options, stream);
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
  sub->add_option("--columns", options->columns,
                  "names of a text's columns, such as x,y,z,_,time, if it has no line of them")
      ->type_name("NAMES");
  sub->add_flag("--json", options->json, "print one JSON object");
  sub->footer("Example:\n  mapconv info building.bt");
  return {sub, [options] { return info(*options); }};
}

}  // namespace mapconv
