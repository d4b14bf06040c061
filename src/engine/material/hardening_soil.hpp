// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/elasticity.hpp"
#include "material/exponential.hpp"
#include "material/increment.hpp"
#include "material/law_queries.hpp"
#include "material/matsuoka_nakai.hpp"
#include "material/small_strain.hpp"

namespace berm::material {

/// Hardening soil: hyperbolic shear hardening and a cap. With effective stress, compression positive, s1 >= s2 >= s3, counted from the apex of the cone
/// (s = sigma' + c cot phi, P = p' + c cot phi), q = sqrt(3/2 s : s), sin phi_m by Matsuoka and Nakai (matsuoka_nakai.hpp), k = sin phi / (1 - sin phi):
///
///   E_ur = unloading_modulus (s3 / s_ref)^m,   E_50 likewise,   s_ref = reference_pressure + c cot phi,   E_i = 2 E_50 / (2 - R_f),
///   y = sin phi_m / (1 - sin phi_m) / k <= 1,   (4 k s3 / E_i) (y / (1 - R_f y) - y E_i / E_ur) <= gamma_p,
///   P^2 + q^2 / alpha^2 <= p_c^2,   d p_c = H (p_c / s_ref)^m d(plastic volumetric strain of the cap), associated,
///   d(plastic volumetric strain of shear) = -sin psi_m d gamma_p,   sin psi_m = max(0, (sin phi_m - sin phi_cv) / (1 - sin phi_m sin phi_cv)).
///
/// y is q / q_f of the triaxial test, so that its axial strain is q / (E_i (1 - R_f q / q_f)) but for half of the plastic volumetric strain. sin phi_cv is such
/// that psi_m is dilation_angle at failure. The flow is along the stress deviator, its volume that of Mohr and Coulomb's potential at the stress's Lode angle:
/// in triaxial states and in plane strain the angle of dilation is psi_m. alpha and H give the oedometer modulus and K0 of virgin compression at the vertical
/// stress reference_pressure. Sources: Schanz, Vermeer and Bonnier, Beyond 2000 in computational geotechnics (1999); Benz, thesis, Stuttgart (2007).
///
/// With small_strain_shear_modulus the moduli of elasticity are multiplied by G / G_ur of small_strain.hpp, and gamma_p grows by (G_least / G_ur)^(1 + E_ur /
/// (2 E_50)) times the plastic shear strain, G_least being the smallest G of first loading so far: so the first loading begins with nearly G_0 (Benz).
///
/// State: gamma_p, and p_c, Pa, counted from the apex; with small_strain_shear_modulus the strain history after them.
struct HardeningSoil {
  static constexpr const char* word = "hardening_soil";
  static constexpr int state_size = 2 + SmallStrain::size;  ///< at most; state_count(law) are in use

  Real density = 0;                     ///< kg/m3, gives the weight
  std::optional<Real> inertia_density;  ///< kg/m3, gives the inertia; empty: density
  Real cohesion = 0;                    ///< Pa, effective
  Real friction_angle = 0;              ///< rad, effective
  Real dilation_angle = 0;              ///< rad
  Real secant_modulus = 0;              ///< E50_ref, Pa
  Real oedometer_modulus = 0;           ///< Eoed_ref, Pa
  Real unloading_modulus = 0;           ///< Eur_ref, Pa
  Real stiffness_exponent = 0;          ///< m
  Real reference_pressure = 1e5;        ///< Pa
  Real failure_ratio = 0.9;             ///< R_f
  Real poisson_ratio = 0;
  std::optional<Real> virgin_k0;                   ///< empty: 1 - sin phi
  std::optional<Real> small_strain_shear_modulus;  ///< G0_ref, Pa
  std::optional<Real> shear_strain_at_70_percent;  ///< gamma_07
  Real overconsolidation_ratio = 1;
  Real min_pressure = 100;     ///< Pa
  bool at_max_volume = false;  ///< does not dilate any more; not of the input
  Real safety_factor = 1;      ///< F, which divides c and tan phi, at the same moduli and cap; not of the input
  Real max_pressure = 0;       ///< Pa
  std::optional<PoreWater> water = {};

