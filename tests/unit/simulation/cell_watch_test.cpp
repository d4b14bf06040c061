// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/cell_watch.hpp"

#include <gtest/gtest.h>

namespace berm::simulation::this_file {
namespace {

/// A circle that a stage drives over squares of 0.1 m, and over cells of twice that size right of x = 1.5 m.
struct Drive {
  problem::Model<2> model;
  problem::State<2> state;

  Drive()
  {
    mesh::BoxMesh box;
    box.size = {2, 2};
    box.cells = {20, 20};
    model.mesh = mesh::make_box<2>(box);
    for (Vec<2>& x : model.mesh.position)
      if (x[0] > 1.5) x[0] = 1.5 + 4 * (x[0] - 1.5);
    model.mesh.complete();
    bodies::CircleSettings circle;
    circle.center = {1, 1};
    circle.diameter = 0.4;
    model.rigid_bodies.push_back({"pipe", bodies::make_shape<2>(bodies::RigidShapeSettings(circle))});
    model.main_rigid = 0;
    model.driven = {0};
    state.rigid_bodies.resize(1);
  }
  void move_to(CellWatch<2>& watch, Real u)
  {
    state.rigid_bodies[0].displacement[0] = u;
    watch.observe(model, state);
  }
};

Real check(const CellWatch<2>& watch, const std::string& name)
{
  for (const auto& [key, value] : watch.checks())
    if (key == name) return std::get<Real>(value);
  return std::numeric_limits<Real>::quiet_NaN();
}

TEST(CellWatch, tells_the_sizes_and_the_part_of_the_travel_on_coarse_cells)
{
  Drive drive;
  CellWatch<2> watch;
  EXPECT_TRUE(watch.checks().empty());
  for (const Real u : {0., 0.1, 0.2, 1., 0.2}) drive.move_to(watch, u);
  EXPECT_NEAR(check(watch, "cells_at_body_first_m"), 0.1, 1e-12);
  EXPECT_NEAR(check(watch, "cells_at_body_largest_m"), 0.2, 1e-12);
  EXPECT_NEAR(check(watch, "cells_at_body_last_m"), 0.1, 1e-12);
  EXPECT_NEAR(check(watch, "travel_on_coarse_cells"), 0.8 / 1.8, 1e-12);
}

TEST(CellWatch, looks_at_no_body_that_rests)
{
  Drive drive;
  drive.model.driven = {none};
  CellWatch<2> watch;
  drive.move_to(watch, 1);
  EXPECT_TRUE(watch.checks().empty());
}

}  // namespace
}  // namespace berm::simulation::this_file
