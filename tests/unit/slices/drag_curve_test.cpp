// SPDX-License-Identifier: BSD-3-Clause
#include "slices/drag_curve.hpp"

#include "samples/laid_slice.hpp"

#include "mpm/step.hpp"

#include <gtest/gtest.h>

namespace berm::slices::this_file {
namespace {

std::vector<Real> forces_of(const DragCurve& curve)
{
  std::vector<Real> forces;
  for (const beam::CurvePoint& point : curve.backbone.points) forces.push_back(point.force);
  return forces;
}

TEST(DragCurve, begins_with_its_steepest_line_and_is_no_steeper_later)
{
  // Soft at first, then 1000 N/m in the first 0.01 m; a dip, a jump, and a piece that pulls.
  const DragCurve curve = curve_through({{0.002, 50}, {0.01, 1000}, {0.02, 800}, {0.021, 1000}, {0.03, 1010}, {0.04, -5}, {0.05, 1100}});
  EXPECT_NO_THROW(beam::check(beam::PlasticSpring{curve.backbone}));
  EXPECT_EQ(curve.backbone.stiffness(), 1e5);
  const std::vector<Real> forces = forces_of(curve);
  ASSERT_EQ(forces.size(), 5U);
  EXPECT_NEAR(forces[2], 900, 1e-9) << "0.001 m further than 800 N/m, at 1e5 N/m2";
  EXPECT_EQ(forces[3], 1010);
  EXPECT_EQ(forces[4], 1100);
  EXPECT_EQ(curve.measured, 7);
  EXPECT_EQ(curve.left_out, 2);
  EXPECT_EQ(curve.lowered, 1);
  EXPECT_THROW(curve_through({{0.1, -1}}), RunError);
  EXPECT_THROW(curve_through({}), RunError);
}

TEST(DragCurve, of_a_laid_slice_is_that_of_a_stage_that_drags)
{
  const settings::SpringsBeside drag{0.3, 0.2};
  const test::LaidSlice slice(test::line_case());
  const std::optional<DragCurve> curve = drag_sideways(slice.problem.model, slice.problem.state, 1500, drag, [] { return false; });
  ASSERT_TRUE(curve);
  EXPECT_NO_THROW(beam::check(beam::PlasticSpring{curve->backbone}));

  settings::Case c = test::line_case();
  c.pipeline.reset();
  settings::StageSettings& stage = c.stage.back();
  stage = {};
  stage.name = "drag";
  stage.kind = settings::StageKind::drag;
  stage.velocity = drag.velocity;
  stage.vertical = settings::Vertical::hold;
  stage.ramp = 0.1;
  stage.until.displacement = drag.travel;
  test::LaidSlice dragged(c);
  problem::State<2>& state = dragged.problem.state;
  const Real begin = state.rigid_bodies[0].displacement[0];
  // The work over three parts of the travel, each of several points of the curve.
  for (const auto& [from, to] : {std::pair(0.01, 0.06), {0.06, 0.15}, {0.15, 0.28}}) {
    Real work = 0, first = nan, last = nan, of_curve = 0;
    while (state.rigid_bodies[0].displacement[0] - begin < to) {
      const Real before = state.ledger.contact_sums[0].impulse[0];
      mpm::step(dragged.problem.model, state, dragged.workspace);
      const Real u = state.rigid_bodies[0].displacement[0] - begin;
      if (u < from) continue;
      if (std::isnan(first)) first = u - state.dt * state.rigid_bodies[0].velocity[0];
      work += (state.ledger.contact_sums[0].impulse[0] - before) * state.rigid_bodies[0].velocity[0];
      last = u;
    }
    constexpr int parts = 100;
    for (int k = 0; k < parts; ++k) of_curve += curve->backbone.force(first + (k + 0.5) / parts * (last - first)) / parts;
    EXPECT_NEAR(of_curve, work / (last - first), 0.03 * of_curve) << from << " m: lines between means of pieces of 20 mm, and another ramp";
  }
}

TEST(DragCurve, is_given_up_where_it_is_asked_to_stop)
{
  const test::LaidSlice slice(test::line_case());
  EXPECT_FALSE(drag_sideways(slice.problem.model, slice.problem.state, 1500, {0.3, 0.2}, [] { return true; }));
}

TEST(DragCurve, that_would_leave_the_mesh_is_refused)
{
  const test::LaidSlice slice(test::line_case());
  EXPECT_THROW(drag_sideways(slice.problem.model, slice.problem.state, 1500, {2, 2}, [] { return false; }), RunError);
}

}  // namespace
}  // namespace berm::slices::this_file
