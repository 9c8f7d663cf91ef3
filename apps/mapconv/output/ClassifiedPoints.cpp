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

bool endsInLas(const std::string& file)
{
  return params::lowerCase(std::filesystem::path(file).extension().string()) == ".las";
}

void warnOfOtherFields(const std::string& file, const cloud::PointCloud& cloud)
{
  std::string names;
  for (const std::string& name : cloud.otherFields) names += (names.empty() ? "" : ", ") + name;
  if (!names.empty()) printWarning(file + " is written without " + names);
}
}  // namespace

void checkPointsFile(const std::string& pointsFile, const std::string& input)
{
  cloud::requireCloudName(pointsFile);
  std::error_code ignored;
  if (std::filesystem::equivalent(pointsFile, input, ignored))
    throw std::runtime_error("cannot write '" + pointsFile + "': it is the input");
}

void writeClassified(const std::string& pointsFile, const std::string& input,
                     cloud::PointCloud cloud, std::vector<std::uint8_t> classes)
{
  if (isLas(cloud) && endsInLas(pointsFile) && input != "-")
    return cloud::copyLasWithClasses(input, pointsFile, classes);
  warnOfOtherFields(pointsFile, cloud);
  if (!cloud.classification.empty() && !cloud.withheld.empty())
    for (std::size_t i = 0; i < classes.size(); ++i)
      if (cloud.withheld[i]) classes[i] = cloud.classification[i];
  cloud.classification = std::move(classes);
  cloud::writeCloudFile(pointsFile, cloud);
}

}  // namespace mapconv
