// SPDX-License-Identifier: BSD-3-Clause
// Buckles of a hot pipe on a plane with friction against the solutions of Hobbs (1984), whose friction resists the displacement and not the motion.
#include "formulas/hobbs.hpp"
#include "samples/buckling_pipe.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

using namespace beam;
using formulas::HobbsBuckle, formulas::HobbsMode;

struct Mode {
  HobbsMode shape;
  bool antisymmetric, at_wall;  ///< a wall on one side keeps the lobes beside the first from growing
};

/// Where the iteration begins: waves of about Hobbs' length that shorten the line by as much as is fed in, and the line slid towards them so far that friction along it is in balance.
void guess_buckle(const Line& line, const Mode& mode, const HobbsBuckle& hobbs, const test::HotPipe& pipe, Real P, State& state)
{
  const Real end = hobbs.half_length, k = mode.at_wall ? pi / hobbs.lobe : std::sqrt(P / pipe.EI), missing = hobbs.constrained_force - P;
  const auto wave = [&](Real x) {
    const Real s = mode.antisymmetric ? std::sin(k * x) : std::cos(k * x);
    return x < end ? (mode.at_wall ? s * s : s * std::pow(std::cos(pi / 2 * x / end), 2)) : 0;
  };
  constexpr Real dx = 0.01;
  const auto slope = [&](Real x) { return (wave(x + dx / 2) - wave(x - dx / 2)) / dx; };
  Real shortening = 0;
  for (Real x = dx / 2; x < end; x += dx) shortening += std::pow(slope(x), 2) / 2 * dx;
  const Real size = std::sqrt(((missing * end + missing * missing / (2 * pipe.resistance())) / pipe.EA) / shortening);
  Real u = 0, x = 0;
  for (Index i = 0; i < line.nodes(); ++i) {
    for (; x < std::min(line.x[i], end); x += dx) u += (missing / pipe.EA - std::pow(size * slope(x + dx / 2), 2) / 2) * dx;
    const Real left = missing - pipe.resistance() * std::max(0.0, line.x[i] - end);
    if (line.x[i] > end) u = left > 0 ? -left * left / (2 * pipe.EA * pipe.resistance()) : 0;
    const Index v = line.across(Plane::lateral, i);
    if (line.held[line.axial(i)] == 0) state.displacement[line.axial(i)] = u;
    if (line.held[v] == 0) state.displacement[v] = size * wave(line.x[i]);
    if (line.held[v + 1] == 0) state.displacement[v + 1] = size * slope(line.x[i]);
  }
}

class HobbsModes : public testing::TestWithParam<Mode> {};

// Hobbs has rigid friction; here it is mobilised over a millimetre, against an amplitude of metres. His constants have four digits. The comparison is at the compression that the buckle has in the end, when waves along
// the line are some tenths of a percent of it, and what damping and inertia made friction lock in is a percent.
TEST_P(HobbsModes, of_a_hot_pipe_have_the_compression_amplitude_and_moment_of_the_theory)
{
  const Mode mode = GetParam();
  test::HotPipe pipe;
  Line line = test::bent_line(pipe, mode.antisymmetric, 0, 60, graded_nodes(1, 120, 1.1, 20, 3200));
  const std::vector<Real> lengths = lengths_of_nodes(line);
  const PlasticSpring friction = beam::friction(pipe.resistance(), pipe.mobilisation);
  add_springs(line, Direction::axial, friction, lengths);
  if (mode.at_wall) {  // there the line only goes away from the wall: friction against the motion is friction against the displacement
    add_springs(line, Direction::lateral, friction, lengths);
    add_springs(line, Direction::lateral, OneSidedSpring{1e7}, lengths);
  } else {
    add_springs(line, Direction::lateral, HolonomicSpring{friction.backbone}, lengths);
  }
  line.axial_where_sideways = false;
  // Friction would lock in the swing of the first seconds.
  line.damping[0] = mode.at_wall ? 3 : 1;
  constexpr Real first_P = 684e3, last_P = 380e3, dt = 0.02;
  const formulas::HotLine plane{pipe.EI, pipe.EA, pipe.resistance(), pipe.resistance()};
  const HobbsBuckle first = hobbs_buckle(mode.shape, plane, first_P), last = hobbs_buckle(mode.shape, plane, last_P);
  State state = state_of(line);
  Work work(line);
  Loads loads = no_loads(line);
  guess_buckle(line, mode, first, pipe, first_P, state);
  // Some seconds to settle; then heated further, so that all friction along the line is mobilised one way; then held.
  for (int i = 0; i < 1400; ++i) {
    const Real part = std::clamp((i - 200) / 1000., 0., 1.);
    std::fill(loads.constrained_force.begin(), loads.constrained_force.end(),
              first.constrained_force + part * (last.constrained_force - first.constrained_force));
    step(line, loads, dt, state, work);
  }
  const Real P = -effective_force(line, state, 0);
  const HobbsBuckle hobbs = hobbs_buckle(mode.shape, plane, P);
  const test::Crown crown = test::crown_of(line, state);
  EXPECT_NEAR(P, last_P, 0.02 * last_P);
  EXPECT_NEAR(loads.constrained_force[0], hobbs.constrained_force, 0.02 * hobbs.constrained_force);
  EXPECT_NEAR(crown.amplitude, hobbs.amplitude, 0.02 * hobbs.amplitude);
  EXPECT_NEAR(crown.moment, hobbs.moment, 0.05 * hobbs.moment);
}

