// SPDX-License-Identifier: BSD-3-Clause
#include "roofline/roofline_kernel.hpp"

#include <array>
#include <gtest/gtest.h>
#include <omp.h>

namespace berm::roofline::this_file {
namespace {

TEST(Ceiling, has_the_particles_that_were_asked_for_in_blocks_of_eight)
{
  for (const int per_cell : {1, 4, 8, 9, 16}) {
    const RooflineRun plane = run_roofline_kernel<2>(2000, per_cell, 0), space = run_roofline_kernel<3>(10000, per_cell, 0);
    EXPECT_EQ(plane.particles, plane.cells * per_cell) << per_cell;
    EXPECT_EQ(space.particles, space.cells * per_cell) << per_cell;
    EXPECT_NEAR(static_cast<double>(plane.particles), 2000, 400) << per_cell;
    EXPECT_NEAR(static_cast<double>(space.particles), 10000, 3400) << per_cell << ": half a cube more or less on a side of at least 5";
  }
}

TEST(Ceiling, steps_as_long_as_it_is_told_and_its_stresses_stay_numbers)
{
  for (const RooflineRun& run : {run_roofline_kernel<2>(1000, 6, 0.02), run_roofline_kernel<3>(1000, 6, 0.02)}) {
    EXPECT_GE(run.wall_s, 0.02);
    EXPECT_GE(run.steps, 1);
    EXPECT_TRUE(std::isfinite(run.checksum));
    EXPECT_LT(run.checksum, 0) << "the soil began under pressure";
    EXPECT_GT(run.particle_steps_per_s(), 0);
  }
}

TEST(Ceiling, of_one_state_is_the_same_for_any_number_of_threads)
{
  const auto stress = [](int threads) {
    omp_set_num_threads(threads);
    return std::array{run_roofline_kernel<2>(1000, 6, 0).checksum, run_roofline_kernel<3>(1000, 6, 0).checksum};
  };
  const auto one = stress(1);
  EXPECT_EQ(stress(2), one);
  EXPECT_EQ(stress(3), one);
}

}  // namespace
}  // namespace berm::roofline::this_file
