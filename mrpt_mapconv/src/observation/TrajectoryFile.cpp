#include <mrpt/core/Clock.h>
#include <mrpt/math/CQuaternion.h>
#include <mrpt_mapconv/observation/TrajectoryFile.h>
#include <mrpt_mapconv/params/IniText.h>
#include <mrpt_mapconv/params/Printable.h>
#include <mrpt_mapconv/params/Text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace mrpt_mapconv::observation
{
namespace
{
constexpr std::size_t kAngles = 7, kQuaternion = 8, kWithCovariance = 28;

/** The words of a line. */
std::vector<std::string> wordsOf(std::string line)
{
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
  std::istringstream words(line);
  std::vector<std::string> all;
  for (std::string word; words >> word;) all.push_back(word);
  return all;
}

/** The numbers of a line; nothing if one of its words is none. */
std::optional<std::vector<double>> numbersOf(const std::vector<std::string>& words)
{
  std::vector<double> numbers(words.size());
  for (std::size_t i = 0; i < words.size(); ++i)
    if (!params::readNumber(words[i], numbers[i])) return std::nullopt;
  return numbers;
}

/** Brings the lengths of a line into metres. */
void intoMetres(const LengthUnits& units, std::vector<double>& line)
{
  line[1] *= units.horizontal;
  line[2] *= units.horizontal;
  line[3] *= units.vertical;
  if (line.size() != kWithCovariance) return;
  const double factors[] = {units.horizontal, units.horizontal, units.vertical, 1, 1, 1};
  std::size_t next = kAngles;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column) line[next++] *= factors[row] * factors[column];
}

double quaternionLength(const std::vector<double>& line)
{
  return std::hypot(std::hypot(line[4], line[5]), std::hypot(line[6], line[7]));
}

mrpt::poses::CPose3D poseOf(const std::vector<double>& line)
{
  if (line.size() != kQuaternion) return {line[1], line[2], line[3], line[4], line[5], line[6]};
  const double length = quaternionLength(line);  // MRPT takes none that is longer or shorter than 1
  const mrpt::math::CQuaternionDouble turn(line[7] / length, line[4] / length, line[5] / length,
                                           line[6] / length);  // r first
  return mrpt::poses::CPose3D(turn, line[1], line[2], line[3]);
}

std::optional<mrpt::math::CMatrixDouble66> covarianceOf(const std::vector<double>& line)
{
  if (line.size() != kWithCovariance) return std::nullopt;
  mrpt::math::CMatrixDouble66 covariance;
  std::size_t next = kAngles;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column)
      covariance(row, column) = covariance(column, row) = line[next++];
  return covariance;
}

/** Reads poses, line by line. */
class TrajectoryReader
{
 public:
  TrajectoryReader(std::string file, const LengthUnits& units)
      : m_file(std::move(file)), m_units(units)
  {
  }

  void read(std::string line)
  {
    ++m_number;
    if (m_number == 1) line = params::withoutByteOrderMark(line);
    line = params::trimmed(line.substr(0, line.find('#')));
    if (line.empty()) return;
    const auto words = wordsOf(line);
    auto numbers = numbersOf(words);
    if (!numbers && m_columns == 0 && !m_hadHeader && isHeader(words))
    {
      m_hadHeader = true;
      return;
    }
    if (!numbers) fail(line, "has a column that is no finite number");
    if (m_columns == 0) m_columns = numbers->size();
    if (numbers->size() != m_columns || !isKnown(m_columns))
      fail(line,
           "has " + std::to_string(numbers->size()) +
               " columns; it must have 7 (t x y z yaw pitch roll), 8 (t x y z qx qy qz qw) or "
               "28 (7 and the covariance), as all others");
    if (numbers->size() == kQuaternion && !isTurn(*numbers))
      fail(line, "has a quaternion whose length is not 1");
    intoMetres(m_units, *numbers);
    if (!isOnEarth(*numbers)) fail(line, "has a position more than 1e9 m from 0");
    add(line, *numbers);
  }

  PoseTrack take()
  {
    if (m_track.empty()) throw std::runtime_error(m_file + ": it holds no pose");
    return std::move(m_track);
  }

 private:
  void add(const std::string& line, const std::vector<double>& numbers)
  {
    const auto time = timeStampOf(numbers.front());
    const auto pose = poseOf(numbers);
    const auto covariance = covarianceOf(numbers);
    if (covariance && !isCovariance(*covariance))
      fail(line,
           "has a covariance that is none: variances must be 0 or more, and the matrix positive "
           "semi-definite");
    if (const auto known = m_track.knownAt(time); known && *known != pose)
      fail(line, "has the time of a line before it, but another pose");
    if (!m_track.insert(time, pose, covariance ? heightCovariance(*covariance) : std::nullopt))
      fail(line, "has a time that is not valid");
  }

  static bool isKnown(std::size_t columns)
  {
    return columns == kAngles || columns == kQuaternion || columns == kWithCovariance;
  }
  static bool isHeader(const std::vector<std::string>& words)
  {
    return std::all_of(words.begin(), words.end(),
                       [](const std::string& word)
                       {
                         const auto first = static_cast<unsigned char>(word.front());
                         return std::isalpha(first) || first == '"' || first == '_';
                       });
  }
  static bool isTurn(const std::vector<double>& line)
  {
    return std::abs(quaternionLength(line) - 1) < 0.01;
  }
  static bool isOnEarth(const std::vector<double>& line)
  {
    constexpr double kFarthest = 1e9;  // [m]; whole coordinate systems are below a tenth of it
    return std::all_of(line.begin() + 1, line.begin() + 4,
                       [](double metres) { return std::abs(metres) <= kFarthest; });
  }
  [[noreturn]] void fail(const std::string& line, const std::string& what) const
  {
    throw std::runtime_error(m_file + ", line " + std::to_string(m_number) + ": '" +
                             params::printable(line, 80) + "' " + what);
  }

  std::string m_file;
  LengthUnits m_units;
  std::size_t m_number = 0, m_columns = 0;
  bool m_hadHeader = false;
  PoseTrack m_track;
};
}  // namespace

mrpt::system::TTimeStamp timeStampOf(double seconds) { return mrpt::Clock::fromDouble(seconds); }

PoseTrack readTrajectory(files::InputStream& stream, const LengthUnits& units)
{
  constexpr std::size_t most = std::size_t(1) << 32U;
  std::istringstream in(stream.readUpTo(most));
  TrajectoryReader reader(stream.name(), units);
  for (std::string line; std::getline(in, line);) reader.read(line);
  return reader.take();
}

PoseTrack readTrajectoryFile(const std::string& path, const LengthUnits& units)
{
  files::InputStream stream(path);
  return readTrajectory(stream, units);
}

}  // namespace mrpt_mapconv::observation
