// SPDX-License-Identifier: BSD-3-Clause
#include "boundary/damping.hpp"

#include "core/components.hpp"

#include <gtest/gtest.h>

namespace berm::boundary::this_file {
namespace {

TEST(LocalDamping, opposes_the_velocity_with_a_part_of_the_force_and_is_none_at_rest)
{
  EXPECT_EQ(local_damping(0.2, 5., 1e-9), -1);
  EXPECT_EQ(local_damping(0.2, -5., 3.), -1);
  EXPECT_EQ(local_damping(0.2, -5., -3.), 1);
  EXPECT_EQ(local_damping(0.2, 5., 0.), 0);
  const Components<3> force{5, -5, 5, 0}, velocity{1, -1, 0, 0}, all = local_damping(0.2, force, velocity);
  for (int d = 0; d < 3; ++d) EXPECT_EQ(all[d], local_damping(0.2, Real(force[d]), Real(velocity[d]))) << d;
}

}  // namespace
}  // namespace berm::boundary::this_file
