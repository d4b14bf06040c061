// SPDX-License-Identifier: BSD-3-Clause
#include "slices/coupled_line.hpp"

#include "samples/laid_slice.hpp"

#include "os/threads.hpp"
#include <gtest/gtest.h>
#include <memory>

namespace berm::slices::this_file {
namespace {

using test::built_slice;

/// A line on its slices, stepped without files.
struct LineRun {
  explicit LineRun(const settings::Case& c) : problem(built_slice(c)), workspace(problem.model, problem.state), line(c, problem.model)
  {
    while (problem.model.stages[problem.state.stage.index].kind != settings::StageKind::pipeline) {
      mpm::step(problem.model, problem.state, workspace);
      if (stage_ended(problem.model, problem.state)) next_stage();
    }
    line.couple(problem.state);
    line.begin_stage(problem.state);
  }
  void next_stage()
  {
    ++problem.state.stage.index;
    begin_stage(problem.model, problem.state);
  }
  void step()
  {
    line.step(problem.state, workspace, [&] { mpm::step(problem.model, problem.state, workspace); });
  }
  Vec<2> pipe(std::size_t k) const { return (k == 0 ? problem.state : line.slice(k)).rigid_bodies[0].displacement; }

  problem::Problem<2> problem;
  mpm::Workspace<2> workspace;
  CoupledLine line;
};

TEST(CoupledLine, that_hardly_bends_moves_as_one_pipe_of_its_mass_under_the_same_force)
{
  LineRun run(test::line_case());
  const Vec<2> laid = run.pipe(0);
  while (!stage_ended(run.problem.model, run.problem.state)) run.step();

  settings::Case c = test::line_case();
  c.pipeline.reset();
  c.mpm.courant = 0.5;  // as a line has it
  settings::StageSettings& alone = c.stage.back();
  alone.kind = settings::StageKind::drive;
  alone.drive.x.force = *alone.pipeline.lateral;
  alone.drive.y.force = -1500;
  problem::Problem<2> problem = built_slice(c);
  mpm::Workspace<2> workspace(problem.model, problem.state);
  for (;;) {
    mpm::step(problem.model, problem.state, workspace);
    if (!stage_ended(problem.model, problem.state)) continue;
    if (problem.state.stage.index + 1 == static_cast<Index>(c.stage.size())) break;
    ++problem.state.stage.index;
    begin_stage(problem.model, problem.state);
  }
  const Vec<2> expected = problem.state.rigid_bodies[0].displacement - laid;
  EXPECT_GT(expected[0], 0.1) << "it has broken out";
  for (std::size_t k = 0; k < run.line.count(); ++k) {
    EXPECT_NEAR((run.pipe(k) - laid)[0], expected[0], 0.005 * expected[0]) << "slice " << k << ": the soil's force is one step late";
    EXPECT_NEAR((run.pipe(k) - laid)[1], expected[1], 0.005 * expected[0]) << "slice " << k;
  }
}

TEST(CoupledLine, has_the_same_bits_on_threads)
{
  const auto moved = [](int count) {
    const Threads threads(count);
    LineRun run(test::line_case());
    for (int k = 0; k < 200; ++k) run.step();
    return std::pair{run.line.state().displacement, run.problem.state.ledger.totals.internal};
  };
  const auto one = moved(1);
  EXPECT_EQ(one, moved(2));
  EXPECT_GT(*std::max_element(one.first.begin(), one.first.end()), 0);
}

TEST(CoupledLine, moves_each_pipe_as_the_line_goes)
{
  LineRun run(test::line_case());
  const Vec<2> laid = run.pipe(0);
  for (int k = 0; k < 100; ++k) run.step();
  const LineOfCase& of = run.line.of_case();
  std::vector<Real> lateral(run.line.count()), vertical(run.line.count());
  of.stations.means(of.line, beam::Direction::lateral, run.line.state().displacement, lateral);
  of.stations.means(of.line, beam::Direction::vertical, run.line.state().displacement, vertical);
  std::vector<Real> shape(run.line.count());
  of.stations.means(of.line, beam::Direction::lateral, of.line.shape, shape);
  for (std::size_t k = 0; k < run.line.count(); ++k) {
    EXPECT_NEAR((run.pipe(k) - laid)[0], lateral[k] - shape[k], 1e-12) << "sums of a hundred steps";
    EXPECT_NEAR((run.pipe(k) - laid)[1], vertical[k], 1e-12);
  }
}

/// A line that bends within its slices, bent by 0.1 m at rest and pressed along.
settings::Case soft_line()
{
  settings::Case c = test::line_case();
  c.pipeline->bending_stiffness = 1e4;
  c.pipeline->axial_stiffness = 1e6;
  c.pipeline->expansion = 1e-4;
  c.pipeline->imperfection = {0.1, 5};
  c.stage.back().pipeline.temperature = 100;
  return c;
}

TEST(CoupledLine, replays_each_slice_in_a_single_problem_to_the_bit)
{
  LineRun run(soft_line());
  struct Alone {
    problem::State<2> state;
    mpm::Workspace<2> workspace;
  };
  std::vector<std::unique_ptr<Alone>> alone;
  for (std::size_t k = 0; k < run.line.count(); ++k)
    alone.push_back(std::unique_ptr<Alone>(new Alone{run.problem.state, mpm::Workspace<2>(run.problem.model, run.problem.state)}));
  for (int step = 0; step < 400; ++step) {
    run.step();
    for (std::size_t k = 0; k < alone.size(); ++k) {
      const bodies::RigidState<2>& driven = (k == 0 ? run.problem.state : run.line.slice(k)).rigid_bodies[0];
      drive_otherwise(run.problem.model, alone[k]->state, 0, false, driven.velocity[0]);
      drive_otherwise(run.problem.model, alone[k]->state, 1, false, driven.velocity[1]);
      alone[k]->state.max_dt = run.problem.state.dt;
      mpm::step(run.problem.model, alone[k]->state, alone[k]->workspace);
    }
  }
  for (std::size_t k = 0; k < alone.size(); ++k) {
    const problem::State<2>& slice = k == 0 ? run.problem.state : run.line.slice(k);
    EXPECT_EQ(alone[k]->state.time, slice.time) << k;
    EXPECT_EQ(alone[k]->state.rigid_bodies[0].displacement, slice.rigid_bodies[0].displacement) << k;
    EXPECT_EQ(alone[k]->state.ledger.contact_sums[0].impulse, slice.ledger.contact_sums[0].impulse) << k;
    EXPECT_EQ(alone[k]->state.ledger.totals.internal, slice.ledger.totals.internal) << k;
    if (k > 0) {
      EXPECT_NE(slice.rigid_bodies[0].displacement, run.pipe(k - 1)) << "no slice goes as another, " << k;
    }
  }
}

/// Pushed sideways by 300 N/m, on springs that resist to 600.
settings::Case line_on_springs(settings::SliceAsSpring as_spring)
{
  settings::Case c = test::line_case();
  c.pipeline->slices.as_spring = as_spring;
  c.pipeline->far_soil.friction = 0.4;
  c.pipeline->far_soil.mobilisation = 5e-3;
  return c;
}

TEST(CoupledLine, resolves_slices_before_their_springs_slide)
{
  LineRun run(line_on_springs(settings::SliceAsSpring::until_sliding));
  EXPECT_FALSE(run.line.is_spring(0)) << "the first is where the crown is";
  for (std::size_t k = 1; k < run.line.count(); ++k) EXPECT_TRUE(run.line.is_spring(k));
  const BigIndex laid = run.line.slice(1).step;
  const Real internal = run.line.slice(1).ledger.totals.internal;
  for (;;) {
    run.step();
    if (!run.line.is_spring(1)) break;
    ASSERT_EQ(run.line.slice(1).ledger.totals.internal, internal) << "its soil waits";
  }
  const Real lateral = run.line.loads_at(run.problem.state, run.problem.state.time).lateral;
  EXPECT_GT(lateral, 0.2 * 600);
  EXPECT_LT(lateral, 0.6 * 600);
  EXPECT_NE(run.line.slice(1).ledger.totals.internal, internal);
  EXPECT_GT(run.line.slice(1).step, laid);
  while (!stage_ended(run.problem.model, run.problem.state)) run.step();
  // The springs have lost it less than they may move, and what they carried when they gave way.
  LineRun awake(line_on_springs(settings::SliceAsSpring::never));
  while (!stage_ended(awake.problem.model, awake.problem.state)) awake.step();
  EXPECT_GT(awake.pipe(1)[0], 0.1) << "it has broken out";
  EXPECT_NEAR(run.pipe(1)[0], awake.pipe(1)[0], 0.02 * awake.pipe(1)[0] + 5e-3);
}

TEST(CoupledLine, lies_on_springs_alone_where_no_slice_wakes)
{
  settings::Case c = line_on_springs(settings::SliceAsSpring::always);
  c.stage.back().pipeline.lateral = 300;
  LineRun run(c);
  const Real internal = run.problem.state.ledger.totals.internal, x = run.pipe(0)[0];
  while (!stage_ended(run.problem.model, run.problem.state)) run.step();
  EXPECT_EQ(run.problem.state.ledger.totals.internal, internal) << "no soil is stepped";
  // Elastic springs of 600 N/m over 5 mm; the load came up in a second, many times their period of 0.3 s.
  for (std::size_t k = 0; k < run.line.count(); ++k) EXPECT_NEAR(run.pipe(k)[0] - x, 2.5e-3, 0.2 * 2.5e-3) << k;
}

// Hot at one end and cold at the other, between a free end and one on a spring: it gets longer by P0 of the middle, less what the spring holds back.
TEST(CoupledLine, pushes_the_spring_at_its_end_as_it_gets_warm)
{
  settings::Case c = line_on_springs(settings::SliceAsSpring::always);
  settings::PipelineSettings& p = *c.pipeline;
  p.half = settings::LineHalf::symmetric;
  p.end = settings::LineEnd::spring;
  p.end_stiffness = 1e8;
  p.expansion = 1e-5;
  c.stage.back().pipeline = {};
  c.stage.back().pipeline.temperature = 100;
  c.stage.back().pipeline.far_temperature = 0;
  LineRun run(c);
  while (!stage_ended(run.problem.model, run.problem.state)) run.step();
  const LineOfCase& of = run.line.of_case();
  const Real EA = 1e9, L = 3, mean = EA * 1e-5 * 50, expected = mean / (EA / L + 1e8);
  EXPECT_NEAR(run.line.state().displacement[of.line.axial(of.line.nodes() - 1)], expected, 0.02 * expected)
      << "it swings along for 5 ms a time, and Newmark's step takes most of it";
}

TEST(CoupledLine, lays_the_pipe_by_itself_where_the_soil_is_another)
{
  settings::Case stiff = test::line_case({"material.clay.cohesion=\"4 kPa\""});
  LineRun other(stiff);
  const Real deep = LineRun(test::line_case()).pipe(0)[1], shallow = other.pipe(0)[1];
  ASSERT_GT(shallow, 0.7 * deep) << "half as deep";
  problem::Problem<2> problem = built_slice(test::line_case());
  mpm::Workspace<2> workspace(problem.model, problem.state);
  CoupledLine line(test::line_case(), problem.model);
  for (std::size_t k = 2; k < line.count(); ++k) line.give_soil(k, other.problem.model, other.problem.state);
  while (problem.model.stages[problem.state.stage.index].kind != settings::StageKind::pipeline) {
    mpm::step(problem.model, problem.state, workspace);
    if (!stage_ended(problem.model, problem.state)) continue;
    ++problem.state.stage.index;
    begin_stage(problem.model, problem.state);
  }
  line.couple(problem.state);
  line.begin_stage(problem.state);
  EXPECT_EQ(line.slice(1).rigid_bodies[0].displacement[1], deep);
  EXPECT_EQ(line.slice(2).rigid_bodies[0].displacement[1], shallow);
  while (!stage_ended(problem.model, problem.state))
    line.step(problem.state, workspace, [&] { mpm::step(problem.model, problem.state, workspace); });
  // The line hardly bends: all pipes go as far, in soils that push back with forces of their own.
  EXPECT_NEAR(line.slice(2).rigid_bodies[0].displacement[0], line.slice(1).rigid_bodies[0].displacement[0], 1e-3);
  EXPECT_GT(std::abs(line.slice(2).ledger.contact_sums[0].impulse[0] / line.slice(1).ledger.contact_sums[0].impulse[0] - 1), 0.01);
}

TEST(CoupledLine, lighter_than_the_soil_that_it_moves_does_not_shake)
{
  settings::Case c = test::line_case();
  c.pipeline->mass = 4;
  LineRun run(c);
  Real fastest = 0, heaviest = 0;
  while (run.problem.state.time - run.problem.state.stage.begin_time < 0.3) {
    run.step();
    for (std::size_t k = 0; k < run.line.count(); ++k) {
      fastest = std::max(fastest, (k == 0 ? run.problem.state : run.line.slice(k)).rigid_bodies[0].velocity.norm());
      heaviest = std::max(heaviest, run.line.forces()[k].contact_mass);
    }
  }
  EXPECT_GT(heaviest, 10 * 4) << "a reaction that is a step late would not be stable";
  EXPECT_LT(fastest, 0.3) << "300 N/m have not moved the pipe from its place";
}

}  // namespace
}  // namespace berm::slices::this_file
