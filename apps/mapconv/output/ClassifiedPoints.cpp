#include "output/ClassifiedPoints.h"

#include <mrpt_mapconv/cloud/CloudFile.h>
#include <mrpt_mapconv/cloud/LasClasses.h>
#include <mrpt_mapconv/params/Text.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "output/Console.h"

namespace mapconv
{
using namespace mrpt_mapconv;

namespace
{
bool isLas(const cloud::PointCloud& cloud) { return cloud.format.rfind("LAS ", 0) == 0; }

std::string endingOf(const std::string& file)
{
  return params::lowerCase(std::filesystem::path(file).extension().string());
}

/** What is piped in cannot be read again. */
bool isFile(const std::string& input)
{
  return input != "-" && std::filesystem::is_regular_file(input);
}

/** Whoever counts on points in the input's order, or in rows, counts wrong. */
void warnOfLackingPoints(const std::string& file, const cloud::PointCloud& cloud)
{
  if (cloud.notFinite > 0)
    printWarning(file + " lacks the " + params::counted(cloud.notFinite, "point") + " that " +
                 (cloud.notFinite == 1 ? "was" : "were") +
                 " left out, so its points have other numbers than those of the input");
}

void warnOfOtherFields(const std::string& file, const cloud::PointCloud& cloud)
{
  if (isLas(cloud))
    printWarning(file +
                 " is written without what else a .las may have (scan angles, sources, colours, "
                 "records); from a .las file into a .las all is kept");
  std::string names;
  for (const std::string& name : cloud.otherFields) names += (names.empty() ? "" : ", ") + name;
  if (!names.empty()) printWarning(file + " is written without " + names);
}

const std::string& checkedName(const std::string& pointsFile, const std::string& input)
{
  cloud::requireNameForClasses(pointsFile);
  std::error_code ignored;
  if (std::filesystem::equivalent(pointsFile, input, ignored))
    throw std::runtime_error("cannot write '" + pointsFile + "': it is the input");
  return pointsFile;
}
}  // namespace

ClassifiedPoints::ClassifiedPoints(const std::string& pointsFile, const std::string& input)
    : m_pointsFile(pointsFile), m_input(input), m_file(checkedName(pointsFile, input))
{
}

void ClassifiedPoints::write(cloud::PointCloud cloud, std::vector<std::uint8_t> classes)
{
  const std::string& staged = m_file.stagingPath();
  if (isLas(cloud) && endingOf(staged) == ".las" && isFile(m_input))
    return cloud::copyLasWithClasses(m_input, staged, classes);
  warnOfLackingPoints(m_pointsFile, cloud);
  warnOfOtherFields(m_pointsFile, cloud);
  if (!cloud.classification.empty() && !cloud.withheld.empty())
    for (std::size_t i = 0; i < classes.size(); ++i)
      if (cloud.withheld[i]) classes[i] = cloud.classification[i];
  cloud.classification = std::move(classes);
  cloud::writeCloudFile(staged, cloud);
}

}  // namespace mapconv
