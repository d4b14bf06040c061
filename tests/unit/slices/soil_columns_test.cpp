// SPDX-License-Identifier: BSD-3-Clause
#include "slices/soil_columns.hpp"

#include "samples/pipeline_case.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <numeric>

namespace berm::slices::this_file {
namespace {

TEST(SoilColumns, hold_all_soil_and_stand_as_high_as_the_bed)
{
  const TemporaryFolder folder;
  const problem::Problem<2> problem = problem::build<2>(test::line_case(), ".", folder.path().string());
  const SoilColumns columns(problem.model, 0.08);
  const std::vector<Real> heights = columns.heights(problem.state);
  ASSERT_EQ(heights.size(), 25U) << "2 m over 80 mm";
  const Real width = columns.middles()[1] - columns.middles()[0];
  EXPECT_NEAR(std::accumulate(heights.begin(), heights.end(), 0.) * width, 2 * 0.5, 1e-9) << "no soil is lost";
  // Cells are triangles: their particles are squares elsewhere, and a column has a fifth of one more or less.
  for (std::size_t k = 1; k + 1 < heights.size(); ++k) EXPECT_NEAR(heights[k], 0.5, 0.1) << "at " << columns.middles()[k];
}

TEST(SoilColumns, follow_soil_that_moves)
{
  const TemporaryFolder folder;
  problem::Problem<2> problem = problem::build<2>(test::line_case(), ".", folder.path().string());
  const SoilColumns columns(problem.model, 0.08);
  const std::vector<Real> before = columns.heights(problem.state);
  bodies::Particles<2>& particles = problem.state.particles[0];
  const Index cell = particles.occupied().front();
  const bodies::Particle<2> taken = particles.take(cell, 0);
  const std::vector<Real> after = columns.heights(problem.state);
  Real lost = 0;
  for (std::size_t k = 0; k < after.size(); ++k) lost += (before[k] - after[k]) * (columns.middles()[1] - columns.middles()[0]);
  EXPECT_NEAR(lost, taken.volume, 1e-12);
}

}  // namespace
}  // namespace berm::slices::this_file
