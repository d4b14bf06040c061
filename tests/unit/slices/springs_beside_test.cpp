// SPDX-License-Identifier: BSD-3-Clause
#include "slices/springs_beside.hpp"

#include "samples/laid_slice.hpp"

#include <gtest/gtest.h>

namespace berm::slices::this_file {
namespace {

/// A line that bends between its slices, on springs with a curve.
settings::Case soft_case()
{
  settings::Case c = test::line_case({"pipeline.length=\"30 m\"", "pipeline.bending_stiffness=\"1e5 N m^2\""});
  settings::FarSoil& soil = c.pipeline->far_soil;
  soil.lateral.x = {0.01, 0.05};
  soil.lateral.y = {600, 900};
  soil.axial_friction = 0.5;
  return c;
}

TEST(LineOnSprings, moves_as_a_beam_on_these_springs)
{
  const settings::Case c = soft_case();
  LineOnSprings line(c, 0);
  const LineOfCase& of = line.of_case();
  beam::Line alone = beam::straight_line(of.line.x, of.line.section.front(), {beam::Plane::lateral, beam::Plane::vertical});
  alone.shape = of.line.shape;
  alone.axial_where_sideways = false;
  beam::hold(alone, 0, beam::EndCondition::symmetric);
  const std::vector<Real> all = beam::lengths_of_nodes(alone);
  beam::add_springs(alone, beam::Direction::lateral, beam::PlasticSpring{{{{0.01, 600}, {0.05, 900}}}}, all);
  beam::add_springs(alone, beam::Direction::axial, beam::friction(750, 2e-3), all);
  beam::add_springs(alone, beam::Direction::vertical, beam::LinearSpring{1500 / 0.004}, all, 0.004);  // pressed by the weight as it is laid
  beam::State state = beam::state_of(alone);
  beam::Work work(alone);
  constexpr Real dt = 0.01;
  constexpr int steps = 200;
  for (int k = 1; k <= steps; ++k) {
    LineLoads now = of.laid();
    now.lateral = 1000.0 * k / steps;
    line.step(now, dt);
    beam::Loads loads = beam::no_loads(alone);
    for (Index e = 0; e < alone.elements(); ++e) loads.constrained_force[e] = of.constrained_force(now, 0);
    for (Index i = 0; i < alone.nodes(); ++i) {
      loads.force[alone.across(beam::Plane::lateral, i)] = now.lateral * all[i];
      loads.force[alone.across(beam::Plane::vertical, i)] = -1500 * all[i];
    }
    beam::step(alone, loads, dt, state, work);
  }
  const Index node = alone.nodes() / 2;
  EXPECT_GT(state.displacement[alone.across(beam::Plane::lateral, node)], 0.05) << "its springs slide";
  for (Index i = 0; i < alone.freedoms(); ++i)
    EXPECT_NEAR(line.state().displacement[i], state.displacement[i], 1e-7) << "to the iterations' tolerance, " << i;
}

TEST(LineOnSprings, goes_as_far_by_a_load_history_as_by_two_ramps_to_the_bit)
{
  const settings::Case c = soft_case();
  settings::StageSettings to, fro, both;
  for (settings::StageSettings* stage : {&to, &fro, &both}) stage->kind = settings::StageKind::pipeline;
  to.ramp = fro.ramp = 1, to.until.time = fro.until.time = 1.5, both.until.time = 3;
  to.pipeline.lateral = 1000, fro.pipeline.lateral = -250;
  both.load_times = {0, 1, 1.5, 2.5, 3};
  both.loads.of("lateral") = {0, 1000, 1000, -250, -250};
  LineOnSprings by_ramps(c), by_history(c);
  const LineLoads laid = by_ramps.of_case().laid(), between = end_of(to, laid);
  constexpr Real dt = 1.0 / 64;  // whose multiples have no round-off
  for (Real time = dt; time <= 3; time += dt) {
    by_ramps.step(time <= 1.5 ? loads_in(to, laid, time) : loads_in(fro, between, time - 1.5), dt);
    by_history.step(loads_in(both, laid, time), dt);
  }
  EXPECT_EQ(by_ramps.state().displacement, by_history.state().displacement);
  EXPECT_NE(by_ramps.state().displacement, by_ramps.of_case().line.shape);
}

TEST(LineOnSprings, has_the_resistance_along_it_of_its_interface_as_it_was_laid)
{
  settings::Case c = soft_case();
  c.pipeline->far_soil.axial_angle = 0.4;
  const LineOnSprings line(c, 0.2);
  const LineOfCase& of = line.of_case();
  int found = 0;
  for (std::size_t s = 0; s < of.line.springs.size(); ++s) {
    const beam::Spring& spring = of.line.springs[s];
    const bool axial = spring.freedom == of.line.axial(spring.node);
    EXPECT_NEAR(line.state().spring_factor[s], axial ? 4 / pi * std::tan(0.4) : 1, 1e-9) << "over a friction of 1, wedged, buried to half";
    found += axial;
  }
  EXPECT_EQ(found, of.line.nodes());
}

TEST(SpringsBeside, have_the_resistance_of_a_drag_in_the_laid_slice_also_where_it_was_given_up_once)
{
  settings::Case c = test::line_case();
  c.pipeline->springs = settings::SpringsBeside{0.1, 0.2};
  const test::LaidSlice slice(c);
  SpringsBeside springs(c), stopped(c);
  const problem::Model<2>& model = slice.problem.model;
  const problem::State<2>& state = slice.problem.state;
  ASSERT_TRUE(springs.find(model, state, [] { return false; }));
  EXPECT_FALSE(stopped.find(model, state, [&, calls = 0]() mutable { return ++calls == 10; }));
  EXPECT_FALSE(stopped.ready());
  ASSERT_TRUE(stopped.find(model, state, [] { return false; }));
  ASSERT_EQ(springs.curve().points.size(), stopped.curve().points.size());
  for (std::size_t k = 0; k < springs.curve().points.size(); ++k)
    EXPECT_EQ(springs.curve().points[k].force, stopped.curve().points[k].force);
  const beam::Line& line = springs.line().of_case().line;
  const auto& lateral = std::get<beam::PlasticSpring>(line.laws.front());
  EXPECT_EQ(lateral.backbone.force(0.05), springs.curve().force(0.05));
  EXPECT_GT(lateral.backbone.force(0.05), 300) << "clay of 2 kPa";
}

TEST(SpringsBeside, of_a_pipe_without_a_mass_are_refused)
{
  settings::Case c = test::line_case();
  c.pipeline->springs = settings::SpringsBeside{0.1, 0.2};
  c.pipeline->mass = 330;
  c.rigid.front().second.mass = 0;
  EXPECT_THROW(SpringsBeside{c}, KeyError);
}

}  // namespace
}  // namespace berm::slices::this_file
