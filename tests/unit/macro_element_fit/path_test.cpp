// SPDX-License-Identifier: BSD-3-Clause
#include "macro_element_fit/path.hpp"

#include "os/error.hpp"
#include "samples/made_run.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::macro_element_fit::this_file {
namespace {

/// Pushed, and dragged under a force that is held.
MadeRun pushed_and_dragged()
{
  MadeRun run;
  run.method = settings::Method::fem;
  run.gravity_level = 1;
  run.held_V = 80;
  run.H = [](Real u) { return 6e4 * std::min<Real>(u, 0.001); };
  return run;
}

TEST(Path, has_w_given_in_a_push_by_velocity_and_V_in_a_drag_that_holds_its_force)
{
  const record::RunRecord record = pushed_and_dragged().record();
  const Path path = path_of(record);
  EXPECT_DOUBLE_EQ(path.diameter, 0.02);
  EXPECT_DOUBLE_EQ(path.friction, std::tan(70. / 3 * pi / 180)) << "of the contact";
  ASSERT_FALSE(path.push.empty());
  for (const PathPoint& p : path.push) EXPECT_FALSE(p.by_force);
  EXPECT_TRUE(path.points.back().by_force);
  EXPECT_NEAR(path.points.back().V, 80, 1e-9);
  EXPECT_NEAR(path.points.back().H, 60, 1e-9);
  EXPECT_DOUBLE_EQ(path.points.back().u, record.history["u_m"].back()) << "the last row is not thinned away";
  EXPECT_NEAR(path.largest_H(), 60, 1e-9);
  for (const PathPoint& p : path.points) EXPECT_GT(p.w, 0) << "only in the soil";
}

TEST(Path, refuses_a_run_whose_stages_dig_the_soil_at_the_pipe)
{
  record::RunRecord record = pushed_and_dragged().record();
  bodies::ExcavationSettings trench;
  trench.name = "trench";
  trench.stage = "drag";
  trench.area.x = {0.03, 0.05, 0.05, 0.03};
  trench.area.y = {-0.02, -0.02, 0, 0};
  record.settings.body.front().second.excavation.push_back(trench);
  EXPECT_THROW(path_of(record), RunError);
  record.settings.body.front().second.excavation.front().area.x = {0.13, 0.15, 0.15, 0.13};
  EXPECT_NO_THROW(path_of(record)) << "far away";
}

TEST(Path, refuses_a_run_that_has_not_come_to_its_end_and_folders_without_runs)
{
  record::RunRecord record = pushed_and_dragged().record();
  record.end = record::RunEnd::stopped;
  EXPECT_THROW(path_of(record), RunError);
  record.end = record::RunEnd::finished;
  record.settings.geometry = settings::Geometry::space;
  EXPECT_THROW(path_of(record), RunError);
  EXPECT_THROW(paths_in({"no_such_folder"}), RunError);
}

}  // namespace
}  // namespace berm::macro_element_fit::this_file
