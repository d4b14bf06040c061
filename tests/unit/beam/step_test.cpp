// SPDX-License-Identifier: BSD-3-Clause
#include "beam/step.hpp"

#include "samples/buckling_pipe.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

namespace berm::beam::this_file {
std::size_t requests = 0;  ///< for memory, of this program
}

// All of this program's. They are not inlined, for the compiler would say that new and free do not match.
[[gnu::noinline]] void* operator new(std::size_t size)
{
  ++berm::beam::this_file::requests;
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept
{
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace berm::beam::this_file {
namespace {

/// A hot pipe on friction with an imperfection, both planes, on a bed.
struct Hot {
  Line line;
  State state;
  Work work;
  Loads loads;

  explicit Hot(bool axial_where_sideways = true)
      : line(made(axial_where_sideways)),
        state(state_of(line)),
        work(line),
        loads(no_loads(line))
  {
    add_weight(line, loads);
    find_equilibrium(line, loads, state, work);
  }
  static Line made(bool axial_where_sideways)
  {
    const test::HotPipe pipe;
    Line line = straight_line(graded_nodes(1, 60, 1.1, 4, 300), pipe.section(), {Plane::lateral, Plane::vertical});
    set_shape(
        line, Plane::lateral, [](Real x) { return x < 30 ? 0.2 * (1 + std::cos(pi * x / 30)) : 0; },
        [](Real x) { return x < 30 ? -0.2 * pi / 30 * std::sin(pi * x / 30) : 0; });
    hold(line, 0, EndCondition::symmetric);
    hold(line, line.nodes() - 1, EndCondition::clamped);
    const std::vector<Real> lengths = lengths_of_nodes(line);
    add_springs(line, Direction::axial, friction(pipe.resistance(), 1e-3), lengths);
    add_springs(line, Direction::lateral, friction(pipe.resistance(), 1e-3), lengths);
    add_springs(line, Direction::vertical, OneSidedSpring{pipe.weight / 0.02}, lengths);
    line.held[line.across(Plane::vertical, line.nodes() - 1)] = 0;
    line.axial_where_sideways = axial_where_sideways;
    return line;
  }
  /// Steps of 0.02 s, each of which heats by 2 kN.
  void heat(int steps)
  {
    for (int i = 0; i < steps; ++i) {
      for (Real& force : loads.constrained_force) force += 2e3;
      step(line, loads, 0.02, state, work);
    }
  }
  Index crown() const { return line.across(Plane::lateral, 0); }
};

TEST(Step, lets_a_hot_pipe_buckle_where_its_imperfection_is)
{
  Hot hot;
  hot.heat(800);
  EXPECT_GT(hot.state.displacement[hot.crown()], 1);
  EXPECT_NEAR(hot.state.time, 16, 1e-9);
}

TEST(Step, allocates_nothing)
{
  Hot hot;
  const std::size_t before = requests;
  hot.heat(200);
  EXPECT_EQ(requests, before);
  EXPECT_GT(before, 0u) << "they are counted";
}

// Without springs the line is held by nothing along x.
TEST(Step, of_a_line_that_nothing_holds_says_so)
{
  Line line = straight_line({0, 1, 2}, {1e6, 1e8, 100, 100, 0, 0.2}, {Plane::lateral});
  State state = state_of(line);
  Work work(line);
  Loads loads = no_loads(line);
  loads.force[line.axial(1)] = 1;
  try {
    find_equilibrium(line, loads, state, work);
    FAIL() << "there is no equilibrium";
  } catch (const NoEquilibrium& refused) {
    const std::string words = refused.what();
    EXPECT_NE(words.find("singular"), std::string::npos) << words;
    EXPECT_NE(words.find("node 1 at x = 1 m"), std::string::npos) << words;
  }
  EXPECT_NO_THROW(step(line, loads, 0.1, state, work)) << "its inertia holds it";
}

// Heat at once, without inertia, far beyond the snap; the state is left as it was, and smaller steps with inertia go on.
TEST(Step, that_finds_no_equilibrium_leaves_the_state_as_it_was_and_a_smaller_one_may_find_it)
{
  Hot hot;
  hot.heat(300);
  const State before = hot.state;
  Loads nonsense = hot.loads;
  nonsense.force[hot.crown()] = nan;
  EXPECT_THROW(step(hot.line, nonsense, 0.02, hot.state, hot.work), NoEquilibrium);
  EXPECT_EQ(before.displacement, hot.state.displacement);
  EXPECT_EQ(before.velocity, hot.state.velocity);
  EXPECT_EQ(before.time, hot.state.time);
  EXPECT_EQ(before.totals.work_of_heat, hot.state.totals.work_of_heat);
  for (std::size_t s = 0; s < before.springs.size(); ++s) EXPECT_EQ(before.springs[s].slip, hot.state.springs[s].slip);
  EXPECT_NO_THROW(hot.heat(1));
}

// A line that moves in both planes but is loaded in one gives what a line of that plane gives.
TEST(Step, of_one_plane_is_that_of_both_where_the_other_is_at_rest)
{
  const auto crown = [](std::vector<Plane> planes) {
    const test::HotPipe pipe;
    Line line = straight_line(graded_nodes(1, 30, 1, 1, 30), pipe.section(), std::move(planes));
    hold(line, 0, EndCondition::symmetric);
    hold(line, line.nodes() - 1, EndCondition::pinned);
    State state = state_of(line);
    Work work(line);
    Loads loads = no_loads(line);
    for (Index e = 0; e < line.elements(); ++e) add_load(line, Plane::lateral, e, 900, loads);
    for (int i = 0; i < 40; ++i) step(line, loads, 0.05, state, work);
    return state.displacement[line.across(Plane::lateral, 0)];
  };
  const Real one = crown({Plane::lateral}), both = crown({Plane::lateral, Plane::vertical});
  EXPECT_NEAR(one, both, 1e-9 * one);
  EXPECT_GT(one, 0.01);
}

// A reaction that belongs to the velocity of the step before: with the impedance m/dt a free node goes half as fast in a step.
TEST(Step, an_impedance_resists_a_change_of_velocity)
{
  Line line = straight_line({0, 1}, {0, 0, 100, 100, 0, 0.2}, {Plane::lateral});
  for (Index i = 0; i < line.freedoms(); ++i) line.held[i] = i != line.axial(1);
  line.section[0].axial_stiffness = 1e-6;
  const auto velocity = [&](Real impedance, Real then) {
    State state = state_of(line);
    Work work(line);
    Loads loads = no_loads(line);
    loads.force[line.axial(1)] = 10;
    loads.impedance[line.axial(1)] = impedance, loads.velocity_then[line.axial(1)] = then;
    step(line, loads, 0.1, state, work);
    return state.velocity[line.axial(1)];
  };
  const Real mass = 100. / 3, free = velocity(0, 0), damping = 1e3;
  EXPECT_NEAR(free, 0.55 * 0.1 * 10 / mass, 1e-9);
  EXPECT_NEAR(velocity(damping, 0), free / (1 + 0.55 * 0.1 * damping / mass), 1e-9);
  EXPECT_NEAR(velocity(damping, free), free, 1e-9);
}

TEST(Step, friction_along_the_line_is_off_where_it_slides_sideways)
{
  Hot everywhere(true), off(false);
  everywhere.heat(800), off.heat(800);
  EXPECT_EQ(std::count(everywhere.state.sideways.begin(), everywhere.state.sideways.end(), 1), 0);
  EXPECT_EQ(off.state.sideways[5], 1) << "in the buckle";
  EXPECT_EQ(off.state.springs[5].origin, off.state.displacement[off.line.axial(5)]) << "where friction begins anew";
  EXPECT_EQ(off.state.sideways[off.line.nodes() - 5], 0) << "far from it";
  EXPECT_GT(off.state.displacement[off.crown()], everywhere.state.displacement[everywhere.crown()]);
}

// What holds such a line sideways is with the caller; here nothing does.
TEST(Step, a_node_without_a_lateral_spring_slides_sideways_where_it_goes_so_five_times_as_far)
{
  for (const Real along : {0., 1., 3.}) {
    Line line = straight_line({0, 1}, {0, 0, 100, 100, 0, 0.2}, {Plane::lateral});
    line.section[0].axial_stiffness = 1e-6;
    add_springs(line, Direction::axial, friction(1, 1e-6), lengths_of_nodes(line));
    line.axial_where_sideways = false;
    for (Index i = 0; i < 2; ++i) line.held[line.across(Plane::lateral, i) + 1] = 1;
    State state = state_of(line);
    Work work(line);
    Loads loads = no_loads(line);
    for (Index i = 0; i < 2; ++i) loads.force[line.across(Plane::lateral, i)] = 100, loads.force[line.axial(i)] = along * 10;
    for (int i = 0; i < 100; ++i) step(line, loads, 0.01, state, work);
    EXPECT_EQ(state.sideways[1], along < 2) << along;
  }
}

// A spring that stands for nothing, as under a slice that is soil, holds by its state for ever; the node goes where it goes.
TEST(Step, a_lateral_spring_of_factor_0_does_not_decide_whether_the_line_slides_sideways)
{
  for (const Real factor : {0., 1.}) {
    Line line = straight_line({0, 1}, {0, 0, 100, 100, 0, 0.2}, {Plane::lateral});
    line.section[0].axial_stiffness = 1e-6;
    add_springs(line, Direction::lateral, friction(1e3, 1e3), lengths_of_nodes(line));
    add_springs(line, Direction::axial, friction(1, 1e-6), lengths_of_nodes(line));
    line.axial_where_sideways = false;
    for (Index i = 0; i < 2; ++i) line.held[line.across(Plane::lateral, i) + 1] = 1;
    State state = state_of(line);
    std::fill(state.spring_factor.begin(), state.spring_factor.end(), factor);
    Work work(line);
    Loads loads = no_loads(line);
    for (Index i = 0; i < 2; ++i) loads.force[line.across(Plane::lateral, i)] = 100;
    for (int i = 0; i < 100; ++i) step(line, loads, 0.01, state, work);
    EXPECT_EQ(state.sideways[1], factor == 0) << "far from its resistance, at " << state.displacement[line.across(Plane::lateral, 1)]
                                              << " m of 1 km";
  }
}

}  // namespace
}  // namespace berm::beam::this_file
