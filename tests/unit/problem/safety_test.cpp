// SPDX-License-Identifier: BSD-3-Clause
#include "problem/safety.hpp"

#include "material/clay.hpp"
#include "material/mohr_coulomb.hpp"
#include "samples/sample_case.hpp"
#include "settings/safety.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

material::MohrCoulomb soil_with_all()
{
  material::MohrCoulomb soil;
  soil.density = 2000;
  soil.young_modulus = 1e7;
  soil.poisson_ratio = 0.3;
  soil.cohesion = 12e3;
  soil.cohesion_gradient = 3e3;
  soil.friction_angle = 30 * degree;
  soil.dilation_angle = 10 * degree;
  soil.tension_cutoff = 6e3;
  return soil;
}

/// A box of this soil of 2 m x 2 m under gravity, on its base, with a pipe in contact with it.
settings::Case trial_of(const material::Material& soil, Real factor)
{
  settings::Case c = pipe_over_box({stage_of(settings::StageKind::geostatic)});
  c.gravity = {0, -10};
  c.material[0].second = soil;
  contact::ContactSettings contact;
  contact.body = "bed";
  contact.rigid = "pipe";
  contact.friction_angle = 20 * degree;
  contact.adhesion = 4e3;
  contact.tension = 2e3;
  contact.soil = {{"solid", 25 * degree, 1e3, 0}};
  c.contact = {{"skin", contact}};
  c.safety = settings::SafetySettings{factor, {}};
  return c;
}

TEST(ReducedStrength, divides_cohesion_and_the_tangent_of_friction_and_leaves_stiffness_and_dilation)
{
  const settings::Case c = with_reduced_strength(trial_of(soil_with_all(), 1.5));
  const auto& soil = c.material[0].second.get<material::MohrCoulomb>();
  EXPECT_NEAR(soil.cohesion, 8e3, 1e-9);
  EXPECT_NEAR(soil.cohesion_gradient, 2e3, 1e-9);
  EXPECT_NEAR(std::tan(soil.friction_angle), std::tan(30 * degree) / 1.5, 1e-15);
  EXPECT_NEAR(*soil.tension_cutoff, 4e3, 1e-9);
  EXPECT_EQ(soil.dilation_angle, 10 * degree);
  EXPECT_EQ(soil.young_modulus, 1e7);
}

TEST(ReducedStrength, keeps_the_dilation_angle_at_most_at_the_friction_angle)
{
  const settings::Case c = with_reduced_strength(trial_of(soil_with_all(), 4));
  const auto& soil = c.material[0].second.get<material::MohrCoulomb>();
  EXPECT_LT(soil.friction_angle, 10 * degree);
  EXPECT_EQ(soil.dilation_angle, soil.friction_angle);
}

TEST(ReducedStrength, divides_the_strength_of_a_profile)
{
  material::MohrCoulomb soil = soil_with_all();
  soil.profile.depth = {0, 1};
  soil.profile.strength = {3e3, 6e3};
  const settings::Case c = with_reduced_strength(trial_of(soil, 3));
  EXPECT_EQ(c.material[0].second.get<material::MohrCoulomb>().profile.strength, (std::vector<Real>{1e3, 2e3}));
}

TEST(ReducedStrength, divides_a_strength_by_stress_history)
{
  material::Clay clay;
  clay.density = 1600;
  clay.shansep = material::Shansep{};
  clay.shansep->ratio = 0.3;
  clay.shansep->min_strength = 1500;
  const settings::Case c = with_reduced_strength(trial_of(clay, 3));
  const std::optional<material::Shansep> reduced = c.material[0].second.get<material::Clay>().shansep;
  EXPECT_NEAR(reduced->ratio, 0.1, 1e-15);
  EXPECT_NEAR(reduced->min_strength, 500, 1e-12);
}

TEST(ReducedStrength, divides_the_undrained_strength_of_clay_and_leaves_its_stiffness_and_sensitivity)
{
  material::Clay clay;
  clay.density = 1600;
  clay.poisson_ratio = 0.4;
  clay.rigidity_index = 100;
  clay.undrained_strength = 5e3;
  clay.undrained_strength_gradient = 1e3;
  clay.sensitivity = 3;
  clay.ductility = 10;
  const settings::Case c = with_reduced_strength(trial_of(clay, 2));
  const auto& weaker = c.material[0].second.get<material::Clay>();
  EXPECT_EQ(weaker.undrained_strength, 2.5e3);
  EXPECT_EQ(weaker.undrained_strength_gradient, 500);
  EXPECT_EQ(weaker.sensitivity, 3);
  EXPECT_NEAR(elasticity(weaker).shear, elasticity(clay).shear, 1e-9 * elasticity(clay).shear);
}

