// SPDX-License-Identifier: BSD-3-Clause
// What holds for all of berm's own laws. A new law does not compile here until it has a sample.
#include "clay_cases.hpp"
#include "critical_state_paths.hpp"
#include "material/laws.hpp"
#include "mohr_coulomb_cases.hpp"
#include "samples/anisotropic_clay.hpp"

namespace berm::material::this_file {
namespace {

constexpr Real p0 = 1e5;

/// laws(): of each kind that has code of its own; outside(...): how far a stress is beyond the yield surface, over its size, and what of that is
/// rounding (accuracy); linear: whether its moduli are
/// constant, or in proportion to p'; shear_part: the q that a loop of elastic strain may reach, over p0.
template <class L>
struct Sample;

template <>
struct Sample<LinearElastic> {
  static constexpr bool linear = true;
  static constexpr Real shear_part = 0.3;
  static std::vector<LinearElastic> laws()
  {
    LinearElastic law;
    law.young_modulus = 1e7;
    law.poisson_ratio = 0.3;
    return {law};
  }
  static Real outside(const PreparedLinearElastic&, const SymTensor<3>&, const Real*) { return -1; }
  static Real accuracy(const PreparedLinearElastic&, const SymTensor<3>&) { return 1e-9; }
};

template <>
struct Sample<MohrCoulomb> {
  static constexpr bool linear = true;
  static constexpr Real shear_part = 0.1;
  static std::vector<MohrCoulomb> laws() { return soils(); }
  static Real outside(const PreparedMohrCoulomb& law, const SymTensor<3>& stress, const Real*)
  {
    return yield_value(law, stress) / (p0 + std::sqrt(double_dot(stress, stress)));
  }
  static Real accuracy(const PreparedMohrCoulomb&, const SymTensor<3>&) { return 1e-9; }
};

template <>
struct Sample<Clay> {
  static constexpr bool linear = true;
  static constexpr Real shear_part = clay_strength / p0;
  static std::vector<Clay> laws() { return {plain_clay(), softening_clay(), fast_clay()}; }
  static Real outside(const PreparedClay& law, const SymTensor<3>& stress, const Real* state)
  {
    return max_shear(stress) / (law.tresca.strength * (1 + state[2])) - 1;
  }
  static Real accuracy(const PreparedClay&, const SymTensor<3>&) { return 1e-9; }
};

/// A millionth of what the surface is measured by; with a shape, whose iteration leaves a millionth of y, a hundred thousandth. Near the axis theta is that of
/// the direction only up to (1e-3 p' / q)^3, where p' may be another at the beginning of an increment.
template <class Prepared>
Real accuracy_of(const Prepared& law, const SymTensor<3>& stress)
{
  const Invariants now = invariants(stress, law.moduli.min_pressure);
  return law.shape == DeviatoricShape::circle ? 1e-6 : 1e-5 + std::min(1e-3, 1e-8 / std::pow(now.q / now.pressure + 1e-9, 2));
}

/// p', and q that is comparable with triaxial compression.
template <class Prepared>
Invariants equivalent(const Prepared& law, const SymTensor<3>& stress)
{
  return equivalent_invariants(law.shape, stress, law.moduli.min_pressure);
}

template <class L>
std::vector<L> of_each_shape(L law)
{
  law.overconsolidation_ratio = 4;
  L other = law;
  other.deviatoric_shape = DeviatoricShape::matsuoka_nakai;
  return {law, other};
}

template <>
struct Sample<ModifiedCamClay> {
  static constexpr bool linear = false;
  static constexpr Real shear_part = 0.3;
  static std::vector<ModifiedCamClay> laws() { return of_each_shape(sample_cam_clay()); }
  static Real outside(const PreparedModifiedCamClay& law, const SymTensor<3>& stress, const Real* state)
  {
    const Invariants now = equivalent(law, stress);
    return yield_value(law, now.pressure, now.q * now.q, state[0]) / (state[0] * state[0]);
  }
  static Real accuracy(const PreparedModifiedCamClay& law, const SymTensor<3>& stress) { return accuracy_of(law, stress); }
};

template <>
struct Sample<NorSand> {
  static constexpr bool linear = false;
  static constexpr Real shear_part = 0.3;
  static std::vector<NorSand> laws()
  {
    std::vector<NorSand> laws = of_each_shape(sample_norsand());
    for (int k = 0; k < 2; ++k) {
      NorSand bedded = laws[k], in_bands = laws[k];
      bedded.bedding_loss = 0.3, bedded.bedding_curvature = 1, bedded.bedding_angle = 0.5;
      in_bands.band_strain = 8;
      laws.push_back(bedded);
      laws.push_back(in_bands);
    }
    return laws;
  }
  static Real outside(const PreparedNorSand& law, const SymTensor<3>& stress, const Real* state)
  {
    const Invariants now = equivalent(law, stress);
    SymTensor<3> deviator = stress;
    for (int k = 0; k < 3; ++k) deviator[k] -= trace(stress) / 3;
    const auto here = in_direction<3>(BeddedNorSand{law}, deviator, now.pressure);
    const ImageState<Real> s = image_state(here, state[1], std::log(now.pressure), std::log(state[0]));
    return now.q / now.pressure - s.slope * (1 + s.below);
  }
  static Real accuracy(const PreparedNorSand& law, const SymTensor<3>& stress) { return accuracy_of(law, stress); }
};

/// Of laws whose stress has no surface in a few words: their own tests know it, and their closed loops.
template <class L>
struct OwnSample {
  static Real outside(const PreparedLaw<L>&, const SymTensor<3>&, const Real*) { return -1; }
  static Real accuracy(const PreparedLaw<L>&, const SymTensor<3>&) { return 0; }
};
template <>
struct Sample<Hypoplastic> : OwnSample<Hypoplastic> {
  static std::vector<Hypoplastic> laws() { return {sample_hypoplastic(0.8, false), sample_hypoplastic(0.8, true)}; }
};
template <>
struct Sample<NgiAdp> : OwnSample<NgiAdp> {
  static std::vector<NgiAdp> laws() { return {sample_ngi_adp(0.2)}; }
};
template <>
struct Sample<HardeningSoil> : OwnSample<HardeningSoil> {
  static std::vector<HardeningSoil> laws()
  {
    HardeningSoil law;
    law.density = 1600;
    law.friction_angle = 0.7;
    law.dilation_angle = 0.2;
    law.secant_modulus = law.oedometer_modulus = 30e6;
    law.unloading_modulus = 90e6;
    law.stiffness_exponent = 0.5;
    law.poisson_ratio = 0.25;
    law.max_pressure = 1e7;
    HardeningSoil stiff = law;
    stiff.small_strain_shear_modulus = 90e6;
    stiff.shear_strain_at_70_percent = 2e-4;
    return {law, stiff};
  }
};

template <class L>
constexpr bool is_user_law = false;
template <Interface interface>
constexpr bool is_user_law<UserLaw<interface>> = true;

/// check(law) for each sample of each law of the program.
template <class Check, class... Ls>
void for_each_sample(const std::variant<Ls...>*, const Check& check)
{
  const auto all_of = [&]<class L>(const L*) {
    if constexpr (!is_user_law<L>)
      for (const L& law : Sample<L>::laws()) {
        SCOPED_TRACE(law_name(law));
        check(law);
      }
  };
  (all_of(static_cast<const Ls*>(nullptr)), ...);
}
template <class Check>
void for_each_sample(const Check& check)
{
  for_each_sample(static_cast<const Laws::Any*>(nullptr), check);
}

/// A corner of a loop of strain: volumetric (compression positive) and deviatoric.
struct Corner {
  Real volumetric, deviatoric;
};

struct Loop {
  Real work = 0;       ///< done on the soil, J/m3
  Real exchanged = 0;  ///< sum of the sizes of the increments of work
};

/// The work of a closed loop of strain around soil under the isotropic stress p0.
template <class L>
Loop go_round(const L& law, const std::vector<Corner>& corners)
{
  constexpr int steps = 400;
  const auto prepared = prepare(law);
  SymTensor<3> stress = isotropic(p0);
  Real state[L::state_size + 1] = {};
  initial_state(law, stress, state);
  Loop loop;
  Corner at = corners.back();
  for (const Corner& next : corners) {
    const Real mean = (next.volumetric - at.volumetric) / 3 / steps, axial = (next.deviatoric - at.deviatoric) / steps;
    Increment<3, Real> increment{{{axial / 2 - mean, -axial - mean, axial / 2 - mean}}};
    increment.dt = 1;
    for (int k = 0; k < steps; ++k) {
      const SymTensor<3> before = stress;
      update(prepared, stress, increment, state);
      EXPECT_LT(Sample<L>::outside(prepared, stress, state), -1e-6) << "the loop is elastic";
      const Real work = (double_dot(before, increment.strain) + double_dot(stress, increment.strain)) / 2;
      loop.work += work;
      loop.exchanged += std::abs(work);
    }
    at = next;
  }
  return loop;
}

TEST(EveryLaw, closed_loops_of_elastic_strain_make_no_energy_where_the_moduli_are_constant)
{
  for_each_sample([]<class L>(const L& law) {
    if constexpr (requires { requires Sample<L>::linear; }) {
      const Elasticity elastic = elasticity(law);
      const Real a = 0.1 * p0 / elastic.bulk, b = Sample<L>::shear_part * p0 / (3 * elastic.shear);
      std::vector<Corner> ellipse;
      for (int k = 1; k <= 48; ++k) ellipse.push_back({a * (1 - std::cos(2 * pi * k / 48)), b * std::sin(2 * pi * k / 48)});
      for (const std::vector<Corner>& corners :
           {std::vector<Corner>{{a, 0}, {a, b}, {0, b}, {0, 0}}, {{0, b}, {a, b}, {a, 0}, {0, 0}}, {{a, 0}, {a, b}, {0, 0}}, ellipse}) {
        const Loop loop = go_round(law, corners);
        // 19,200 sums of stress, each with a rounding of 1e-16 of its size.
        EXPECT_LT(std::abs(loop.work), 1e-11 * loop.exchanged);
      }
    }
  });
}

/// The work over 3/2 G b^2, the energy of the shear, of the loops of pressure-dependent moduli G = G0 exp(x eps_v / a): along each side q changes by 3 G
/// d(eps_q), and the work of p' has returned. At the end p' is that of the start and q is not.
Real of_rectangle(Real x)
{
  return -(std::exp(x) - 1);
}
Real of_triangle(Real x)
{
  const Real grown = std::exp(x);
  return -grown + 2 * (grown / x - (grown - 1) / (x * x));
}

TEST(EveryLaw, moduli_in_proportion_to_the_pressure_make_energy_in_proportion_to_its_change_round_a_loop)
{
  for_each_sample([]<class L>(const L& law) {
    if constexpr (requires { requires !Sample<L>::linear; }) {
      const auto prepared = prepare(law);
      const Real bulk = p0 * prepared.moduli.per_index, shear = bulk * prepared.moduli.shear_over_bulk;
      const Real b = Sample<L>::shear_part / 2 * p0 / (3 * shear), energy = 1.5 * shear * b * b;
      for (const Real x : {1e-3, 0.01, 0.1, 0.5}) {
        const Real a = x / prepared.moduli.per_index;
        // p' and G are exact where one of them stays; else the rule by which the work is summed has an error of 1 / (12 steps^2).
        const Real round = go_round(law, {{a, 0}, {a, b}, {0, b}, {0, 0}}).work / energy;
        EXPECT_NEAR(round, of_rectangle(x), 1e-8) << "compressed first: makes energy";
        EXPECT_NEAR(go_round(law, {{0, b}, {a, b}, {a, 0}, {0, 0}}).work / energy, -of_rectangle(x), 1e-8) << "the other way: takes it";
        EXPECT_NEAR(go_round(law, {{a, 0}, {a, b}, {0, 0}}).work / energy, of_triangle(x), 1e-5);
        EXPECT_NEAR(go_round(law, {{a, b}, {0, 0}}).work / energy, 0, 1e-8) << "there and back";
      }
    }
  });
}

TEST(EveryLaw, any_increments_leave_a_finite_stress_on_or_inside_the_surface)
{
  for_each_sample([]<class L>(const L& law) {
    std::mt19937_64 random(41);
    const auto prepared = prepare(law);
    const int starts = static_cast<int>(2000 / Sample<L>::laws().size());
    for (int n = 0; n < starts; ++n) {
      SymTensor<3> stress = random_stress<3>(random, 0.8);
      Real state[L::state_size + 1] = {};
      initial_state(law, stress, state);
      for (int k = 0; k < 10; ++k) {
        Increment<3, Real> increment{random_strain<3>(random, 0.3)};
        increment.dt = 0.01;
        update(prepared, stress, increment, state);
        const Real beyond = Sample<L>::outside(prepared, stress, state);
        ASSERT_TRUE(std::isfinite(beyond) && std::isfinite(double_dot(stress, stress))) << n << " " << k;
        for (int j = 0; j < L::state_size; ++j) ASSERT_TRUE(std::isfinite(state[j])) << n << " " << k << " " << j;
        ASSERT_LE(beyond, Sample<L>::accuracy(prepared, stress)) << n << " " << k;
      }
    }
  });
}

}  // namespace
}  // namespace berm::material::this_file
