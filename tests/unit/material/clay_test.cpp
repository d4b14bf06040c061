// SPDX-License-Identifier: BSD-3-Clause
#include "material/clay.hpp"

#include "clay_cases.hpp"
#include "material/laws.hpp"
#include "material/tangent.hpp"
#include "mohr_coulomb_cases.hpp"

#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

/// (s1 - s3)/2 once clay flows at a rate.
template <int dim>
Real strength_at_rate(const Clay& law, Real rate, ClayParticle<dim>& particle)
{
  constexpr Real shear = 1e-3;
  Real reached = 0;
  for (int step = 0; step < 100; ++step) reached = particle.shear_by(prepare(law), shear, shear / rate);
  return reached;
}

TEST(Clay, strength_grows_by_the_same_part_for_each_tenfold_rate)
{
  for (const auto& [decades, expected] : {std::pair{0., 4000.}, {1., 4400.}, {2., 4800.}, {0.5, 4200.}}) {
    ClayParticle<2> plane;
    ClayParticle<3> space;
    EXPECT_NEAR(strength_at_rate(fast_clay(), reference_rate * std::pow(10, decades), plane), expected, 1e-7) << decades;
    EXPECT_NEAR(strength_at_rate(fast_clay(), reference_rate * std::pow(10, decades), space), expected, 1e-7) << decades;
    EXPECT_NEAR(plane.state[2], expected / clay_strength - 1, 1e-10) << "is kept as the change of the strength";
  }
}

TEST(Clay, rate_scale_is_the_rate_of_the_real_motion_over_that_of_the_model)
{
  Clay law = fast_clay();
  law.rate_scale = 0.01;
  ClayParticle<2> particle;
  EXPECT_NEAR(strength_at_rate(law, 1e3 * reference_rate, particle), 4400, 1e-7);
}

TEST(Clay, strength_below_the_reference_rate_is_that_of_the_reference_rate)
{
  for (const Real part : {0.5, 1e-3, 1e-9}) {
    ClayParticle<2> particle;
    EXPECT_NEAR(strength_at_rate(fast_clay(), part * reference_rate, particle), clay_strength, 1e-9);
    EXPECT_EQ(particle.state[1], 0);
  }
}

TEST(Clay, an_increment_without_time_has_no_rate)
{
  ClayParticle<2> particle;
  EXPECT_NEAR(particle.shear_by(prepare(fast_clay()), 0.1, 0), clay_strength, 1e-9);
  EXPECT_EQ(particle.state[1], 0);
}

/// So stiff that the elastic strain by which the stress follows the strength, 3e-6, is nothing beside the flow, and the plastic rate is that of all strain.
Clay stiff_smoothed_clay()
{
  Clay law = fast_clay();
  law.rigidity_index = 1e5;
  law.rate_smoothing = 2;
  return law;
}

TEST(Clay, a_smoothed_rate_follows_a_sudden_one_like_one_less_the_exponential)
{
  const Clay law = stiff_smoothed_clay();
  ClayParticle<2> particle;
  strength_at_rate(law, 0.1 * reference_rate, particle);  // at yield, without a rate effect
  const Real rate = 1e3 * reference_rate, dt = 1e-3;
  for (int n = 1; n <= 5000; ++n) {
    particle.shear_by(prepare(law), rate * dt, dt);
    // The strength rises by 3e-6 of strain in the first 500 increments of 1e-5 each: 6e-4 of the flow, 3e-5 of the strength.
    if (n > 500) {
      ASSERT_NEAR(particle.state[1], 0.1 * std::log10(1 - 1e3 * std::expm1(-n * dt / 2)), 1e-3) << n;
    }
  }
}

TEST(Clay, a_flow_that_stops_loses_what_the_rate_added)
{
  const Clay law = stiff_smoothed_clay();
  ClayParticle<2> particle;
  for (int n = 0; n < 20000; ++n) particle.shear_by(prepare(law), 1e-3 * 1e2 * reference_rate, 1e-3);
  ASSERT_NEAR(particle.state[1], 0.2, 1e-3);
  for (int n = 0; n < 4000; ++n) particle.shear_by(prepare(law), 0, 1e-3);
  EXPECT_NEAR(particle.state[1], 0.2 - 0.1 * 2 / std::log(10.), 1e-3) << "two times the time of smoothing";
  EXPECT_NEAR(particle.state[2], particle.state[1], 1e-12);
}

