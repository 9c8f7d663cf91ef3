// Samples of the ISPRS comparison of ground filters (Sithole and Vosselman 2004), whose ground was
// classified by people. One setting for all; 12 other samples are tried elsewhere.
#include <gtest/gtest.h>
#include <mrpt_mapconv/aerial/Ground.h>
#include <mrpt_mapconv/eval/GroundScore.h>
#include <mrpt_mapconv/eval/LabelledCloud.h>

#include <filesystem>
#include <iostream>
#include <string>

namespace
{
using namespace mrpt_mapconv;
using aerial::GroundFilter;

struct Sample
{
  const char* name;
  double csf, smrf;  // total errors that are allowed
};

class ReferenceSample : public testing::TestWithParam<Sample>
{
 protected:
  void SetUp() override
  {
    const std::string path =
        std::string(MRPT_MAPCONV_SHARED_DIR) + "/real/isprs_samp" + GetParam().name;
    if (!std::filesystem::exists(path + ".pcd")) GTEST_SKIP() << path << ".pcd is not there";
    m_sample = eval::readLabelledCloud(path + ".pcd", path + "_ground.pcd");
  }
  double totalError(GroundFilter filter) const
  {
    aerial::GroundParams params;
    params.groundFilter = filter;
    const auto score = eval::scoreGround(aerial::findGround(m_sample.cloud, params).classification,
                                         m_sample.truth);
    std::cout << "sample " << GetParam().name << ", " << params::textOf(filter) << ": type I "
              << 100 * score.typeI() << " %, type II " << 100 * score.typeII() << " %, total "
              << 100 * score.total() << " %, kappa " << 100 * score.kappa() << " %\n";
    return score.total();
  }

 private:
  eval::LabelledCloud m_sample;
};
}  // namespace

INSTANTIATE_TEST_SUITE_P(Isprs, ReferenceSample,
                         testing::Values(Sample{"11", 0.16, 0.10}, Sample{"31", 0.03, 0.04},
                                         Sample{"52", 0.10, 0.06}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(ReferenceSample, TheClothErrsLittle)
{
  EXPECT_LE(totalError(GroundFilter::Csf), GetParam().csf);
}

TEST_P(ReferenceSample, TheMorphologicalFilterErrsLittle)
{
  EXPECT_LE(totalError(GroundFilter::Smrf), GetParam().smrf);
}
