// SPDX-License-Identifier: BSD-3-Clause
#include "settings/loads.hpp"

#include "samples/sample_driver.hpp"
#include "settings/load_checks.hpp"
#include "settings/symmetry.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

/// A drag with columns at 0 s and 1 s.
settings::StageSettings drag_with(const std::vector<std::pair<const char*, std::vector<Real>>>& columns)
{
  settings::StageSettings stage = stage_of(settings::StageKind::drag, "storm");
  stage.load_times = {0, 1};
  for (const auto& [key, values] : columns) stage.loads.of(key) = values;
  return stage;
}

TEST(LoadColumns, drive_their_freedoms_together_linear_between_their_times)
{
  Driver run({drag_with({{"H", {10, 30}}, {"V", {100, 60}}})});
  for (int n = 1; n <= 1500; ++n) {
    const Vec<2> before = run.pipe.velocity;
    run.step();
    const Real t = std::min(n * dt, Real(1));
    // m a is the drive's force here: the soil does nothing, and V is downwards.
    ASSERT_NEAR(2 * (run.pipe.velocity - before)[0] / dt, 10 + 20 * t, 1e-9) << n;
    ASSERT_NEAR(2 * (run.pipe.velocity - before)[1] / dt, -(100 - 40 * t), 1e-9) << n;
  }
}

TEST(LoadColumns, begin_with_the_ramp_of_their_stage_from_the_force_that_was_there)
{
  settings::StageSettings stage = drag_with({{"H", {10, 10}}, {"V", {100, 100}}});
  stage.ramp = 0.1;
  Driver run({push(0), stage});
  run.soil_pushes({0, 40});
  run.next_stage();
  for (int n = 0; n < 50; ++n) run.step();
  const Vec<2> before = run.pipe.velocity;
  run.step();
  EXPECT_NEAR(2 * (run.pipe.velocity - before)[0] / dt, 5.1, 1e-9);
  EXPECT_NEAR(2 * (run.pipe.velocity - before)[1] / dt, 40 - (40 + 0.51 * 60), 1e-9);
}

TEST(LoadColumns, of_velocities_keep_their_travel_where_the_time_is_scaled)
{
  settings::StageSettings stage = drag_with({{"u", {0, 0.2}}, {"w", {0.1, 0.1}}});
  for (const Real scale : {1., 0.25}) {
    stage.time_scale = scale;
    Driver run({stage});
    while (run.problem.state.time < scale - dt / 2) run.step();
    EXPECT_NEAR(run.pipe.displacement[0], 0.1, 1e-3);  // a step's rounding of the sum: 0.2 m/s dt / 2 over the scale
    EXPECT_NEAR(run.pipe.displacement[1], -0.1, 1e-12);
    EXPECT_NEAR(speed_of(stage), std::hypot(0.2, 0.1) / scale, 1e-15);
  }
}

TEST(LoadColumns, leave_what_they_do_not_name_to_the_other_keys)
{
  settings::StageSettings stage = drag_with({{"V", {50, 50}}});
  stage.velocity = 0.2;
  const Axes<2> axes;
  const settings::StageDrives<2> drives = drives_of(stage, axes, false);
  EXPECT_EQ(drives[0].by, settings::FreedomDrive::By::velocity);
  EXPECT_EQ(drives[0].value, 0.2);
  EXPECT_EQ(drives[1].by, settings::FreedomDrive::By::force);
  EXPECT_EQ(drives[1].value, -1) << "V is downwards";
  EXPECT_EQ(load_column_of(stage, axes, 0), none);
}

TEST(LoadColumns, of_a_part_of_the_whole_body_are_a_part_of_the_forces)
{
  settings::Case c = pipe_over_box({drag_with({{"H", {8, 8}}, {"w", {8, 8}}})});
  c.symmetry = {"z"};
  const settings::Case part = part_of_whole(c);
  EXPECT_EQ(part.stage[0].loads.of("H"), (std::vector<Real>{4, 4}));
  EXPECT_EQ(part.stage[0].loads.of("w"), (std::vector<Real>{8, 8}));
}

TEST(LoadColumns, that_a_geometry_has_not_are_none)
{
  settings::Case c = pipe_over_box({stage_of(settings::StageKind::drive)});
  const auto keys = [&] {
    std::vector<std::string> found;
    for (const std::size_t k : columns_for(c, c.stage[0])) found.emplace_back(settings::load_columns[k].key);
    return found;
  };
  EXPECT_EQ(keys(), (std::vector<std::string>{"x_force", "x_velocity", "x_displacement", "y_force", "y_velocity", "y_displacement",
                                              "rotation_moment", "rotation_velocity", "rotation_angle"}));
  c.geometry = settings::Geometry::axisymmetric;
  EXPECT_EQ(keys(), (std::vector<std::string>{"y_force", "y_velocity", "y_displacement"}));
  c.geometry = settings::Geometry::space;
  c.symmetry = {"x", "z"};
  EXPECT_EQ(keys(), (std::vector<std::string>{"y_force", "y_velocity", "y_displacement"}));
  c.stage[0].kind = settings::StageKind::push;
  EXPECT_EQ(keys(), (std::vector<std::string>{"V", "w", "w_displacement"}));
}

}  // namespace
}  // namespace berm::problem::this_file
