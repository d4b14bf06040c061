// SPDX-License-Identifier: BSD-3-Clause
#include "beam/loads.hpp"

#include <gtest/gtest.h>

namespace berm::beam::this_file {
namespace {

// Consistent loads do the work of the load per metre on every cubic deflection: here on w = 1, x and x^2 (1, L, L^2 integrated; cubic functions have these exactly).
TEST(Loads, by_metre_do_the_work_of_the_weight)
{
  const Line line = straight_line({0, 2, 5, 6}, {0, 0, 0, 0, 100, 0}, {Plane::lateral, Plane::vertical});
  Loads loads = no_loads(line);
  add_weight(line, loads);
  Real constant = 0, linear = 0, square = 0;
  for (Index i = 0; i < line.nodes(); ++i) {
    const Real x = line.x[i], force = loads.force[line.across(Plane::vertical, i)],
               moment = loads.force[line.across(Plane::vertical, i) + 1];
    constant += force;
    linear += force * x + moment;
    square += force * x * x + moment * 2 * x;
    EXPECT_EQ(loads.force[line.across(Plane::lateral, i)], 0);
  }
  EXPECT_NEAR(constant, -600, 1e-9);
  EXPECT_NEAR(linear, -100 * 18, 1e-9);
  EXPECT_NEAR(square, -100 * 72, 1e-9);
}

}  // namespace
}  // namespace berm::beam::this_file
