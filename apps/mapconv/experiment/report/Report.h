#pragma once

#include <mrpt_mapconv/files/OutputDir.h>
#include <mrpt_mapconv/grid/Layer.h>

#include <string>

#include "experiment/report/Table.h"
#include "output/Progress.h"

namespace mapconv
{
/** Where an experiment puts its results: report.md with the text, tables and plots in their order,
 * and beside it each table as NAME.csv and each plot as NAME.png. */
class Report
{
 public:
  Report(mrpt_mapconv::files::OutputDir& out, const std::string& title);

  void addHeading(const std::string& heading);
  void addText(const std::string& paragraph);
  void addTable(const Table& table);
  /** \param script for gnuplot, without terminal and output, which are set to NAME.png */
  void addPlot(const std::string& name, const std::string& caption, const std::string& script,
               int width = 1100, int height = 600);
  /** Refers to a picture that is written to the path that this returns. */
  std::string addPicture(const std::string& name, const std::string& caption);

  /** Writes report.md. */
  void write();
  const std::string& text() const { return m_text; }

 private:
  mrpt_mapconv::files::OutputDir& m_out;
  std::string m_text;
};

}  // namespace mapconv