TEST(Clay, strength_falls_with_the_plastic_shear_strain_by_its_exponential)
{
  for (const int parts : {1, 100}) {
    ClayParticle<2> particle;
    const PreparedClay law = prepare(softening_clay());
    Real reached = 0;
    for (int n = 0; n < 4 * parts; ++n) reached = particle.shear_by(law, 1. / parts, 1);
    // All strain but the elastic one, s_u / G, is plastic.
    const Real strength = clay_strength * (1 / 3. + 2 / 3. * std::exp(-0.3 * particle.state[0]));
    EXPECT_NEAR(reached, strength, 1e-9 * strength) << parts;
    EXPECT_NEAR(particle.state[0], 4 - reached / (100 * clay_strength), 1e-9) << parts;
    EXPECT_NEAR(particle.state[2], strength / clay_strength - 1, 1e-9) << parts;
  }
}

TEST(Clay, elastic_strain_neither_softens_nor_strengthens)
{
  Clay law = softening_clay();
  law.rate_parameter = 0.1;
  law.reference_rate = reference_rate;
  ClayParticle<2> particle;
  for (int n = 0; n < 100000; ++n) particle.shear_by(prepare(law), n % 2 == 0 ? 9e-3 : -9e-3, 1e-4);  // (s1 - s3)/2 up to 0.9 s_u
  for (const Real state : particle.state) EXPECT_EQ(state, 0);
}

TEST(Clay, vibration_of_ten_times_the_flow_changes_the_strength_by_less_than_one_percent)
{
  Clay law = softening_clay(3, 25);
  law.rate_parameter = 0.1;
  law.reference_rate = reference_rate;
  law.rate_smoothing = 1;
  const PreparedClay prepared = prepare(law);
  ClayParticle<2> still, shaken;
  std::mt19937_64 random(5);
  std::normal_distribution<Real> noise;
  constexpr Real dt = 1e-3, flow = 1e3 * reference_rate * dt;
  Real before = 0;
  for (int n = 0; n < 200000; ++n) {
    const Real wave = 10 * flow * noise(random);
    still.shear_by(prepared, flow, dt);
    shaken.shear_by(prepared, flow + wave - before, dt);
    before = wave;
    if (n > 5000) {
      ASSERT_NEAR(shaken.state[2], still.state[2], 0.01 * (1 + still.state[2])) << n;
    }
  }
  EXPECT_NEAR(shaken.state[0], still.state[0], 0.01 * still.state[0]);
}

TEST(Clay, a_softening_length_counts_plastic_strain_by_the_size_of_the_cell)
{
  Clay law = softening_clay();
  law.softening_length = 0.1;
  ClayParticle<2> particle;
  Increment<2, Real> increment{{{0.5, -0.5, 0, 0}}, 1, 0, 0.02};
  update(prepare(law), particle.stress, increment, particle.state);
  const Real flow = 1 - (particle.stress[0] - particle.stress[1]) / 2 / (100 * clay_strength);
  EXPECT_NEAR(particle.state[0], 0.2 * flow, 1e-12);
}

/// A clay with everything, and random trial stresses and strains of it.
Clay whole_clay()
{
  Clay law = softening_clay();
  law.rate_parameter = 0.1;
  law.reference_rate = reference_rate;
  law.rate_smoothing = 50;
  return law;
}

TEST(Clay, an_increment_without_duration_keeps_what_the_rate_adds)
{
  Clay law = whole_clay();
  ClayParticle<2> particle;
  particle.shear_by(prepare(law), 4, 1);
  const Real rate_part = particle.state[1], strength = 1 + particle.state[2];
  ASSERT_GT(rate_part, 0.01);
  const SymTensor<2> stress = particle.stress;
  update(prepare(law), particle.stress, Increment<2, Real>{}, particle.state);
  EXPECT_NEAR(particle.state[1], rate_part, 1e-9);
  EXPECT_NEAR(1 + particle.state[2], strength, 1e-9);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(particle.stress[k], stress[k], 1e-6 * clay_strength) << k;
}