INSTANTIATE_TEST_SUITE_P(All, HobbsModes,
                         testing::Values(Mode{HobbsMode::one, false, true}, Mode{HobbsMode::two, true, true},
                                         Mode{HobbsMode::three, false, false}, Mode{HobbsMode::four, true, false}),
                         [](const auto& mode) { return "mode_" + std::to_string(static_cast<int>(mode.param.shape) + 1); });

/// The largest displacement, its moment and the mean compression without the wave of a line between crests a half wave 2a apart, from EI v'''' + P v'' = -w, v'(0) = v'''(0) = 0, v(a) = v''(a) = 0, with a stress-free wave y0 cos(pi x/2a).
/// Hobbs' mode without end is the wave with v'(a) = 0.
struct Waves {
  Real amplitude, moment;
};
Waves exact_waves(const test::HotPipe& pipe, Real a, Real y0, Real P)
{
  const Real w = pipe.resistance(), k = std::sqrt(P / pipe.EI), q = pi / (2 * a), stiffness = pipe.EI * q * q;
  const Real A = -w / P / (k * k * std::cos(k * a)), B = -w / (2 * P), grown = y0 * stiffness / (stiffness - P);
  return {std::abs(A - A * std::cos(k * a) - B * a * a + grown), std::abs(pipe.EI * (-A * k * k + 2 * B - (grown - y0) * q * q))};
}

// The wave moves one way, so that friction against the motion is friction against the displacement. Friction is mobilised over a millimetre, and elements of a metre have the moment to (h/a)^2/12.
TEST(HobbsWaves, without_end_have_the_amplitude_and_moment_of_the_exact_solution)
{
  constexpr Real a = 30, y0 = 0.2;
  const test::HotPipe pipe;
  Line line = straight_line(graded_nodes(1, a, 1, 1, a), pipe.section(), {Plane::lateral});
  set_shape(
      line, Plane::lateral, [=](Real x) { return y0 * std::cos(pi * x / (2 * a)); },
      [=](Real x) { return -y0 * pi / (2 * a) * std::sin(pi * x / (2 * a)); });
  hold(line, 0, EndCondition::symmetric);
  hold(line, line.nodes() - 1, EndCondition::pinned);
  add_springs(line, Direction::lateral, friction(pipe.resistance(), pipe.mobilisation), lengths_of_nodes(line));
  State state = state_of(line);
  Work work(line);
  Loads loads = no_loads(line);
  for (int i = 1; i <= 2000; ++i) {
    std::fill(loads.constrained_force.begin(), loads.constrained_force.end(), 3e6 * i / 2000);
    step(line, loads, 0.02, state, work);
  }
  const Real P = -effective_force(line, state, 0);
  const Waves exact = exact_waves(pipe, a, y0, P);
  const test::Crown crown = test::crown_of(line, state);
  EXPECT_GT(crown.amplitude, 5 * y0);
  EXPECT_NEAR(crown.amplitude, exact.amplitude, 0.005 * exact.amplitude);
  EXPECT_NEAR(crown.moment, exact.moment, 0.005 * exact.moment);
}

}  // namespace
}  // namespace berm::this_file
