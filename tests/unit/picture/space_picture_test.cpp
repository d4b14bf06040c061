// SPDX-License-Identifier: BSD-3-Clause
#include "picture/space_picture.hpp"

#include <gtest/gtest.h>

namespace berm::picture {
namespace {

TEST(space_picture, axes_are_shortened_alike_and_stand_at_equal_angles)
{
  const Vec<2> x = isometric(Vec<3>::UnitX()), y = isometric(Vec<3>::UnitY()), z = isometric(Vec<3>::UnitZ());
  const Real length = std::sqrt(2. / 3);
  for (const Vec<2>& axis : {x, y, z}) EXPECT_NEAR(axis.norm(), length, 1e-15);
  EXPECT_NEAR(x.dot(y), -0.5 * length * length, 1e-15);  // 120 degrees
  EXPECT_NEAR(y.dot(z), -0.5 * length * length, 1e-15);
  EXPECT_NEAR(y[0], 0, 1e-15);  // up
  EXPECT_GT(y[1], 0);
  EXPECT_GT(x[0], 0);  // to the right
  EXPECT_LT(z[0], 0);
}

}  // namespace
}  // namespace berm::picture