TEST(Clay, a_pause_gives_back_a_share_of_the_lost_strength)
{
  Clay law = softening_clay();
  ClayParticle<2> particle;
  particle.shear_by(prepare(law), 4, 1);
  const Real lost = -particle.state[2];
  recover(Material(law), 0.25, particle.state);
  EXPECT_NEAR(particle.state[2], -0.75 * lost, 1e-12);
  EXPECT_NEAR(1 + particle.state[2], 1 / 3. + 2 / 3. * std::exp(-0.3 * particle.state[0]), 1e-12);
  recover(Material(law), 1, particle.state);
  EXPECT_NEAR(particle.state[0], 0, 1e-12);
  EXPECT_NEAR(particle.state[2], 0, 1e-12);
}

template <int dim>
void expect_on_or_inside(const Clay& clay)
{
  std::mt19937_64 random(11);
  const PreparedClay law = prepare(clay);
  for (int n = 0; n < 5000; ++n) {
    const Increment<dim, Real> increment{elastic_strain(law.elastic, random_trial<dim>(random)), std::exp2(random() % 30)};
    SymTensor<dim> stress = random_trial<dim>(random), trial = stress;
    add_elastic_stress(law.elastic, trial, increment.strain);
    Real state[3] = {};
    update(law, stress, increment, state);
    PreparedMohrCoulomb surface = law.tresca;
    surface.strength *= 1 + state[2];
    const Real rounding = 1e-11 * (size_of(trial) + clay_strength), outside = yield_value(surface, stress);
    ASSERT_LE(outside, rounding);
    if (state[0] > 0) {
      ASSERT_NEAR(outside, 0, rounding) << "a stress outside comes to rest on the surface";
      const Real at_end = 1 / 3. + 2 / 3. * std::exp(-0.3 * state[0]);
      ASSERT_NEAR((1 + state[2]) / ((1 + state[1]) * at_end), 1, 1e-9);
    }
    ASSERT_NEAR(trace(stress), trace(trial), rounding) << "flow keeps the volume";
  }
}

TEST(Clay, returned_stress_is_on_or_inside_the_surface_of_its_strength)
{
  expect_on_or_inside<2>(whole_clay());
  expect_on_or_inside<3>(whole_clay());
}

TEST(Clay, without_softening_and_rate_it_is_mohr_coulomb_without_friction)
{
  std::mt19937_64 random(12);
  const PreparedClay law = prepare(plain_clay());
  MohrCoulomb tresca;
  tresca.young_modulus = young_poisson(plain_clay()).young_modulus;
  tresca.poisson_ratio = 0.49;
  tresca.cohesion = clay_strength;
  const PreparedMohrCoulomb same = prepare(tresca);
  for (int n = 0; n < 10000; ++n) {
    const Increment<2, Real> increment{elastic_strain(law.elastic, random_trial<2>(random)), 1e-3};
    SymTensor<2> stress = random_trial<2>(random), other = stress;
    Real state[3] = {}, opening = 0;
    update(law, stress, increment, state);
    update(same, other, increment, &opening);
    for (int k = 0; k < 4; ++k) ASSERT_NEAR(stress[k], other[k], 1e-12 * (size_of(other) + clay_strength));
  }
}

TEST(Clay, lanes_and_single_numbers_give_the_same_and_equal_lanes_the_same_bits)
{
  std::mt19937_64 random(13);
  const PreparedClay law = prepare(whole_clay());
  for (int block = 0; block < 1000; ++block) {
    SymTensor<2, Lanes> stresses;
    Increment<2, Lanes> increments{{}, 1e2};
    SymTensor<2> stress[lanes];
    Increment<2, Real> increment[lanes];
    Real state[lanes][3] = {}, size[lanes];
    for (int l = 0; l < lanes; ++l) {
      const bool again = block % 2 == 0 && l > 0;
      stress[l] = again ? stress[0] : random_trial<2>(random);
      increment[l] = again ? increment[0] : Increment<2, Real>{elastic_strain(law.elastic, random_trial<2>(random)), 1e2};
      SymTensor<2> trial = stress[l];
      add_elastic_stress(law.elastic, trial, increment[l].strain);
      size[l] = size_of(trial) + size_of(stress[l]) + clay_strength;
      for (int k = 0; k < 4; ++k) {
        stresses[k][l] = stress[l][k];
        increments.strain[k][l] = increment[l].strain[k];
      }
    }
    Lanes states[3] = {};
    update(law, stresses, increments, states);
    for (int l = 0; l < lanes; ++l) {
      SymTensor<2> single = stress[l];
      update(law, single, increment[l], state[l]);
      // The compiler may fuse products and sums in one form and not in the other, and exponentials differ by four units in the last place.
      for (int k = 0; k < 4; ++k) ASSERT_NEAR(stresses[k][l], single[k], 1e-11 * size[l]);
      for (int k = 0; k < 3; ++k) ASSERT_NEAR(states[k][l], state[l][k], 1e-11 * (1 + std::abs(state[l][k])));
      if (block % 2 == 0) {
        for (int k = 0; k < 4; ++k) ASSERT_EQ(stresses[k][l], stresses[k][0]);
        for (int k = 0; k < 3; ++k) ASSERT_EQ(states[k][l], states[k][0]);
      }
    }
  }
}

