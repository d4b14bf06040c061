// SPDX-License-Identifier: BSD-3-Clause
#include "material/undrained.hpp"

#include "critical_state_paths.hpp"
#include "material/laws.hpp"

namespace berm::material::this_file {
namespace {

/// Soil with a bulk modulus of the water, Pa, and a porosity where the law has no void ratio.
template <class L>
L with_pores(L law, Real bulk_modulus)
{
  law.water = PoreWater{Drainage::undrained, bulk_modulus, {}, 0, {}};
  if (!void_ratio(law)) law.water->porosity = 0.5;
  return law;
}

MohrCoulomb sand(Real friction_angle, Real dilation_angle = 0)
{
  MohrCoulomb law;
  law.density = 1000;
  law.young_modulus = 1e7;
  law.poisson_ratio = 0.3;
  law.friction_angle = friction_angle;
  law.dilation_angle = dilation_angle;
  return law;
}

/// A specimen of a material: total stress and state under strain increments.
struct Specimen {
  Material material;
  PreparedMaterial law = prepare(material);
  SymTensor<3> stress;
  std::array<Real, Laws::max_state> state{};

  Specimen(const Material& soil, const SymTensor<3>& begin) : material(soil), stress(begin) { initial_state(soil, begin, state.data()); }

  void strain(const SymTensor<3>& by)
  {
    std::visit([&](const auto& prepared) { update(prepared, stress, Increment<3, Real>{by}, state.data()); }, law);
  }
  /// Triaxial compression by an axial strain under a radial total stress that stays, by the secant method.
  void compress(Real axial)
  {
    const Specimen begin = *this;
    const auto change = [&](Real across) {
      *this = begin;
      strain({{across, -axial, across}});
      return stress[0] - begin.stress[0];
    };
    Real low = 0.5 * axial, high = 0.501 * axial, at_low = change(low), at_high = change(high);
    for (int k = 0; k < 50 && std::abs(at_high) > 1e-6 * std::abs(begin.stress[0]) && at_high != at_low; ++k) {
      const Real next = high - at_high * (high - low) / (at_high - at_low);
      low = high, at_low = at_high;
      high = next, at_high = change(next);
    }
  }
  Real pressure() const { return state[static_cast<std::size_t>(pore_pressure_index(material))]; }
  SymTensor<3> effective() const { return effective_stress(material, stress, state.data()); }
};

TEST(Undrained, water_levels_the_pressures_of_a_cell_and_leaves_the_effective_stress)
{
  LinearElastic law;
  law.density = 1000;
  law.young_modulus = 1e7;
  law.poisson_ratio = 0.3;
  const Material material = with_pores(law, 5e7);
  Increment<3, Real> increment;
  increment.level = 3e3;
  increment.exchange = 1 / (5e7 / 0.5);  // x = 1: half of the difference
  for (const Real before : {1e3, 5e3}) {
    Specimen soil(material, {{-1e4, -1e4, -1e4}});
    soil.state[static_cast<std::size_t>(pore_pressure_index(material))] = before;
    const SymTensor<3> effective = soil.effective();
    std::visit([&](const auto& prepared) { update(prepared, soil.stress, increment, soil.state.data()); }, soil.law);
    EXPECT_NEAR(soil.pressure(), (before + 3e3) / 2, 1e-9);
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(soil.effective()[k], effective[k], 1e-9);
  }
}

TEST(Undrained, oedometer_shares_the_load_by_the_stiffnesses)
{
  LinearElastic law;
  law.density = 1000;
  law.young_modulus = 1e7;
  law.poisson_ratio = 0.3;
  Specimen soil(with_pores(law, 5e7), {});
  soil.strain({{0, -1e-3, 0}});
  const Real M = p_wave_modulus(elasticity(law)), Q = 1e8;
  EXPECT_DOUBLE_EQ(soil.pressure(), 1e-3 * Q);
  EXPECT_NEAR(soil.stress[1], -1e-3 * (M + Q), 1e-9 * Q);
  EXPECT_NEAR(soil.effective()[1], -1e-3 * M, 1e-9 * Q);
  EXPECT_DOUBLE_EQ(p_wave_modulus(soil.material), M + Q);
}

// The water is 1000 times as stiff as the skeleton, so that the volume changes by a thousandth of what it would drained.
TEST(Undrained, triaxial_strength_of_cam_clay_is_that_of_the_closed_form)
{
  for (const Real R : {1., 2., 4.}) {
    constexpr Real p0 = 1e5;
    Specimen soil(with_pores(sample_cam_clay(), 1e10), isotropic(p0));
    soil.state[0] = R * p0;
    for (int k = 0; k < 1000; ++k) soil.compress(5e-4);
    const Real end = p0 * std::pow(R / 2, 0.8), q = soil.stress[0] - soil.stress[1];
    EXPECT_NEAR(-soil.stress[0], p0, 1e-5 * p0);
    EXPECT_NEAR(q, end, 2e-3 * end) << R;
    EXPECT_NEAR(-trace(soil.effective()) / 3, end, 2e-3 * end);
    EXPECT_NEAR(soil.pressure(), p0 + q / 3 - end, 2e-3 * p0);
  }
}

TEST(Undrained, plane_strain_strength_of_sand_is_s_sin_phi)
{
  constexpr Real p0 = 1e5, phi = pi / 6;
  Specimen soil(with_pores(sand(phi), 1e11), isotropic(p0));
  for (int k = 0; k < 200; ++k) soil.strain({{1e-4, -1e-4, 0}});
  EXPECT_NEAR((soil.stress[0] - soil.stress[1]) / 2, p0 * std::sin(phi), 1e-3 * p0);
}

TEST(Undrained, norsand_keeps_its_volume_and_comes_to_the_critical_state)
{
  Specimen soil(with_pores(sample_norsand(0.02), 1e11), isotropic(1e5));
  for (int k = 0; k < 2000; ++k) soil.compress(4e-4);
  const SymTensor<3> s = soil.effective();
  EXPECT_NEAR((s[0] - s[1]) / (-trace(s) / 3), 1.25, 0.01);
  EXPECT_GT(soil.pressure(), 0) << "loose";
}

TEST(Undrained, suction_ends_where_water_cavitates)
{
  MohrCoulomb law = with_pores(sand(0.6, 0.2), 1e9);
  law.water->min_pressure = -5e4;
  Specimen soil(law, isotropic(1e5));
  for (int k = 0; k < 1000; ++k) soil.strain({{6e-4, -5e-4, 0}});
  EXPECT_EQ(soil.pressure(), -5e4);
  law.water->min_pressure.reset();
  EXPECT_DOUBLE_EQ(min_pore_pressure(*law.water), -1e5);
  law.water->water_depth = 100;
  EXPECT_DOUBLE_EQ(min_pore_pressure(*law.water), -1.081e6);
}

TEST(Undrained, without_bulk_modulus_water_is_30_times_as_stiff_as_the_skeleton)
{
  MohrCoulomb law = sand(0.5);
  law.water.emplace();
  EXPECT_DOUBLE_EQ(water_stiffness(Material(law)), 30 * p_wave_modulus(elasticity(law)));
  law.water->drainage = Drainage::drained;
  EXPECT_EQ(water_stiffness(Material(law)), 0);
}

TEST(Undrained, soil_has_one_state_variable_more_than_drained_soil)
{
  for (const Material& material : {Material(sand(0.5)), Material(sample_cam_clay()), Material(sample_norsand())}) {
    const Material wet = visit([](const auto& law) { return Material(with_pores(law, 1e8)); }, material);
    EXPECT_EQ(state_size(wet), state_size(material) + 1);
    EXPECT_EQ(state_fields(wet).back().name, "excess_pore_pressure");
    EXPECT_EQ(state_fields(wet).size(), state_fields(material).size() + 1);
    EXPECT_EQ(pore_pressure_index(wet), state_size(material));
    EXPECT_EQ(pore_pressure_index(material), none);
    EXPECT_TRUE(drained(wet) == material);
  }
}

TEST(Undrained, lanes_give_what_single_numbers_give_with_strengths_of_their_own)
{
  MohrCoulomb law = with_pores(sand(0.5), 1e8);
  law.cohesion = 1e3;
  const auto prepared = with_water(prepare(law), 2e8, -1e5);
  SymTensor<3, LanePart> stress;
  LanePart own[2], state[2] = {};
  Increment<3, LanePart> increment;
  for (int k = 0; k < 3; ++k) stress[k] = LanePart{} - 1e4;
  for (int l = 0; l < lanes_of<LanePart>; ++l) {
    own[0][l] = 1e3 * (l + 1);
    own[1][l] = 1e7 * (l + 1);
    increment.strain[1][l] = -1e-3 * (l + 1);
  }
  update(with_local(prepared, own), stress, increment, state);
  for (int l = 0; l < lanes_of<LanePart>; ++l) {
    law.cohesion = 1e3 * (l + 1);
    law.young_modulus = 1e7 * (l + 1);
    SymTensor<3> alone = isotropic(1e4);
    Real of_one[2] = {};
    Increment<3, Real> by;
    by.strain[1] = -1e-3 * (l + 1);
    update(with_water(prepare(law), 2e8, -1e5), alone, by, of_one);
    EXPECT_NEAR(state[1][l], of_one[1], 1e-9 * of_one[1]);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(stress[k][l], alone[k], 1e-9 * 1e5);
  }
}

TEST(Undrained, tangent_is_that_of_finite_differences)
{
  const auto law = with_water(prepare(with_pores(sample_cam_clay(), 1e8)), 2e8, -1e6);
  const SymTensor<2> begin{{-1e5, -1.2e5, -1e5, 0}};
  const auto after = [&](int component, Real by, Tangent& tangent) {
    SymTensor<2> stress = begin;
    Real state[2] = {1.3e5, 0};
    Increment<2, Real> increment;
    increment.strain = {{1e-3, -2e-3, 0, 5e-4}};
    increment.strain[component] += component == 3 ? by / 2 : by;
    update_stress_and_tangent(law, stress, increment, state, tangent);
    return stress;
  };
  Tangent tangent, ignored;
  after(0, 0, tangent);
  constexpr Real step = 1e-7;
  for (const int component : {0, 1, 3}) {
    const SymTensor<2> more = after(component, step, ignored), less = after(component, -step, ignored);
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(tangent(k, component == 3 ? 2 : component), (more[k] - less[k]) / (2 * step), 1e-5 * 2e8) << k << " " << component;
  }
}

}  // namespace
}  // namespace berm::material::this_file
