#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt_mapconv/params/ListedOptions.h>
#include <mrpt_mapconv/params/Require.h>

#include <cmath>
#include <limits>
#include <map>
#include <sstream>

// A parameter is listed once: what follows from the list, on made-up options.
namespace colours
{
enum class Colour
{
  Red,
  Green
};
const std::vector<std::string>& namesOf(Colour)
{
  static const std::vector<std::string> names{"red", "green"};
  return names;
}
}  // namespace colours

namespace
{
using namespace mrpt_mapconv;
using mrpt::config::CConfigFileMemory;

/** As they were in version 1 of their stream. */
struct OldOptions : params::ListedOptions<OldOptions>
{
  static constexpr const char* kName = "Options";
  static constexpr const char* kStreamName = "made-up options";
  static constexpr std::uint8_t kStreamVersion = 1;
  double length = 1.5;
  std::int32_t count = 3;

  template <class S, class V>
  static void visit(S& o, V&& v)
  {
    v("length", o.length, "m", "a length");
    v("count", o.count, "", "a number");
  }
  void check() const { params::require(length > 0, "length", length, "> 0 m"); }
};

/** As they are in version 2, with a field more of each kind, one of them in the middle. */
struct Options : params::ListedOptions<Options>
{
  static constexpr const char* kName = "Options";
  static constexpr const char* kStreamName = "made-up options";
  static constexpr std::uint8_t kStreamVersion = 2;
  double length = 1.5;
  float certainty = 0.65f;
  std::int32_t count = 3;
  double angle = -1;  // [rad]
  double unset = std::numeric_limits<double>::quiet_NaN();
  bool isOn = true;
  colours::Colour colour = colours::Colour::Red;

