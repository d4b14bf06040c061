// SPDX-License-Identifier: BSD-3-Clause
#include "beam/answers.hpp"

#include "beam/step.hpp"

#include <gtest/gtest.h>

namespace berm::beam::this_file {
namespace {

constexpr Real EI = 2e6, length = 8, force = 1e3;

/// A cantilever that a force bends upwards at its tip.
struct Bent {
  Line line;
  State state;

  Bent() : line(straight_line(graded_nodes(0.5, length, 1, 0.5, length), {EI, 1e9, 100, 100, 0, 0.2}, {Plane::lateral, Plane::vertical}))
  {
    hold(line, 0, EndCondition::clamped);
    state = state_of(line);
    Work work(line);
    Loads loads = no_loads(line);
    loads.force[line.across(Plane::vertical, line.nodes() - 1)] = force;
    find_equilibrium(line, loads, state, work);
  }
};

// M = F (L - x), shear -F; the deflection of 0.085 m makes second-order effects of a hundredth of a percent.
TEST(Answers, of_a_cantilever_are_its_moments_and_shear)
{
  const Bent bent;
  for (Index i = 0; i < bent.line.nodes(); ++i) {
    EXPECT_NEAR(moment(bent.line, bent.state, Plane::vertical, i), force * (length - bent.line.x[i]), 1e-3 * force * length);
    EXPECT_NEAR(curvature(bent.line, bent.state, Plane::vertical, i), force * (length - bent.line.x[i]) / EI, 1e-3 * force * length / EI);
    EXPECT_EQ(moment(bent.line, bent.state, Plane::lateral, i), 0);
  }
  for (Index e = 0; e < bent.line.elements(); ++e) EXPECT_NEAR(shear(bent.line, bent.state, Plane::vertical, e), -force, 1e-3 * force);
  EXPECT_NEAR(largest_slope(bent.line, bent.state), force * length * length / (2 * EI), 1e-3 * force * length * length / (2 * EI));
}

TEST(Answers, the_strain_of_the_outermost_fibres_is_that_of_both_planes_and_of_the_membrane)
{
  Bent bent;
  const FibreStrain one = longitudinal_strain(bent.line, bent.state, 0);
  EXPECT_NEAR(one.largest, 0.2 * force * length / EI, 1e-3 * 0.2 * force * length / EI);
  EXPECT_NEAR(one.smallest, -one.largest, 1e-9);
  for (Index i = 0; i < bent.line.nodes(); ++i) {
    for (const Index k : {0, 1})
      bent.state.displacement[bent.line.across(Plane::lateral, i) + k] = bent.state.displacement[bent.line.across(Plane::vertical, i) + k];
    bent.state.displacement[bent.line.axial(i)] = 1e-3 * bent.line.x[i];
  }
  const FibreStrain both = longitudinal_strain(bent.line, bent.state, 0);
  EXPECT_NEAR((both.largest - both.smallest) / (one.largest - one.smallest), std::sqrt(2), 1e-9);
  EXPECT_NEAR((both.largest + both.smallest) / 2, 1e-3 + 2e-6, 1e-5);
  EXPECT_NEAR(effective_force(bent.line, bent.state, 0), 1e9 * (both.largest + both.smallest) / 2, 1);
}

TEST(Answers, the_crown_is_where_the_line_has_gone_sideways_most_to_either_side)
{
  Bent bent;
  bent.state.displacement[bent.line.across(Plane::lateral, 3)] = 0.1;
  bent.state.displacement[bent.line.across(Plane::lateral, 7)] = -0.2;
  EXPECT_EQ(crown(bent.line, bent.state), 7);
  Real largest = 0;
  for (Index i = 0; i < bent.line.nodes(); ++i) largest = std::max(largest, std::abs(moment(bent.line, bent.state, Plane::lateral, i)));
  EXPECT_EQ(largest_moment(bent.line, bent.state), largest);
  EXPECT_GT(largest, 0);
}

// A line that lies in its shape is not bent.
TEST(Answers, of_a_line_in_its_shape_are_zero)
{
  Line line = straight_line({0, 1, 2}, {EI, 1e9, 100, 100, 0, 0.2}, {Plane::lateral});
  set_shape(
      line, Plane::lateral, [](Real x) { return 0.1 * x * x; }, [](Real x) { return 0.2 * x; });
  const State state = state_of(line);
  EXPECT_EQ(moment(line, state, Plane::lateral, 1), 0);
  EXPECT_EQ(effective_force(line, state, 0), 0);
  EXPECT_NEAR(largest_slope(line, state), 0.4, 1e-12);
}

}  // namespace
}  // namespace berm::beam::this_file
