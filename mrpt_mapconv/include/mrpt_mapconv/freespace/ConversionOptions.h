#pragma once

#include <mrpt_mapconv/freespace/ConversionParams.h>
#include <mrpt_mapconv/freespace/Robot.h>
#include <mrpt_mapconv/params/ListedOptions.h>

namespace mrpt_mapconv::freespace
{
/** Options of the free-space projection as MRPT reads, prints and streams them. */
struct TConversionOptions : public params::ListedOptions<TConversionOptions>
{
  static constexpr const char* kName = "TConversionOptions";
  static constexpr const char* kStreamName = "conversion options";
  static constexpr std::uint8_t kStreamVersion = 1;

  Robot robot = Robot::Ground;
  ConversionParams params;

  template <class S, class V>
  static void visit(S& o, V&& v)
  {
    v("robot", o.robot, "", "whose occupancy the grid shows: ground or aerial");
    ConversionParams::visit(o.params, v);
  }
  static constexpr const char* kNamedSet = ConversionParams::kNamedSet;
  static constexpr const char* kNamedSetMeaning = ConversionParams::kNamedSetMeaning;
  void takeNamedSet() { params.takeNamedSet(); }
  static TConversionOptions ofOlderFiles()
  {
    TConversionOptions options;
    options.params = ConversionParams::ofOlderFiles();
    return options;
  }
  /** \exception std::invalid_argument naming the parameter, its value and what would be right */
  void check() const { params.check(); }

  /** \exception std::exception for a stream that does not hold valid options */
  void readFromStream(mrpt::serialization::CArchive& in)
  {
    TConversionOptions read;
    read.ListedOptions::readFromStream(in);
    read.check();
    *this = read;
  }
};

}  // namespace mrpt_mapconv::freespace
