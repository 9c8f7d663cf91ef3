#include "experiment/report/Report.h"

#include <mrpt_mapconv/files/FileIo.h>

#include "experiment/report/Gnuplot.h"

namespace mapconv
{
using mrpt_mapconv::files::writeFile;

Report::Report(mrpt_mapconv::files::OutputDir& out, const std::string& title) : m_out(out)
{
  m_text = "# " + title + "\n";
}

void Report::addHeading(const std::string& heading) { m_text += "\n## " + heading + "\n"; }

void Report::addText(const std::string& paragraph) { m_text += "\n" + paragraph + "\n"; }

void Report::addTable(const Table& table)
{
  m_text += "\n" + markdown(table);
  writeFile(m_out.path(table.name + ".csv"), csv(table));
}

void Report::addPlot(const std::string& name, const std::string& caption, const std::string& script,
                     int width, int height)
{
  const std::string size = std::to_string(width) + "," + std::to_string(height);
  runGnuplot("set terminal pngcairo size " + size + " font 'sans,13'\nset output '" +
             addPicture(name, caption) + "'\n" + script);
}

std::string Report::addPicture(const std::string& name, const std::string& caption)
{
  m_text += "\n![" + caption + "](" + name + ".png)\n\n*" + caption + "*\n";
  return m_out.path(name + ".png");
}

void Report::write() { writeFile(m_out.path("report.md"), m_text); }

}  // namespace mapconv
