#include <gtest/gtest.h>
#include <mrpt_mapconv/params/Printable.h>

using namespace mrpt_mapconv::params;
using namespace std::string_literals;

TEST(Printable, TextsStayAsTheyAre)
{
  for (const auto& text : {"", "plain ~text\\n", "Grüße, 地図, 🗺"})
    EXPECT_EQ(text, printable(text));
}

TEST(Printable, WhatATerminalWouldObeyIsShownInHexadecimal)
{
  EXPECT_EQ("\\x1b[31mred", printable("\x1b[31mred"));
  EXPECT_EQ("\\x00\\x07\\x7f", printable("\0\a\x7f"s));
  EXPECT_EQ("\\xc2\\x9b2J", printable("\xC2\x9B"
                                      "2J"));             // CSI of 8 bits, as UTF-8
  EXPECT_EQ("a\\xe2\\x80\\xaeb", printable("a\u202Eb"));  // right to left
  EXPECT_EQ("\\xef\\xbb\\xbfx", printable("\uFEFFx"));
}

TEST(Printable, WhatIsNoUtf8IsShownInHexadecimal)
{
  EXPECT_EQ("\\xff\\xfe", printable("\xff\xfe"));
  EXPECT_EQ("\\xc3(", printable("\xC3("));                  // cut off
  EXPECT_EQ("\\xc0\\xaf", printable("\xC0\xAF"));           // overlong
  EXPECT_EQ("\\xed\\xa0\\x80", printable("\xED\xA0\x80"));  // surrogate
}

TEST(Printable, LinesBecomeOne) { EXPECT_EQ("a b c  d", printable("a\nb\tc\r\nd")); }

TEST(Printable, LongTextsAreCutBetweenCharacters)
{
  EXPECT_EQ("xxxx...", printable(std::string(5000, 'x'), 4));
  EXPECT_EQ("xxxx", printable("xxxx", 4));
  EXPECT_EQ("aä...", printable("aäö", 4));
}