void expect_tangent_of_differences(const Clay& clay, Real dt)
{
  const PreparedClay law = prepare(clay);
  const SymTensor<2> before{{-1e3, -2e3, -1.5e3, 5e2}};
  const Increment<2, Real> increment{.strain = {{4e-2, -3e-2, 0, 2e-2}}, .dt = dt, .cell_size = 0.02};
  SymTensor<2> stress = before;
  Tangent tangent;
  Real state[3] = {};
  update_stress_and_tangent(law, stress, increment, state, tangent);
  ASSERT_GT(state[0], 0.01);
  constexpr Real h = 1e-7;
  for (int j = 0; j < 3; ++j) {
    SymTensor<2> plus = before, minus = before;
    Increment<2, Real> more = increment, less = increment;
    Real state_plus[3] = {}, state_minus[3] = {};
    const int place = j < 2 ? j : 3;
    more.strain[place] += j < 2 ? h : h / 2;
    less.strain[place] -= j < 2 ? h : h / 2;
    update(law, plus, more, state_plus);
    update(law, minus, less, state_minus);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(tangent(k, j), (plus[k] - minus[k]) / (2 * h), 1e-6 * p_wave_modulus(law.elastic));
  }
}

TEST(Clay, tangent_is_that_of_finite_differences)
{
  Clay clay = whole_clay();
  expect_tangent_of_differences(clay, 20);
  clay.rate_smoothing.reset();
  expect_tangent_of_differences(clay, 20);
  clay.ductility = 0.1;
  expect_tangent_of_differences(clay, 20);
  clay.softening_length = 0.05;
  expect_tangent_of_differences(clay, 20);
}

TEST(Clay, stiffness_follows_the_strength_with_depth_by_the_rigidity_index)
{
  Clay law = plain_clay();
  law.undrained_strength_gradient = 2e3;
  const Clay deep = at_depth(law, 3);
  EXPECT_EQ(deep.undrained_strength, 1e4);
  EXPECT_NEAR(elasticity(Material(deep)).shear, 1e6, 1e-6);
  EXPECT_NEAR(elasticity(Material(law)).shear, 4e5, 1e-6);
  EXPECT_EQ(local_values(Material(deep)), (std::vector<Real>{1e4, deep.young_modulus}));
  EXPECT_TRUE(varies(law));
  EXPECT_FALSE(varies(deep));
  const Real own[2] = {1e4, deep.young_modulus};
  const PreparedClayOf<Real> prepared = with_local(prepare(law), own);
  EXPECT_NEAR(prepared.elastic.shear, 1e6, 1e-6);
  EXPECT_NEAR(prepared.tresca.strength, 1e4, 1e-9);
}

TEST(Clay, answers_what_a_soil_without_friction_answers)
{
  const Material soil = whole_clay();
  EXPECT_TRUE(yields(soil));
  EXPECT_FALSE(dilates(soil));
  EXPECT_FALSE(non_associated(soil));
  EXPECT_TRUE(is_rate_dependent(soil));
  EXPECT_FALSE(is_rate_dependent(Material(softening_clay())));
  ASSERT_TRUE(strength_at_rest(soil));
  EXPECT_EQ(strength_at_rest(soil)->cohesion, clay_strength);
  EXPECT_EQ(strength_at_rest(soil)->friction_angle, 0);
  const Real state[3] = {1, 0.1, -0.25};
  EXPECT_EQ(shear_strength(soil, -1e4, state), 0.75 * clay_strength);
  EXPECT_EQ(state_fields(soil).size(), 3u);
  EXPECT_EQ(prepare(with_rate_smoothing(softening_clay(), 7)).smoothing, 7);
  EXPECT_EQ(std::get<PreparedClay>(prepare(with_rate_smoothing(soil, 7))).smoothing, 50) << "its own is kept";
}

}  // namespace
}  // namespace berm::material::this_file
