// What is wrong with a plant is named with section and key.
#include <gtest/gtest.h>

#include <stdexcept>

#include "PlantWorlds.h"
#include "WorldText.h"

namespace
{
using namespace mrpt_mapconv::test;
}  // namespace

namespace
{
struct BadPlant
{
  const char *text, *error;
};
class BadPlants : public testing::TestWithParam<BadPlant>
{
};
const BadPlant kBadPlants[] = {
    {"[trunk.a]\nplace = 30 3\nradius = 1\nheight = 1\n",
     "section 'trunk.a': place = '30 3' is not valid: it must be a place with ground (of a "
     "heightField) at it"},
    {"[trunk.a]\nplace = 3 3\nradius = 1\nheight = 0\n",
     "section 'trunk.a': height = '0' is not valid: it must be a number > 0"},
    {"[trunk.a]\nplace = 3 3\nradius = 1\nheight = 1\ntopRadius = 0\n",
     "section 'trunk.a': topRadius = '0' is not valid: it must be a number > 0"},
    {"[trunk.a]\nplace = 3 3\nradius = 1\nheight = 1\nbase = 0\n",
     "section 'trunk.a': 'base' is not a key of a trunk: correct its name or take it out"},
    {"[log.a]\nfrom = 3 3\nto = 3 3\nradius = 1\n",
     "section 'log.a': to = '3 3' is not valid: it must be another place than from"},
    {"[log.a]\nfrom = 3 3\nto = 3 33\nradius = 1\n",
     "section 'log.a': to = '3 33' is not valid: it must be a place with ground (of a heightField) "
     "at it"},
    {"[canopy.a]\nplace = 3 3\nbottom = 4\ntop = 4\nradius = 1\ndensity = 1\n",
     "section 'canopy.a': top = '4' is not valid: it must be above bottom"},
    {"[canopy.a]\nplace = 3 3\nbottom = 4\ntop = 5\nradius = 1\ndensity = 0\n",
     "section 'canopy.a': density = '0' is not valid: it must be a number > 0"},
    {"[canopy.a]\nplace = 3 3\nbottom = 4\ntop = 5\nradius = 1\ndensity = 1\nsolid = below\n",
     "section 'canopy.a': solid = 'below' is not valid: it must be true or false"},
    {"[undergrowth.a]\nmin = 3 3\nmax = 3 4\nheight = 1 1\ndensity = 1\n",
     "section 'undergrowth.a': max = '3 4' is not valid: it must be above min in x and y"},
    {"[undergrowth.a]\nmin = 3 3\nmax = 30 4\nheight = 1 1\ndensity = 1\n",
     "section 'undergrowth.a': max = '30 4' is not valid: it must be such that there is ground (of "
     "a heightField) in all of the area"},
    {"[undergrowth.a]\nmin = 3 3\nmax = 4 4\nheight = 2 1\ndensity = 1\n",
     "section 'undergrowth.a': height = '2 1' is not valid: it must be two numbers, lowest and "
     "highest, 0 < lowest <= highest"},
    {"[undergrowth.a]\nmin = 3 3\nmax = 4 4\nheight = 1 1\ndensity = 1\ncell = 0.0001\n",
     "section 'undergrowth.a': cell = '0.0001' is not valid: it must be so large that the area has "
     "at most 1e6 patches"},
    {"[undergrowth.a]\nmin = 3 3\nmax = 4 4\nheight = 1 1\ndensity = 1\ncover = 0\n",
     "section 'undergrowth.a': cover = '0' is not valid: it must be above 0"},
    {"[undergrowth.a]\nmin = 3 3\nmax = 4 4\nheight = 1 1\ndensity = 1\ncover = 1e-9\n",
     "section 'undergrowth.a': cover = '1e-9' is not valid: it must be so large that something "
     "grows in one of the patches"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = below\nterraces = 0 1\n",
     "section 'heightField.a': terraces = '0 1' is not valid: it must be two numbers, lowest and "
     "highest, 0 < lowest <= highest"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = below\nterraceTilt = 0.1\n",
     "section 'heightField.a': terraceTilt = '0.1' is not valid: it must be left out without "
     "terraces"},
    {"[heightField.a]\nmin = 0 0\nmax = 1 1\ncell = 1\nsolid = below\nterraces = 1 1\n"
     "terraceTilt = 2\n",
     "section 'heightField.a': terraceTilt = '2' is not valid: it must be within 0 and 1"},
};
}  // namespace

TEST_P(BadPlants, GetAnErrorThatNamesSectionAndKey)
{
  try
  {
    worldOf(kFlat + GetParam().text);
    FAIL() << "no error for " << GetParam().text;
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(error.what(), GetParam().error);
  }
}
INSTANTIATE_TEST_SUITE_P(Plants, BadPlants, testing::ValuesIn(kBadPlants));