  bool operator==(const HardeningSoil&) const = default;
};

void describe(Describe& d, HardeningSoil& law);

/// The moduli and K0 can belong to one soil; the dilation angle is not larger than the friction angle; min_pressure < max_pressure.
void check(Describe& d, const std::string& path, const HardeningSoil& law);

/// The moduli where s3 is max_pressure + c cot phi: no particle is stiffer.
Elasticity elasticity(const HardeningSoil& law);
YoungPoisson young_poisson(const HardeningSoil& law);

inline int state_count(const HardeningSoil& law)
{
  return law.small_strain_shear_modulus ? HardeningSoil::state_size : 2;
}
std::vector<FieldInfo> state_fields(const HardeningSoil& law);

/// K0 of virgin compression: as given, or 1 - sin phi (Jaky).
Real virgin_k0(const HardeningSoil& law);

/// The oedometer modulus that virgin_k0 and the other moduli give without a cap, Pa: a cap makes soil softer.
Real largest_oedometer_modulus(const HardeningSoil& law);

/// The surfaces through the stress; with an overconsolidation ratio above 1 at least those through virgin compression under that many times the vertical
/// stress, -stress_yy.
void initial_state(const HardeningSoil& law, const SymTensor<3>& stress, Real* state);

/// Cohesion and tan(friction_angle) over F, psi at most the friction angle that is left: c cot phi is the same, and with it the moduli and s_ref. The hyperbola
/// goes to the smaller strength, with the same E_50 at half of it. alpha and H of the cap, and K0, are those of the whole strength.
std::optional<HardeningSoil> with_strength_over(HardeningSoil law, Real factor);

std::optional<Strength> strength_at_rest(const HardeningSoil& law);
inline bool dilates(const HardeningSoil& law)
{
  return law.dilation_angle > 0;
}
HardeningSoil without_dilation(HardeningSoil law);

struct PreparedHardeningSoil {
  static constexpr int state_size = HardeningSoil::state_size;
  static constexpr int rotating_state = 2;
  static constexpr bool indefinite_tangent = true;
  static constexpr bool elastic_is_largest = true;

