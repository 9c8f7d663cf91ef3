#pragma once

#include <gtest/gtest.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/CSerializable.h>
#include <mrpt/system/COutputLogger.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

/** What the tests of room `maps` share. */
namespace mrpt_mapconv::fixtures
{
constexpr const char* kMrptData = "/usr/share/mrpt/datasets/";

/** Robot at (1, 2, 3), yaw and roll 90°; sensor on it at (0.5, 0, 1), pitch 90°. By hand: the
 * sensor's (x, y, z) is (z+0.5, y, 1−x) on the robot and (2−x, 2.5+z, 3+y) in the map. */
inline mrpt::poses::CPose3D robotPose()
{
  return {1, 2, 3, mrpt::DEG2RAD(90.0), 0, mrpt::DEG2RAD(90.0)};
}
inline mrpt::poses::CPose3D sensorPose() { return {0.5, 0, 1, 0, mrpt::DEG2RAD(90.0), 0}; }

/** The object as MRPT would store it, to see that nobody altered it. */
inline std::vector<std::uint8_t> bytes(const mrpt::serialization::CSerializable& object)
{
  std::vector<std::uint8_t> out;
  mrpt::serialization::ObjectToOctetVector(&object, out);
  return out;
}

/** A logger that keeps its warnings. */
class Warnings : public mrpt::system::COutputLogger
{
 public:
  Warnings()
  {
    setLoggerName("test");
    logging_enable_console_output = false;
    logRegisterCallback(
        [this](std::string_view text, const mrpt::system::VerbosityLevel level, std::string_view,
               const mrpt::Clock::time_point)
        {
          if (level == mrpt::system::LVL_WARN) texts.emplace_back(text);
        });
  }
  std::vector<std::string> texts;
};

/** An empty directory that goes when the test ends. */
class TempDir
{
 public:
  TempDir()
      : m_path(std::filesystem::path(testing::TempDir()) /
               ("mapconv_" +
                std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + "_" +
                std::to_string(getpid())))
  {
    std::filesystem::remove_all(m_path);
    std::filesystem::create_directories(m_path);
  }
  ~TempDir() { std::filesystem::remove_all(m_path); }
  TempDir(const TempDir&) = delete;
  TempDir& operator=(const TempDir&) = delete;

  std::string file(const std::string& name) const { return (m_path / name).string(); }
  std::string path() const { return m_path.string(); }

 private:
  std::filesystem::path m_path;
};

inline std::string readBytes(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
inline void writeBytes(const std::string& path, const std::string& content)
{
  std::ofstream(path, std::ios::binary) << content;
}

/** What the call's exception says; fails if there is none or it has several lines. */
template <class Call>
std::string messageOf(const Call& call)
{
  try
  {
    call();
  }
  catch (const std::runtime_error& e)
  {
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
    return e.what();
  }
  ADD_FAILURE() << "no exception";
  return "";
}

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

}  // namespace mrpt_mapconv::fixtures
