// SPDX-License-Identifier: BSD-3-Clause
#include "beam/spring_laws.hpp"

#include "os/error.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::beam::this_file {
namespace {

constexpr Real limit = 900, mobilisation = 1e-3;
const Backbone peak_and_berm = {{{0.005, 700}, {0.03, 900}, {0.1, 600}, {0.5, 800}}};

/// Goes to each displacement in small steps; the force in the end.
Real go(const SpringLaw& law, SpringState& state, std::vector<Real> places)
{
  Real u = state.origin;
  for (const Real to : places) {
    const Real from = u;
    for (int i = 1; i <= 100; ++i) {
      u = from + (to - from) * i / 100;
      state = accepted(law, state, u);
    }
  }
  return force_of(law, state, u).force;
}

TEST(Friction, is_elastic_then_slides_and_opposes_the_motion)
{
  const SpringLaw law = friction(limit, mobilisation);
  SpringState state;
  EXPECT_NEAR(go(law, state, {mobilisation / 2}), limit / 2, 1e-9);
  EXPECT_NEAR(go(law, state, {1}), limit, 1e-9);
  SpringState back = state;
  EXPECT_NEAR(go(law, back, {1, 0.5}), -limit, 1e-9) << "at half of the way it goes back";
  EXPECT_NEAR(go(law, back, {1, 0.5, 0.5 + mobilisation}), 0, 1e-6);
}

TEST(HolonomicSpring, opposes_the_displacement_whatever_the_motion)
{
  const SpringLaw law = HolonomicSpring{friction(limit, mobilisation).backbone};
  SpringState state;
  EXPECT_NEAR(go(law, state, {1, 0.5}), limit, 1e-9);
  EXPECT_NEAR(go(law, state, {1, -0.5}), -limit, 1e-9);
}

TEST(OneSidedSpring, pushes_and_never_pulls)
{
  const SpringLaw law = OneSidedSpring{1e6};
  SpringState state;
  state.origin = -0.5;
  EXPECT_EQ(force_of(law, state, -0.4).force, 0);
  EXPECT_NEAR(force_of(law, state, -0.6).force, -1e5, 1e-6);
}

TEST(PlasticSpring, follows_its_backbone_and_unloads_with_its_first_stiffness)
{
  const SpringLaw law = PlasticSpring{peak_and_berm};
  SpringState state;
  EXPECT_NEAR(go(law, state, {0.03}), 900, 1e-9);
  EXPECT_NEAR(go(law, state, {0.03, 0.3}), 700, 1e-6);
  SpringState unloaded = state;
  EXPECT_NEAR(go(law, unloaded, {0.3, 0.3 - 0.001}), 700 - 0.001 * 700 / 0.005, 1e-6);
}

TEST(PlasticSpring, remembers_how_far_each_side_has_been)
{
  const SpringLaw law = PlasticSpring{peak_and_berm};
  SpringState state;
  go(law, state, {0.3, 0.1});
  EXPECT_NEAR(force_of(law, state, 0.1).force, -700, 1e-6) << "the other side has only its breakout behind it";
  EXPECT_NEAR(go(law, state, {0.1, 0.2}), 700, 1e-6) << "a peak that was lost stays lost";
  EXPECT_NEAR(go(law, state, {0.2, 0.5}), 800, 1e-6) << "the berm counts from where the line was laid";
  EXPECT_NEAR(go(law, state, {0.5, -0.1}), -600, 1e-6) << "beyond the origin the backbone of the other side begins";
}

TEST(PlasticSpring, may_begin_anywhere)
{
  const SpringLaw law = PlasticSpring{peak_and_berm};
  SpringState here, there;
  there.origin = 5;
  const Real force = go(law, here, {0.3, -0.2, 0.1}), same = go(law, there, {5.3, 4.8, 5.1});
  EXPECT_NEAR(same, force, 1e-6);
}

TEST(SpringLaws, have_a_stiffness_that_is_the_derivative_of_their_force)
{
  SpringState used;
  used.slip = 0.2, used.forward = 0.205, used.backward = 0.06;
  for (const SpringLaw& law : {SpringLaw{LinearSpring{5e5}}, SpringLaw{OneSidedSpring{5e5}}, SpringLaw{PlasticSpring{peak_and_berm}},
                               SpringLaw{HolonomicSpring{peak_and_berm}}, SpringLaw{friction(limit, mobilisation)}})
    for (const SpringState& state : {SpringState{}, used})
      for (const Real u : {-0.7, -0.2, -0.0501, -0.0201, -0.0023, -0.0004, 0.0004, 0.0023, 0.0201, 0.0501, 0.1979, 0.2011, 0.3, 0.7}) {
        if (std::holds_alternative<PlasticSpring>(law) && std::get<PlasticSpring>(law).backbone.points.size() == 1 && state.slip != 0)
          continue;
        const Real step = 1e-8, numeric = (force_of(law, state, u + step).force - force_of(law, state, u - step).force) / (2 * step);
        EXPECT_NEAR(force_of(law, state, u).stiffness, numeric, 1e-3 * std::max(1e3, std::abs(numeric))) << law.index() << " at " << u;
      }
}

// Over any closed path a plastic spring takes work, never gives it.
TEST(PlasticSpring, makes_no_energy)
{
  const SpringLaw law = PlasticSpring{peak_and_berm};
  SpringState state;
  Real u = 0, force = 0, work = 0;
  for (int cycle = 0; cycle < 40; ++cycle)
    for (int i = 1; i <= 200; ++i) {
      const Real next = (0.02 + 0.01 * cycle) * std::sin(2 * pi * i / 200 * (1 + cycle % 3));
      state = accepted(law, state, next);
      const Real now = force_of(law, state, next).force;
      work += (force + now) / 2 * (next - u);
      u = next, force = now;
      EXPECT_GT(work, -1e-6);
    }
  EXPECT_GT(work, 100);
}

TEST(SpringLaws, refuse_curves_that_make_no_sense)
{
  for (const Backbone& wrong : {Backbone{}, Backbone{{{0, 5}}}, Backbone{{{0.1, 5}, {0.1, 6}}}, Backbone{{{0.1, -5}}},
                                Backbone{{{0.1, nan}}}, Backbone{{{0.1, 5}, {0.2, 50}}}})
    EXPECT_THROW(check(PlasticSpring{wrong}), InputError);
  EXPECT_THROW(check(LinearSpring{-1}), InputError);
  EXPECT_NO_THROW(check(PlasticSpring{peak_and_berm}));
}

}  // namespace
}  // namespace berm::beam::this_file
