#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/LayerErrors.h>

#include <cmath>

#include "CellRows.h"

using namespace mrpt_mapconv;
using namespace mrpt_mapconv::testing;

TEST(LayerErrors, RmseByHand)
{
  const float kNaN = std::nanf("");
  const auto error =
      eval::rmse(row({1, 2, kNaN, 5}), row({1, 5, 3, kNaN}), mask(row({0, 0, 0, 0})));
  EXPECT_EQ(error.cells, 2u);
  EXPECT_DOUBLE_EQ(error.value, std::sqrt(9.0 / 2));
}