TEST(ReducedStrength, divides_friction_adhesion_and_tension_of_interfaces)
{
  const settings::Case c = with_reduced_strength(trial_of(soil_with_all(), 2));
  const contact::ContactSettings& contact = c.contact[0].second;
  EXPECT_NEAR(std::tan(contact.friction_angle), std::tan(20 * degree) / 2, 1e-15);
  EXPECT_EQ(contact.adhesion, 2e3);
  EXPECT_EQ(contact.tension, 1e3);
  EXPECT_NEAR(std::tan(contact.soil[0].friction_angle), std::tan(25 * degree) / 2, 1e-15);
  EXPECT_EQ(contact.soil[0].adhesion, 500);
}

TEST(ReducedStrength, leaves_a_case_that_is_no_trial_and_elastic_soil)
{
  settings::Case c = trial_of(soil_with_all(), 2);
  c.safety.reset();
  EXPECT_EQ(with_reduced_strength(c).material[0].second.get<material::MohrCoulomb>().cohesion, 12e3);
  EXPECT_EQ(with_reduced_strength(c).stage[0].equilibrium, c.stage[0].equilibrium);
  material::LinearElastic elastic;
  elastic.young_modulus = 1e6;
  EXPECT_EQ(with_reduced_strength(trial_of(elastic, 2)).material[0].second, material::Material(elastic));
}

TEST(ReducedStrength, asks_for_a_strict_equilibrium)
{
  EXPECT_EQ(with_reduced_strength(trial_of(soil_with_all(), 2)).stage[0].equilibrium, settings::strictest_equilibrium);
}

TEST(MovementAtFailure, is_a_hundredth_of_the_height_and_twice_the_compression_of_elastic_soil)
{
  settings::Case c = trial_of(soil_with_all(), 2);
  c.contact.clear();
  c.rigid.clear();
  c.body[0].second.k0 = 0.5;
  c.surface = 2;
  const Problem<2> problem = build<2>(c, ".", ".");
  // gamma H^2 / (2 E) of the box, 2 m high.
  EXPECT_NEAR(movement_at_failure(c, problem.model, 2), 0.02 + 2 * 20e3 * 4 / 2 / 1e7, 1e-7);
  c.safety->movement = 0.3;
  EXPECT_EQ(movement_at_failure(c, problem.model, 2), 0.3);
}

TEST(MovementAtFailure, counts_the_width_of_the_body_on_level_ground_and_its_load)
{
  settings::Case c = trial_of(soil_with_all(), 2);
  c.body[0].second.k0 = 0.5;
  c.surface = 2;
  c.contact.clear();
  c.stage[0] = stage_of(settings::StageKind::push);
  c.stage[0].force = 8e3;
  const Problem<2> problem = build<2>(c, ".", ".");
  // D = 0.4 m, q = 8 kN/m / D.
  EXPECT_NEAR(movement_at_failure(c, problem.model, 2), 0.004 + 2 * (20e3 * 0.4 * 0.4 / 2 + 20e3 * 0.4) / 1e7, 1e-8);
}

TEST(MovesBody, is_said_of_velocities_and_sweeps_and_not_of_forces)
{
  settings::StageSettings stage = stage_of(settings::StageKind::push);
  stage.force = 1e3;
  EXPECT_FALSE(moves_body(stage));
  stage.force.reset();
  stage.velocity = 0.1;
  EXPECT_TRUE(moves_body(stage));
  EXPECT_FALSE(moves_body(stage_of(settings::StageKind::geostatic)));
  EXPECT_TRUE(moves_body(stage_of(settings::StageKind::sweep)));
  settings::StageSettings turning = stage_of(settings::StageKind::drive);
  turning.drive.rotation.velocity = 0.1;
  EXPECT_TRUE(moves_body(turning));
}

}  // namespace
}  // namespace berm::problem::this_file