  template <class S, class V>
  static void visit(S& o, V&& v)
  {
    using params::since;
    v("length", o.length, "m", "a length");
    v("certainty", o.certainty, "", "a float", since(2));
    v("count", o.count, "", "a number");
    v("angle", params::Degrees(o.angle), "degrees", "an angle", since(2));
    v("unset", o.unset, "m", "nothing by default", since(2));
    v("isOn", o.isOn, "", "a bool", since(2));
    v("colour", o.colour, "", "a name", params::flag("C").since(2));
  }
  void check() const { params::require(length > 0, "length", length, "> 0 m"); }
};

template <class From, class To>
void streamed(const From& from, To& to)
{
  mrpt::io::CMemoryStream memory;
  auto archive = mrpt::serialization::archiveFrom(memory);
  from.writeToStream(archive);
  memory.Seek(0);
  to.readFromStream(archive);
  EXPECT_EQ(memory.getPosition(), memory.getTotalBytesCount()) << "all of it is read";
}

Options unusual()
{
  Options options;
  options.length = 0.1 + 0.2;  // needs 17 digits
  options.certainty = 0.7f;
  options.count = -7;
  options.angle = 0.5;
  options.unset = 2.25;
  options.isOn = false;
  options.colour = colours::Colour::Green;
  return options;
}

std::string failure(const std::string& lines, Options& options)
{
  try
  {
    options.loadFromConfigFile(CConfigFileMemory("[s]\n" + lines), "s");
    return "";
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}

TEST(Fields, AnIniIsReadIntoTheFieldsThatItNames)
{
  Options options;
  ASSERT_EQ(
      "", failure("length = 2\ncertainty = 0.8\nangle = 90\ncolour = green\nisOn = no\n", options));
  EXPECT_EQ(2, options.length);
  EXPECT_EQ(0.8f, options.certainty);
  EXPECT_EQ(3, options.count) << "not named";
  EXPECT_DOUBLE_EQ(std::acos(0.0), options.angle) << "radians";
  EXPECT_TRUE(std::isnan(options.unset));
  EXPECT_FALSE(options.isOn);
  EXPECT_EQ(colours::Colour::Green, options.colour);
}

TEST(Fields, ABadValueIsNamedAndNothingIsRead)
{
  for (const auto& [line, message] : std::vector<std::pair<std::string, std::string>>{
           {"length = -2", "section 's': length = -2 is not valid: it must be > 0 m"},
           {"count = 2.5", "section 's': count = '2.5' is not valid: it must be a whole number"},
           {"colour = blue", "section 's': colour = 'blue' is not valid: it must be red or green"},
           {"angle = steep",
            "section 's': angle = 'steep' is not valid: it must be a finite number"},
           {"isOn = perhaps",
            "section 's': isOn = 'perhaps' is not valid: it must be true or false"}})
  {
    Options options;
    EXPECT_EQ(message, failure("certainty = 0.8\n" + line + "\n", options));
    EXPECT_EQ(0.65f, options.certainty) << line;
  }
}

TEST(Fields, WhatIsSavedReadsTheSame)
{
  CConfigFileMemory ini;
  unusual().saveToConfigFile(ini, "s");
  EXPECT_EQ("0.7", ini.read_string("s", "certainty", "")) << "and not 0.699999988079071";
  EXPECT_EQ("green", ini.read_string("s", "colour", ""));
  Options read;
  read.loadFromConfigFile(ini, "s");
  EXPECT_EQ(unusual().length, read.length);
  EXPECT_EQ(unusual().certainty, read.certainty);
  EXPECT_EQ(unusual().count, read.count);
  EXPECT_DOUBLE_EQ(unusual().angle, read.angle);
  EXPECT_EQ(unusual().unset, read.unset);
  EXPECT_EQ(unusual().isOn, read.isOn);
  EXPECT_EQ(unusual().colour, read.colour);
}

TEST(Fields, WhatIsNotSetIsNotSaved)
{
  CConfigFileMemory ini;
  Options().saveToConfigFile(ini, "s");
  EXPECT_FALSE(ini.keyExists("s", "unset"));
  EXPECT_EQ("-1", ini.read_string("s", "angle", "")) << "a default is the same in both units";
}

TEST(Fields, TheyArePrintedInTheUnitsOfTheIni)
{
  std::ostringstream text;
  unusual().dumpToTextStream(text);
  EXPECT_NE(std::string::npos, text.str().find("[mrpt_mapconv Options]"));
  EXPECT_NE(std::string::npos,
            text.str().find("\ncount                                    = -7\n"));
  EXPECT_NE(std::string::npos,
            text.str().find("\ncolour                                   = green\n"));
  EXPECT_NE(std::string::npos,
            text.str().find("angle                                    = 28.647890\n"));
}

TEST(Fields, TheyArePrintedAsMrptPrintsItsOptions)
{
  struct Mrpts : mrpt::config::CLoadableOptions
  {
    void loadFromConfigFile(const mrpt::config::CConfigFileBase&, const std::string&) override {}
    void dumpToTextStream(std::ostream& out) const override
    {
      dumpVar_double(out, "length", 0.1 + 0.2);
      dumpVar_int(out, "count", -7);
      dumpVar_bool(out, "isOn", false);
    }
  };
  std::ostringstream mrpts, ours;
  Mrpts().dumpToTextStream(mrpts);
  params::printFields(unusual(), ours);
  std::istringstream lines(mrpts.str());
  for (std::string line; std::getline(lines, line);)
    EXPECT_NE(std::string::npos, ours.str().find(line + "\n")) << line << " in\n" << ours.str();
}

TEST(Fields, TheirTextsSetThem)
{
  Options read;
  const Options from = unusual();
  std::map<std::string, std::string> texts;
  params::forEachText(from, [&](const char* name, const std::string& text) { texts[name] = text; });
  params::visitFields(
      read, [&](const char* name, auto&& field, const char*, const char*, params::About = {})
      { EXPECT_TRUE(params::setFromText(texts.at(name), field)) << name; });
  EXPECT_EQ(from.length, read.length);
  EXPECT_EQ(from.certainty, read.certainty);
  EXPECT_EQ(from.count, read.count);
  EXPECT_DOUBLE_EQ(from.angle, read.angle);
  EXPECT_EQ(from.isOn, read.isOn);
  EXPECT_EQ(from.colour, read.colour);
  EXPECT_FALSE(params::setFromText("yes", read.isOn));
  EXPECT_FALSE(params::setFromText("blue", read.colour));
  EXPECT_FALSE(params::setFromText("1.5", read.count));
  EXPECT_FALSE(params::setFromText("steep", params::Degrees(read.angle)));
}

TEST(Fields, WhatTheirTextsMustBeIsSaid)
{
  std::map<std::string, std::string> right;
  const Options options;
  params::visitFields(options,
                      [&](const char* name, const auto& field, const char*, const char*,
                          params::About = {}) { right[name] = params::rightTextOf(field); });
  EXPECT_EQ("a finite number", right["length"]);
  EXPECT_EQ("a whole number", right["count"]);
  EXPECT_EQ("a finite number", right["angle"]);
  EXPECT_EQ("true or false", right["isOn"]);
  EXPECT_EQ("red or green", right["colour"]);
  EXPECT_EQ("a finite number or auto", params::rightTextOf(std::optional<double>()));
}

/** Options with a name for values of theirs, and a number that may be left to the program. */
struct NamedOptions : params::ListedOptions<NamedOptions>
{
  static constexpr const char* kName = "NamedOptions";
  static constexpr const char* kStreamName = "named options";
  static constexpr std::uint8_t kStreamVersion = 1;
  static constexpr const char* kNamedSet = "tiny";
  static constexpr const char* kNamedSetMeaning = "for tiny ones";
  std::optional<double> size = {};
  std::int32_t legs = 4;

  template <class S, class V>
  static void visit(S& o, V&& v)
  {
    v("size", o.size, "m", "a size");
    v("legs", o.legs, "", "a number", params::since(1));
  }
  void check() const { params::require(!size || *size > 0, "size", *size, "> 0 m or auto"); }
  void takeNamedSet() { size = 0.01; }
  static NamedOptions ofOlderFiles()
  {
    NamedOptions options;
    options.legs = 6;
    return options;
  }
};

TEST(Fields, AnOptionalNumberIsANumberOrAuto)
{
  NamedOptions options;
  options.loadFromConfigFile(CConfigFileMemory("[s]\nsize = 2.5"), "s");
  EXPECT_EQ(2.5, options.size);
  EXPECT_EQ("2.5", params::textOf(options.size));
  options.loadFromConfigFile(CConfigFileMemory("[s]\nlegs = 3"), "s");
  EXPECT_EQ(2.5, options.size) << "a key that is not there changes nothing";
  options.loadFromConfigFile(CConfigFileMemory("[s]\nsize = Auto ; comment"), "s");
  EXPECT_FALSE(options.size);
  EXPECT_EQ("auto", params::textOf(options.size));
  EXPECT_TRUE(params::setFromText("7", options.size));
  EXPECT_FALSE(params::setFromText("7 m", options.size));
  EXPECT_EQ(7, options.size);
  for (const char* word : {"auto", "Auto", "AUTO"})
  {
    EXPECT_TRUE(params::setFromText("+0.25", options.size)) << "as in an ini file";
    EXPECT_EQ(0.25, options.size);
    EXPECT_TRUE(params::setFromText(word, options.size));
    EXPECT_FALSE(options.size) << word;
  }
  for (const char* bad : {"nan", "inf", "+-1", "++1", "+", "", "autx"})
    EXPECT_FALSE(params::setFromText(bad, options.size)) << bad;
  std::ostringstream text;
  params::printFields(options, text);
  EXPECT_NE(std::string::npos, text.str().find("= auto\n")) << text.str();
}

TEST(Fields, AStreamTellsAutoFromANumber)
{
  for (const auto& size : {std::optional<double>(), std::optional<double>(0.0)})
  {
    NamedOptions options, read;
    options.size = size;
    read.size = 5;
    streamed(options, read);
    EXPECT_EQ(size, read.size);
  }
}

TEST(Fields, ANameStandsForValuesThatKeysBesideItReplace)
{
  NamedOptions options;
  options.loadFromConfigFile(CConfigFileMemory("[s]\ntiny = true"), "s");
  EXPECT_EQ(0.01, options.size);
  options.loadFromConfigFile(CConfigFileMemory("[s]\nsize = 3\ntiny = true"), "s");
  EXPECT_EQ(3, options.size);
  options.loadFromConfigFile(CConfigFileMemory("[s]\ntiny = false"), "s");
  EXPECT_EQ(3, options.size);
}

TEST(Fields, WhatAnOlderStreamDoesNotSayMayMeanOtherThanTheDefault)
{
  mrpt::io::CMemoryStream memory;
  auto archive = mrpt::serialization::archiveFrom(memory);
  archive << std::uint8_t(0) << 0.5;
  memory.Seek(0);
  NamedOptions read;
  read.readFromStream(archive);
  EXPECT_EQ(0.5, read.size);
  EXPECT_EQ(6, read.legs);
}

TEST(Fields, AKeyInOtherCapitalsIsUnknownAndNotRead)
{
  const CConfigFileMemory source("[s]\nLENGTH = 4\n");
  params::StrictSection ini(source, "s");
  Options options;
  params::readFields(ini, options);
  EXPECT_EQ(1.5, options.length);
  EXPECT_EQ(std::vector<std::string>{"LENGTH"}, ini.unknownKeys());
}

TEST(Fields, AStreamBringsBackEveryBit)
{
  Options read;
  streamed(unusual(), read);
  EXPECT_EQ(unusual().length, read.length);
  EXPECT_EQ(unusual().angle, read.angle) << "radians are streamed";
  EXPECT_EQ(unusual().colour, read.colour);
  EXPECT_EQ(unusual().isOn, read.isOn);
  Options empty;
  streamed(Options(), empty);
  EXPECT_TRUE(std::isnan(empty.unset));
}

TEST(Fields, AnOlderStreamLeavesNewFieldsAtTheirDefaults)
{
  OldOptions old;
  old.length = 4;
  old.count = 9;
  Options read = unusual();
  streamed(old, read);
  EXPECT_EQ(4, read.length);
  EXPECT_EQ(9, read.count);
  EXPECT_EQ(0.65f, read.certainty);
  EXPECT_EQ(-1, read.angle);
  EXPECT_EQ(colours::Colour::Red, read.colour);
}

TEST(Fields, ANewerStreamAndAnUnknownNameAreErrors)
{
  OldOptions old;
  try
  {
    streamed(Options(), old);
    ADD_FAILURE() << "read";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ("made-up options: unknown version 2", error.what());
  }
  Options bad, read;
  bad.colour = static_cast<colours::Colour>(5);
  try
  {
    streamed(bad, read);
    ADD_FAILURE() << "read";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ("made-up options: unknown colour 5", error.what());
  }
}

TEST(Fields, ListsSayWhichFieldsHaveAFlag)
{
  std::string flags;
  const Options options;
  params::visitFields(
      options,
      [&](const char* name, const auto&, const char*, const char*, params::About about = {})
      {
        if (about.flagType) flags += std::string(name) + " " + about.flagType;
      });
  EXPECT_EQ("colour C", flags);
}

TEST(Text, NumbersReadBackTheSameAndWholly)
{
  for (const double value : {0.1, 0.1 + 0.2, 1e-300, -4e8, 1.0 / 3})
  {
    double read = 0;
    EXPECT_TRUE(params::readWhole(params::shortestText(value), read));
    EXPECT_EQ(value, read);
  }
  double kept = 7;
  for (const char* text : {"", "1x", " 1", "1,5", "--1"})
    EXPECT_FALSE(params::readWhole(text, kept)) << text;
  EXPECT_EQ(7, kept);
  EXPECT_EQ("a b", params::trimmed(" \ta b\r"));
  EXPECT_EQ("", params::trimmed(" \t"));
}

}  // namespace
