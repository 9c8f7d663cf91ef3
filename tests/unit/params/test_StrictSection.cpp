#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt_mapconv/params/StrictSection.h>

#include <stdexcept>
#include <string>
#include <vector>

using mrpt_mapconv::params::StrictSection;

namespace
{
mrpt::config::CConfigFileMemory ini(const std::string& text)
{
  return mrpt::config::CConfigFileMemory("[a]\n" + text + "\n");
}

/** The message of reading `key` as a Number, or "" if it is read. */
template <class Number>
std::string failure(const std::string& text, const std::string& key = "k")
{
  const auto source = ini(text);
  StrictSection section(source, "a");
  Number value{};
  try
  {
    section.read(key, value);
    return "";
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
}

template <class Number>
Number readAs(const std::string& text)
{
  const auto source = ini(text);
  StrictSection section(source, "a");
  Number value{};
  section.read("k", value);
  return value;
}
}  // namespace

TEST(StrictSection, ReadsWholeValuesWithAndWithoutComments)
{
  EXPECT_EQ(readAs<double>("k=1.5"), 1.5);
  EXPECT_EQ(readAs<double>("k = -2e-3   // metres"), -2e-3);
  EXPECT_EQ(readAs<double>("k = +4 ; voxels"), 4);
  EXPECT_EQ(readAs<double>("k = 7 # seven"), 7);
  EXPECT_EQ(readAs<std::int32_t>("k=-12"), -12);
  EXPECT_EQ(readAs<float>("k=0.25"), 0.25f);
  EXPECT_TRUE(readAs<bool>("k=Yes"));
  EXPECT_TRUE(readAs<bool>("k=true // on"));
  EXPECT_TRUE(readAs<bool>("k=1"));
}

TEST(StrictSection, ReadsFalseOverTrue)
{
  for (const char* word : {"false", "No", "0"})
  {
    const auto source = ini(std::string("k=") + word);
    StrictSection section(source, "a");
    bool value = true;
    section.read("k", value);
    EXPECT_FALSE(value) << word;
  }
}

TEST(StrictSection, AMissingKeyLeavesTheValue)
{
  const auto source = ini("other=1");
  StrictSection section(source, "a");
  double value = 42;
  section.read("k", value);
  EXPECT_EQ(value, 42);
}

TEST(StrictSection, ABadValueIsAnErrorThatNamesSectionKeyAndValue)
{
  for (const char* bad : {"banana", "1,5", "1.5m", "nan", "inf", "-inf", "1e999", "0x10", "1 2", "",
                          "+-1", "--1", "1.5.2"})
  {
    const auto message = failure<double>(std::string("k=") + bad);
    EXPECT_EQ(message, "section 'a': k = '" + std::string(bad) +
                           "' is not valid: it must be a finite number");
  }
  for (const char* bad : {"1.5", "two", "99999999999", "1e3"})
    EXPECT_NE(failure<std::int32_t>(std::string("k=") + bad), "") << bad;
  EXPECT_NE(failure<std::uint32_t>("k=-1"), "");
  for (const char* bad : {"maybe", "2", "tru", "truee"})
    EXPECT_NE(failure<bool>(std::string("k=") + bad), "") << bad;
}

TEST(StrictSection, AChoiceMustBeOneOfTheWords)
{
  const auto good = ini("k = aerial // flies");
  StrictSection section(good, "a");
  int index = 0;
  section.readChoice("k", {"ground", "aerial"}, index);
  EXPECT_EQ(index, 1);

  const auto bad = ini("k = boat");
  StrictSection badSection(bad, "a");
  try
  {
    badSection.readChoice("k", {"ground", "aerial"}, index);
    FAIL() << "no exception";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(error.what(), "section 'a': k = 'boat' is not valid: it must be ground or aerial");
  }
}

TEST(StrictSection, ReadsTextWithoutCommentAndBlanks)
{
  EXPECT_EQ("a b.ini", readAs<std::string>("k =  a b.ini   ; a file"));
  EXPECT_EQ("", readAs<std::string>("other = 1"));
}

TEST(StrictSection, CommentsAreNoUnknownKeys)
{
  const auto source = ini("// old = 1\nnew = 2");
  EXPECT_EQ(std::vector<std::string>{"new"}, StrictSection(source, "a").unknownKeys());
}

TEST(StrictSection, NamesTheKeysNobodyAskedFor)
{
  const auto source = ini("k=1\nkk=2\nother=3");
  StrictSection section(source, "a");
  double value = 0;
  section.read("k", value);
  section.ignore("other");
  EXPECT_EQ(section.unknownKeys(), std::vector<std::string>{"kk"});
}