  Elasticity elastic;  ///< where s3 is largest
  Real bulk = 0;       ///< K at s_ref, Pa
  Real shear_over_bulk = 0;
  Real largest_factor = 0;  ///< of the moduli
  Real exponent = 0;        ///< m
  Real apex = 0;            ///< c cot phi, Pa
  Real least = 0;           ///< of P, Pa
  Real per_reference = 0;   ///< 1 / s_ref
  Real least_part = 0;      ///< s3 / P is never so small
  Real sine = 0, k = 0;     ///< sin phi, sin phi / (1 - sin phi)
  Real sine_cv = 0;         ///< sin phi_cv
  Real failure_ratio = 0;   ///< R_f
  Real softness = 0;        ///< E_i / E_ur
  Real per_strain = 0;      ///< E_i / (4 k s_ref), at s_ref
  Real per_alpha_square = 0;
  Real cap_modulus = 0;  ///< H, Pa
  SmallStrain small_strain;
  Real small_strain_exponent = 0;  ///< 1 + E_ur / (2 E_50)
};

inline int state_count(const PreparedHardeningSoil& law)
{
  return law.small_strain.ratio > 1 ? PreparedHardeningSoil::state_size : 2;
}

PreparedHardeningSoil prepare(const HardeningSoil& law);

/// The sine of the mobilised friction angle that a strain g allows, and its derivative: y / (1 - R_f y) - y E_i / E_ur = g, y <= 1.
template <class T>
[[gnu::always_inline]] inline MobilisedSine<T> allowed_sine(const PreparedHardeningSoil& law, const T& g)
{
  const Real R = law.failure_ratio, r = law.softness;
  const T b = (1 - r) + R * g, y = 2. * g / (b + square_root(b * b + (4 * r * R) * g));
  const T one = T{} + 1., d = 1. - R * y, square = d * d, slope = 1. - r * square;
  const auto fails = y >= one;
  const T ky = law.k * (fails ? one : y), both = 1. / (slope * (1. + ky)), per = slope * both;
  return {ky * per, fails ? T{} : law.k * square * both * per};
}

/// The elastic result of a piece of an increment as the return sees it: P and q, Pa, and what does not change within the piece.
template <class T>
struct HardeningTrial {
  T pressure, q;
  T bulk, shear;    ///< Pa
  T sine_dilation;  ///< sin psi_m
  T hardening;      ///< d gamma_p over the plastic shear strain
  DeviatorShape<T> shape;
};

/// What the return changes.
template <class T>
struct HardeningState {
  T pressure, q;  ///< Pa
  T strain;       ///< gamma_p
  T cap;          ///< p_c, Pa
};

/// The implicit return to both surfaces: with the plastic shear strain x, which adds h x to gamma_p, and the plastic volumetric strain v = c P / K of the cap,
///
///   P = (P_trial + K sin psi_m x) / (1 + c) >= least,   q = (q_trial - 3 G n x) / (1 + 3 G c / (K alpha^2)),
///   sin phi_m(q / P) = sin phi_m(gamma_p + h x, s3) or x = 0,   sqrt(P^2 + q^2 / alpha^2) = p_c + H (p_c / s_ref)^m v or c = 0,
///
/// with the derivative n of Mohr and Coulomb's potential with respect to q. Newton's iteration with an active set; a lane that has converged does not change
/// any more, so that it does not depend on the others. The moduli, sin psi_m and the slope of p_c are those of the beginning of the piece.
template <class T, class Mask>
[[gnu::noinline]] void return_to_surfaces(const PreparedHardeningSoil& law, const HardeningTrial<T>& trial, const Mask& outside,
                                          HardeningState<T>& state)
{
  constexpr int max_iterations = 40;
  constexpr Real small_step = 1e-5;  // the next one, of its square, is not needed
  const T zero{}, one = T{} + 1., least = zero + law.least;
  const T largest = trial.shape.largest, smallest = trial.shape.smallest;
  const T three_shear = 3. * trial.shear, dilation = trial.bulk * trial.sine_dilation;
  const T across = three_shear * (0.5 * (largest + smallest - trial.sine_dilation * (largest - smallest))), most = trial.q / across;
  const Real flattening = 3 * law.shear_over_bulk * law.per_alpha_square, power = law.exponent - 1;
  const T cap_slope = law.cap_modulus * exponential(law.exponent * logarithm(state.cap * law.per_reference)) / trial.bulk;

  const T half_per_cap = 0.5 / state.cap, steepest = (1 - law.least_part) / smallest;
  T x{}, c{}, pressure = state.pressure, q = state.q, strain = state.strain;
  Mask left = outside;
  for (int i = 0; i < max_iterations && any(left); ++i) {
    const T flat = 1. + flattening * c, both = 1. / ((1. + c) * flat), per_c = flat * both, per_flat = (1. + c) * both;
    const T raw = (trial.pressure + dilation * x) * per_c;
    const auto free = raw > least;
    const T p = free ? raw : least, p_x = free ? dilation * per_c : zero, p_c = free ? -raw * per_c : zero;
    const T r = (trial.q - across * x) * per_flat, r_x = -across * per_flat, r_c = -flattening * r * per_flat;

    const T low = law.least_part * p, minor = p - smallest * r;
    const auto far = minor > low;
    const T s3 = far ? minor : low, s3_x = far ? p_x - smallest * r_x : law.least_part * p_x;
    const T s3_c = far ? p_c - smallest * r_c : law.least_part * p_c, per_s3 = 1. / s3;
    const T scale = law.per_strain * exponential(power * logarithm(s3 * law.per_reference)), gamma = state.strain + trial.hardening * x,
            g = scale * gamma;
    const MobilisedSine<T> allowed = allowed_sine(law, g);
    // Where s3 is less than ever, the mobilised sine goes on along its tangent.
    const T per_p = 1. / p, ratio = r * per_p;
    const auto beyond = ratio > steepest;
    const T inside = beyond ? steepest : ratio;
    const MobilisedSine<T> mobilised = mobilised_sine(inside, trial.shape.lode);
    const T steep = mobilised.change * per_p, with_s3 = allowed.change * power * g * per_s3;
    const T f = mobilised.value + mobilised.change * (ratio - inside) - allowed.value;
    const T f_x = steep * (r_x - ratio * p_x) - allowed.change * scale * trial.hardening - with_s3 * s3_x,
            f_c = steep * (r_c - ratio * p_c) - with_s3 * s3_c;

    const T size_of_cap = state.cap + cap_slope * c * p, bent = law.per_alpha_square * r;
    const T h = half_per_cap * (p * p + bent * r - size_of_cap * size_of_cap), grows = cap_slope * size_of_cap;
    const T h_x = 2. * half_per_cap * (p * p_x + bent * r_x - grows * c * p_x);
    const T h_c = 2. * half_per_cap * (p * p_c + bent * r_c - grows * (p + c * p_c));

    const auto shears = f + steep * across * x > zero, caps = h + p * c > zero;
    const T a_x = shears ? f_x : one, a_c = shears ? f_c : zero, a = shears ? f : x;
    const T b_x = caps ? h_x : zero, b_c = caps ? h_c : one, b = caps ? h : c;
    const T per = 1. / (a_x * b_c - a_c * b_x);
    // Between two branches whole steps may go to and fro for ever.
    const Real part = i % 16 < 10 ? 1 : 0.5;
    const T next_x = smaller(larger(x - part * ((a * b_c - b * a_c) * per), zero), most);
    const T next_c = larger(c - part * ((b * a_x - a * b_x) * per), zero);
    const T size = larger(magnitude(next_x - x) * across, magnitude(next_c - c) * (1. + cap_slope) * p);
    x = left ? next_x : x;
    c = left ? next_c : c;
    left = left & (size > small_step * p);
  }
  // At the end of the iteration, which what has not converged leaves on the surfaces all the same.
  const T raw = (trial.pressure + dilation * x) / (1. + c), end_q = larger(trial.q - across * x, zero) / (1. + flattening * c);
  const T end = larger(raw, least), gamma = state.strain + trial.hardening * x, on_cap = state.cap + cap_slope * c * end;
  pressure = outside ? end : pressure;
  q = outside ? end_q : q;
  state.strain = outside ? gamma : strain;
  state.cap = outside ? on_cap : state.cap;
  if (any(left)) [[unlikely]] {
    // s3 of the isotropic stress gives the smallest height.
    const T g = law.per_strain * exponential(power * logarithm(pressure * law.per_reference)) * gamma;
    const T height = pressure * stress_ratio(allowed_sine(law, g).value, trial.shape.lode);
    q = left ? smaller(q, height) : q;
    state.cap = left ? larger(state.cap, square_root(pressure * pressure + law.per_alpha_square * q * q)) : state.cap;
  }
  state.pressure = pressure;
  state.q = q;
}

/// The moduli of a piece, Pa, and what they came from.
template <class T>
struct HardeningModuli {
  T smallest;     ///< s3, Pa
  T power;        ///< (s3 / s_ref)^m
  T bulk, shear;  ///< Pa
};

template <class T, int dim>
[[gnu::always_inline]] inline HardeningModuli<T> moduli(const PreparedHardeningSoil& law, const T& pressure,
                                                        const SymTensor<dim, T>& deviator)
{
  const T q = square_root(1.5 * double_dot(deviator, deviator)), minor = pressure - deviator_shape(deviator, q).smallest * q;
  const T smallest = larger(minor, law.least_part * pressure);
  const T power = exponential(law.exponent * logarithm(smallest * law.per_reference));
  const T bulk = law.bulk * smaller(power, T{} + law.largest_factor);
  return {smallest, power, bulk, law.shear_over_bulk * bulk};
}

/// A piece of an increment changes P and q elastically by at most this part of P; up to as many pieces.
constexpr Real max_hardening_change = 0.1, max_hardening_pieces = 256;

/// Advances `stress` (Pa, tension positive) by an increment of any duration. state[0] is gamma_p, state[1] is p_c, the strain history comes after them.
template <int dim, class T>
[[gnu::always_inline]] inline void update(const PreparedHardeningSoil& law, SymTensor<dim, T>& stress, const Increment<dim, T>& increment,
                                          T* state)
{
  const T zero{}, one = T{} + 1., least = zero + law.least;
  const T mean = trace(stress) * (1. / 3), third = trace(increment.strain) * (1. / 3);
  SymTensor<dim, T> strain;
  for (int k = 0; k < tensor_size<dim>; ++k) {
    if (k < 3) stress[k] -= mean;
    strain[k] = k < 3 ? increment.strain[k] - third : increment.strain[k];
  }
  T pressure = larger(law.apex - mean, least), compression = -3. * third, pieces = one;
  HardeningModuli<T> now = moduli<T, dim>(law, pressure, stress);
  const bool stiffens = law.small_strain.ratio > 1;
  const T change = now.bulk * magnitude(compression) + now.shear * square_root(6. * double_dot(strain, strain));
  if (any(change > max_hardening_change * pressure)) [[unlikely]] {
    const T per_pressure = change / pressure;
    while (any((per_pressure > pieces * max_hardening_change) & (pieces < zero + max_hardening_pieces)))
      pieces = (per_pressure > pieces * max_hardening_change) & (pieces < zero + max_hardening_pieces) ? pieces * 2. : pieces;
    const T piece = 1. / pieces;
    compression *= piece;
    for (int k = 0; k < tensor_size<dim>; ++k) strain[k] *= piece;
  }

  T gamma = larger(state[0], zero), cap = larger(state[1], least);
  while (true) {
    const auto acts = pieces > zero;
    T hardening = one;
    if (stiffens) {
      const Stiffening<T> at = add_strain(law.small_strain, state + 2, strain, acts);
      now.bulk *= at.mean;
      now.shear *= at.mean;
      if (any(at.least > one)) hardening = exponential(law.small_strain_exponent * logarithm(at.least));
    }
    for (int k = 0; k < tensor_size<dim>; ++k) stress[k] += acts ? 2. * now.shear * strain[k] : zero;
    const T trial_q = square_root(1.5 * double_dot(stress, stress)), trial_p = pressure + now.bulk * compression;
    HardeningState<T> end{larger(trial_p, least), trial_q, gamma, cap};
    const DeviatorShape<T> shape = deviator_shape(stress, trial_q);

    // s3 to the power m - 1 is not less than its tangent at the beginning.
    const T minor = end.pressure - shape.smallest * trial_q, g = law.per_strain * gamma * now.power / (now.smallest * law.per_reference);
    const T at_least = larger(1. + (law.exponent - 1) * (minor / now.smallest - 1.), zero);
    const T sine = allowed_sine(law, g * at_least).value;
    const T mobilised = mobilised_sine(trial_q / end.pressure, shape.lode).value;
    const decltype(T{} < T{}) outside = acts & ((mobilised > sine) | (minor < law.least_part * end.pressure) |
                                                (end.pressure * end.pressure + law.per_alpha_square * trial_q * trial_q > cap * cap));
    if (any(outside)) {
      const T mobilised_before = allowed_sine(law, g).value;
      const T dilation = (mobilised_before - law.sine_cv) / (1. - law.sine_cv * mobilised_before);
      return_to_surfaces(law, HardeningTrial<T>{trial_p, trial_q, now.bulk, now.shear, larger(dilation, zero), hardening, shape}, outside,
                         end);
      const T part = trial_q > zero ? end.q / (trial_q > zero ? trial_q : one) : one;
      for (int k = 0; k < tensor_size<dim>; ++k) stress[k] = outside ? part * stress[k] : stress[k];
      gamma = outside ? end.strain : gamma;
      cap = outside ? end.cap : cap;
    }
    pressure = acts ? end.pressure : pressure;
    pieces -= one;
    if (!any(pieces > zero)) break;
    now = moduli<T, dim>(law, pressure, stress);
  }
  state[0] = gamma;
  state[1] = cap;
  for (int k = 0; k < 3; ++k) stress[k] += law.apex - pressure;
}

}  // namespace berm::material
