#include <mrpt/core/exceptions.h>
#include <mrpt_mapconv/params/Require.h>

#include <functional>

#include "support/ScanFixtures.h"

namespace mrpt_mapconv::params
{
namespace
{
std::string lineOf(const std::function<void()>& thrower)
{
  try
  {
    thrower();
  }
  catch (const std::exception& e)
  {
    return oneLine(e);
  }
  return "no exception";
}
}  // namespace

TEST(MrptError, OneLineOfMrptsMessage)
{
  EXPECT_EQ(lineOf([] { THROW_EXCEPTION("no such thing"); }), "no such thing");
}

TEST(MrptError, OtherExceptions)
{
  EXPECT_EQ(lineOf([] { throw std::runtime_error("a\nb.bt: is empty"); }), "a b.bt: is empty");
  EXPECT_EQ(lineOf([] { throw std::runtime_error("Message: a.bt: is empty"); }),
            "Message: a.bt: is empty");
  EXPECT_EQ(lineOf([] { throw std::runtime_error(""); }), "");
}

}  // namespace mrpt_mapconv::params
