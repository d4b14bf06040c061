// SPDX-License-Identifier: BSD-3-Clause
#include "material/mohr_coulomb.hpp"
#include "material/ngi_adp.hpp"
#include "material/principal_axes.hpp"
#include "material/tangent.hpp"
#include "ngi_adp_cases.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::material::this_file {
namespace {

constexpr Real s_a = active_strength;

/// Ellipses that are wider than high and higher than wide, clay that begins beyond the middle of its ellipse and before it, and brittle clay.
std::vector<NgiAdp> clays()
{
  std::vector<NgiAdp> all = {sample_ngi_adp(), sample_ngi_adp(0), sample_ngi_adp(-0.2), sample_ngi_adp(0.9)};
  NgiAdp high = sample_ngi_adp(0.3), brittle = sample_ngi_adp(0.3), compressible = sample_ngi_adp(0.3);
  high.dss_ratio = 1;
  brittle.active_failure_strain = 0.0025, brittle.dss_failure_strain = 0.0015, brittle.passive_failure_strain = 0.003;
  compressible.poisson_ratio = 0.2;
  all.insert(all.end(), {high, brittle, compressible});
  return all;
}

/// (h1 - h3)/2 - kappa R of a stress and a state, by its principal axes, Pa.
template <int dim>
Real outside(const NgiAdp& law, const SymTensor<dim>& stress, Real x)
{
  const Real s = law.undrained_strength, R = (1 + law.passive_ratio) / 2 * s, r = R / (law.dss_ratio * s);
  const Real kappa = x < 1 ? 2 * std::sqrt(x) / (1 + x) : 1;
  const Real c = (1 - kappa) * law.initial_mobilisation * s + kappa * (1 - law.passive_ratio) / 2 * s;
  SymTensor<3> h{};
  std::copy_n(stress.c, tensor_size<dim>, h.c);
  h[1] += 2 * c, h[3] *= r, h[4] *= r;
  const PrincipalAxes axes = principal_axes(h);
  return (axes.value[0] - axes.value[2]) / 2 - kappa * R;
}

template <int dim>
SymTensor<dim> random_direction(std::mt19937_64& random)
{
  std::uniform_real_distribution<Real> unit(-1, 1);
  SymTensor<dim> strain;
  for (int k = 0; k < tensor_size<dim>; ++k) strain[k] = unit(random);
  return strain;
}

/// From 1e-8 to 2, with a change of volume that is up to as large.
template <int dim>
SymTensor<dim> random_strain(std::mt19937_64& random)
{
  std::uniform_real_distribution<Real> decades(-8, std::log10(2.));
  SymTensor<dim> strain = random_direction<dim>(random);
  const Real size = std::pow(10, decades(random));
  for (int k = 0; k < tensor_size<dim>; ++k) strain[k] *= size;
  return strain;
}

template <int dim>
void expect_on_or_inside(const NgiAdp& law, int steps)
{
  std::mt19937_64 random(21);
  AdpElement<dim> soil(law);
  int yielding = 0;
  for (int n = 0; n < steps; ++n) {
    if (n % 50 == 0) soil = AdpElement<dim>(law);
    const SymTensor<dim> strain = random_strain<dim>(random);
    SymTensor<dim> trial = soil.stress;
    add_elastic_stress(soil.prepared.elastic, trial, strain);
    const Real before = soil.state[0];
    soil.strain_by(strain);
    const Real scale = std::sqrt(double_dot(trial, trial)) + s_a;
    for (int k = 0; k < tensor_size<dim>; ++k) ASSERT_TRUE(std::isfinite(soil.stress[k])) << n;
    ASSERT_GE(soil.state[0], before) << n;
    // Rounding, and what the return leaves, the square of 1e-5; in space the extreme principal stresses have half of their digits where two are equal.
    const Real rounding = 1e-13 * scale + (dim == 2 ? 1e-10 : 1e-7) * s_a, out = outside<dim>(law, soil.stress, soil.state[0]);
    ASSERT_LE(out, rounding) << n;
    if (soil.state[0] > before) {
      ASSERT_GE(out, -rounding) << n << ": what flows comes to rest on the surface";
      ++yielding;
    } else {
      for (int k = 0; k < tensor_size<dim>; ++k) ASSERT_NEAR(soil.stress[k], trial[k], rounding) << n;
    }
    ASSERT_NEAR(trace(soil.stress), trace(trial), 1e-12 * scale) << "flow keeps the volume";
  }
  EXPECT_GT(yielding, steps / 4);
}

TEST(NgiAdpReturn, hundred_thousand_steps_of_any_size_stay_finite_and_on_or_inside_the_surface)
{
  const std::vector<NgiAdp> all = clays();
  for (const NgiAdp& law : all) {
    expect_on_or_inside<2>(law, 100000 / static_cast<int>(all.size()) + 1);
    expect_on_or_inside<3>(law, 100000 / static_cast<int>(all.size()) + 1);
  }
}

/// What the return solves, of the stress that it found: the plastic strain is along A h, and x has grown by its stretched shear strain over that at failure.
TEST(NgiAdpReturn, plastic_strain_is_along_the_stretched_stress_and_makes_the_state)
{
  std::mt19937_64 random(22);
  const NgiAdp law = sample_ngi_adp();
  const Real r = 0.675 / 0.55, shear = 400 * s_a;
  for (int n = 0; n < 2000; ++n) {
    AdpElement<3> soil(law);
    SymTensor<3> strain = random_strain<3>(random), trial = soil.stress;
    for (Real& e : strain.c) e *= 0.01;
    add_elastic_stress(soil.prepared.elastic, trial, strain);
    soil.strain_by(strain);
    const Real kappa = soil.kappa(), c = (1 - kappa) * 0.5 * s_a + kappa * 0.325 * s_a;
    SymTensor<3> flow, h = soil.stress;
    const Real mean = trace(h) / 3;
    for (int k = 0; k < 6; ++k) {
      h[k] += k == 1 ? 4. / 3 * c - mean : k < 3 ? -2. / 3 * c - mean : 0;
      const Real stretch = k == 3 || k == 4 ? r : 1;
      h[k] *= stretch;
      flow[k] = (trial[k] - soil.stress[k]) / (2 * shear) / stretch;
    }
    const Real along = double_dot(flow, h) / double_dot(h, h), size = std::sqrt(double_dot(flow, flow));
    for (int k = 0; k < 6; ++k) ASSERT_NEAR(flow[k], along * h[k], 1e-8 * size + 1e-15 * s_a / shear) << n;
    const PrincipalAxes axes = principal_axes(flow);
    const Real plastic = axes.value[0] - axes.value[2], per = soil.state[0] / plastic;
    // Between the inverses of the strains at failure, of which that of simple shear is r-fold in the stretched plane.
    ASSERT_LE(per, (1 + 1e-6) / (0.02 - 0.5 / 400));
    ASSERT_GE(per, (1 - 1e-6) / (0.06 - 0.85 / 400));
  }
}

void expect_tangent_of_differences(const NgiAdp& law)
{
  std::mt19937_64 random(23);
  const PreparedNgiAdp prepared = prepare(law);
  int checked = 0, failed = 0;
  for (int n = 0; n < 1000; ++n) {
    // Soil with a past.
    AdpElement<2> soil(law);
    for (int k = 0; k < n % 3; ++k) {
      SymTensor<2> past = random_direction<2>(random);
      for (Real& e : past.c) e *= 0.01;
      soil.strain_by(past);
    }
    SymTensor<2> strain = random_strain<2>(random);
    const auto end_of = [&](const SymTensor<2>& by) {
      AdpElement<2> moved = soil;
      moved.strain_by(by);
      return moved.stress;
    };
    const Real h = 1e-5 * std::sqrt(double_dot(strain, strain));
    const auto by_differences = [&](Real step) {
      Eigen::Matrix<Real, 4, 4> slopes;
      for (int j = 0; j < 4; ++j) {
        SymTensor<2> plus = strain, minus = strain;
        const int at = j == 2 ? 3 : j == 3 ? 2 : j;
        plus[at] += j == 2 ? step / 2 : step, minus[at] -= j == 2 ? step / 2 : step;
        const SymTensor<2> more = end_of(plus), less = end_of(minus);
        for (int k = 0; k < 4; ++k) slopes(k, j) = (more[k] - less[k]) / (2 * step);
      }
      return slopes;
    };
    SymTensor<2> stress = soil.stress, across;
    Real state[1] = {soil.state[0]};
    Tangent tangent;
    update_stress_and_tangent(prepared, stress, Increment<2, Real>{strain}, state, tangent, &across);
    const SymTensor<2> end = end_of(strain);
    const Real size = std::sqrt(double_dot(end, end));
    for (int k = 0; k < 4; ++k) ASSERT_NEAR(stress[k], end[k], 1e-10 * size);
    const Eigen::Matrix<Real, 4, 4> wide = by_differences(2 * h), narrow = by_differences(h);
    // Differences lose what rounding takes of the stress; they do not agree at a corner.
    const Real stiffness = p_wave_modulus(prepared.elastic), rounding = 1e-12 * size / h;
    if (rounding > 1e-4 * stiffness || (wide - narrow).cwiseAbs().maxCoeff() > 1e-6 * stiffness) continue;
    for (int k = 0; k < 4; ++k) {
      for (int j = 0; j < 3; ++j) ASSERT_NEAR(tangent(k, j), narrow(k, j), 1e-5 * stiffness + rounding) << n << " " << k << j;
      ASSERT_NEAR(across[k], narrow(k, 3), 1e-5 * stiffness + rounding) << n << " " << k;
    }
    ++checked;
    failed += state[0] > soil.state[0];
  }
  EXPECT_GT(checked, 500);
  EXPECT_GT(failed, 300);
}

TEST(NgiAdpReturn, tangent_is_that_of_finite_differences)
{
  for (const NgiAdp& law : clays()) expect_tangent_of_differences(law);
}

template <int dim>
void expect_lanes_like_single_numbers(const NgiAdp& law)
{
  std::mt19937_64 random(24);
  const PreparedNgiAdp prepared = prepare(law);
  for (int block = 0; block < 1000; ++block) {
    std::vector<AdpElement<dim>> soils(lanes, AdpElement<dim>(law));
    SymTensor<dim, LanePart> stresses, turned;
    Increment<dim, LanePart> increments, turned_increments;
    LanePart states[1], turned_states[1];
    constexpr int count = lanes_of<LanePart>;
    SymTensor<dim> strain[lanes];
    for (int l = 0; l < count; ++l) {
      soils[l].strain_by(random_strain<dim>(random));
      strain[l] = random_strain<dim>(random);
    }
    for (int l = 0; l < count; ++l) {
      const int other = (l + 1) % count;
      for (int k = 0; k < tensor_size<dim>; ++k) {
        stresses[k][l] = soils[l].stress[k], turned[k][l] = soils[other].stress[k];
        increments.strain[k][l] = strain[l][k], turned_increments.strain[k][l] = strain[other][k];
      }
      states[0][l] = soils[l].state[0], turned_states[0][l] = soils[other].state[0];
    }
    update(prepared, stresses, increments, states);
    update(prepared, turned, turned_increments, turned_states);
    for (int l = 0; l < count; ++l) {
      SymTensor<dim> trial = soils[l].stress;
      add_elastic_stress(prepared.elastic, trial, strain[l]);
      soils[l].strain_by(strain[l]);
      // The compiler may fuse products and sums in one form and not in the other; in space an edge as below.
      const Real size = (dim == 2 ? 1e-11 : 1e-7) * (std::sqrt(double_dot(soils[l].stress, soils[l].stress)) + s_a);
      for (int k = 0; k < tensor_size<dim>; ++k) {
        ASSERT_NEAR(stresses[k][l], soils[l].stress[k], size);
        ASSERT_EQ(turned[k][l], stresses[k][(l + 1) % count]) << "a lane knows nothing of its neighbours";
      }
      ASSERT_NEAR(states[0][l], soils[l].state[0], (dim == 2 ? 1e-9 : 1e-6) * (1 + soils[l].state[0]));
      ASSERT_EQ(turned_states[0][l], states[0][(l + 1) % count]);
    }
  }
}

TEST(NgiAdpReturn, lanes_and_single_numbers_give_the_same)
{
  expect_lanes_like_single_numbers<2>(sample_ngi_adp());
  expect_lanes_like_single_numbers<3>(sample_ngi_adp());
}

TEST(NgiAdpReturn, in_space_it_is_the_law_of_the_plane)
{
  std::mt19937_64 random(25);
  for (const NgiAdp& law : clays())
    for (int n = 0; n < 300; ++n) {
      AdpElement<2> plane(law);
      AdpElement<3> space(law);
      for (int step = 0; step < 10; ++step) {
        const SymTensor<2> strain = random_strain<2>(random);
        plane.strain_by(strain);
        space.strain_by({{strain[0], strain[1], strain[2], strain[3], 0, 0}});
        // Beside an edge the surface has half of the digits in space.
        const Real scale = 1e-7 * (std::sqrt(double_dot(plane.stress, plane.stress)) + s_a);
        for (int k = 0; k < 4; ++k) ASSERT_NEAR(space.stress[k], plane.stress[k], scale) << n << " " << step;
        ASSERT_EQ(space.stress[4], 0);
        ASSERT_EQ(space.stress[5], 0);
        ASSERT_NEAR(space.state[0], plane.state[0], 1e-6 * (1 + plane.state[0]));
      }
    }
}

SymTensor<3> turned_about_vertical(const SymTensor<3>& a, Real angle)
{
  const Real c = std::cos(angle), s = std::sin(angle);
  const Real q[3][3] = {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
  SymTensor<3> b{};
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) b[tensor_index(i, j)] += q[i][k] * a[tensor_index(k, l)] * q[j][l];
  return b;
}

TEST(NgiAdpReturn, soil_turned_about_the_vertical_is_the_same_soil)
{
  std::mt19937_64 random(26);
  for (const Real angle : {pi, 0.7})
    for (int n = 0; n < 300; ++n) {
      AdpElement<3> soil(sample_ngi_adp()), turned(sample_ngi_adp());
      for (int step = 0; step < 10; ++step) {
        const SymTensor<3> strain = random_strain<3>(random);
        soil.strain_by(strain);
        turned.strain_by(turned_about_vertical(strain, angle));
        const SymTensor<3> same = turned_about_vertical(soil.stress, angle);
        const Real scale = 1e-7 * (std::sqrt(double_dot(same, same)) + s_a);
        for (int k = 0; k < 6; ++k) ASSERT_NEAR(turned.stress[k], same[k], scale) << angle << " " << n;
        ASSERT_NEAR(turned.state[0], soil.state[0], 1e-6 * (1 + soil.state[0]));
      }
    }
}

TEST(NgiAdpReturn, clay_of_one_strength_that_fails_early_is_tresca)
{
  NgiAdp law = sample_ngi_adp(0);
  law.dss_ratio = law.passive_ratio = 1;
  law.active_failure_strain = law.dss_failure_strain = law.passive_failure_strain = 0.0025 * 1.001;
  MohrCoulomb tresca;
  tresca.young_modulus = young_poisson(law).young_modulus;
  tresca.poisson_ratio = law.poisson_ratio;
  tresca.cohesion = s_a;
  const PreparedMohrCoulomb same = prepare(tresca);
  std::mt19937_64 random(27);
  for (int n = 0; n < 3000; ++n) {
    // A path of one direction in plane strain, to which the third stress is the middle one in both laws; elastic and plastic strain are a thousandth apart.
    SymTensor<2> strain = random_direction<2>(random), stress{};
    strain[1] = -strain[0], strain[2] = 0;
    for (Real& e : strain.c) e *= 0.01;
    AdpElement<2> soil(law, SymTensor<3>{});
    soil.strain_by(strain);
    Real opening = 0;
    update(same, stress, Increment<2, Real>{strain}, &opening);
    for (int k = 0; k < 4; ++k) ASSERT_NEAR(soil.stress[k], stress[k], 0.002 * s_a) << n;
  }
  // In space the greatest shear stress is the strength, whatever the direction; the flow is that of a circle in the deviatoric plane.
  for (int n = 0; n < 3000; ++n) {
    SymTensor<3> strain = random_direction<3>(random);
    AdpElement<3> soil(law, SymTensor<3>{});
    soil.strain_by(strain);
    ASSERT_NEAR(yield_value(same, soil.stress), 0, 1e-6 * s_a) << n;
  }
}

TEST(NgiAdpReturn, a_closed_path_below_yield_makes_no_energy)
{
  std::mt19937_64 random(28);
  for (int n = 0; n < 200; ++n) {
    AdpElement<3> soil(sample_ngi_adp());
    soil.strain_by(plane_shear<3>(0.03 * n, 0.01));
    soil.strain_by(plane_shear<3>(0.03 * n, -4e-4));
    const SymTensor<3> begin = soil.stress;
    const Real x = soil.state[0];
    // Corners of the path lie within a part of the surface's size of its begin.
    SymTensor<3> at{};
    Real work = 0, moved = 0;
    for (int corner = 0; corner <= 5; ++corner) {
      SymTensor<3> next = random_direction<3>(random), step;
      for (int k = 0; k < 6; ++k) next[k] *= corner == 5 ? 0 : 5e-5, step[k] = next[k] - at[k];
      const SymTensor<3> before = soil.stress;
      soil.strain_by(step);
      SymTensor<3> mean;
      for (int k = 0; k < 6; ++k) mean[k] = (before[k] + soil.stress[k]) / 2;
      work += double_dot(mean, step);
      moved += std::abs(double_dot(mean, step));
      at = next;
    }
    EXPECT_EQ(soil.state[0], x);
    EXPECT_NEAR(work, 0, 1e-12 * moved);
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(soil.stress[k], begin[k], 1e-9 * s_a);
  }
}

TEST(NgiAdpReturn, shear_to_and_fro_takes_energy)
{
  std::mt19937_64 random(29);
  for (int n = 0; n < 300; ++n) {
    AdpElement<3> soil(sample_ngi_adp());
    const SymTensor<3> direction = random_direction<3>(random);
    Real work = 0;
    for (int step = 0; step < 400; ++step) {
      SymTensor<3> strain = direction;
      for (Real& e : strain.c) e *= (step / 100) % 2 == 0 ? 2e-4 : -2e-4;
      const SymTensor<3> before = soil.stress;
      soil.strain_by(strain);
      for (int k = 0; k < 6; ++k) work += (k < 3 ? 0.5 : 1) * (before[k] + soil.stress[k]) * strain[k];
    }
    EXPECT_GT(work, 0) << n;
  }
}

TEST(NgiAdpReturn, many_small_steps_converge)
{
  // Shear that turns from active to simple: errors fall with the step.
  const auto end_of = [](int steps) {
    AdpElement<2> soil(sample_ngi_adp(0.6));
    for (int n = 0; n < steps; ++n) soil.strain_by(plane_shear<2>(pi / 2 * (n + 0.5) / steps, 0.03 / steps));
    return soil;
  };
  const AdpElement<2> exact = end_of(20000);
  Real before = infinity;
  for (const int steps : {10, 40, 160}) {
    const AdpElement<2> soil = end_of(steps);
    const Real error = std::hypot(soil.half_difference() - exact.half_difference(), soil.stress[3] - exact.stress[3]);
    EXPECT_LT(error, 0.4 * before) << steps;
    before = error;
  }
  EXPECT_LT(before, 5e-3 * s_a);
}

}  // namespace
}  // namespace berm::material::this_file
