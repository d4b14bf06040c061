// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/deviatoric_shape.hpp"
#include "material/law_queries.hpp"
#include "material/shear_band.hpp"

namespace berm::material {

/// NorSand, critical-state sand: with p' the mean effective stress (compression positive), q = sqrt(3/2 s : s), eta = q / p', the void ratio e and the state
/// parameter psi = e - e_c(p'), e_c(p') = critical_void_ratio - critical_line_slope log(p' / 1 kPa),
///
///   eta <= M_i (1 + log(p_i / p')) and eta <= eta_max = M_i - D_min,   D_min = chi_tc psi,
///   D = d(plastic volumetric strain) / d(plastic deviatoric strain) = M_i - eta,
///   d p_i / p_i = H (p' / p_i)^2 (exp(-D_min / M_i) - p_i / p') d(plastic deviatoric strain),   H = hardening_modulus - hardening_slope psi,
///   M_i = M (1 - N chi_i |psi_i| / M),   psi_i = e - e_c(p_i),   chi_i = chi_tc / (1 - chi_tc critical_line_slope / M),
///   G = rigidity p',   K by Poisson's ratio,   M = 6 sin(phi) / (3 - sin(phi)),   d e = (1 + e) d(volumetric strain).
///
/// The yield surface follows from D by normality. At the image state p' = p_i the volume does not change. At the peak D_min = chi_tc psi = chi_i psi_i. The
/// second limit of eta keeps soil that was unloaded from more than its peak strength. All of it is of triaxial compression; in other directions eta is that
/// of deviatoric_shape.hpp, and the plastic deviatoric strain the one that goes with it. Sources: Jefferies, Geotechnique 43 (1993); Jefferies and Shuttle
/// (2005); Jefferies and Been, Soil liquefaction (2015).
///
/// Bedding: D_min goes with the direction of the deviator s to the normal n of the bedding, which is fixed in space,
///
///   D_min = chi_tc psi (1 - bedding_loss t (1 + bedding_curvature (1 - t))),   t = 2/3 (1 - k),   k = 3/2 n s n / q (compression positive),
///
/// where t = sin^2 of the angle between sigma_1 and n in triaxial compression. A polynomial in the projection of the load on n [Pietruszczak and Mroz, Comput.
/// Geotech. 26 (2001)], the load being the direction of the deviator [Dafalias, Papadimitriou and Li, J. Eng. Mech. 130 (2004)].
///
/// Length: soil that softens, p_i / p' above its bound at eta_max with D_min < 0, does so in a band. With band_strain = s, d log(p_i) and the plastic part of
/// the change of e are s-fold, the strain in a band of the soil's own width (shear_band.hpp).
///
/// State: the image pressure p_i, Pa, and the void ratio e.
struct NorSand {
  static constexpr const char* word = "norsand";
  static constexpr int state_size = 2;

  Real density = 0;                     ///< kg/m3, gives the weight
  std::optional<Real> inertia_density;  ///< kg/m3, gives the inertia; empty: density
  Real critical_friction_angle = 0;     ///< rad
  Real critical_void_ratio = 0;         ///< Gamma
  Real critical_line_slope = 0;         ///< lambda_e
  Real volumetric_coupling = 0;         ///< N
  Real dilatancy = 0;                   ///< chi_tc
  Real hardening_modulus = 0;           ///< H at psi = 0
  Real hardening_slope = 0;             ///< decrease of H with psi
  std::optional<Real> void_ratio;       ///< at the start; or
  std::optional<Real> state_parameter;  ///< psi at the start
  Real overconsolidation_ratio = 1;
  Real rigidity = 0;  ///< G / p'
  Real poisson_ratio = 0;
  Real min_pressure = 100;  ///< Pa
  Real max_pressure = 0;    ///< Pa
  DeviatoricShape deviatoric_shape = DeviatoricShape::circle;
  Real bedding_loss = 0;  ///< of D_min
  Real bedding_curvature = 0;
  Real bedding_angle = 0;               ///< rad, of the bedding to the x axis
  std::optional<Real> band_width = {};  ///< m, of shear bands
  std::optional<Real> d50 = {};         ///< m, of the grains: bands are 15 of them wide
  Real band_strain = 1;                 ///< of this law: strain of the soil's bands over that of the cells (regularised_for)
  std::optional<PoreWater> water = {};

  bool operator==(const NorSand&) const = default;
};

void describe(Describe& d, NorSand& law);

/// One of void_ratio and state_parameter is given; min_pressure < max_pressure; chi_tc critical_line_slope < M; no length in undrained soil.
void check(Describe& d, const std::string& path, const NorSand& law);

/// The moduli at max_pressure, which no particle exceeds.
Elasticity elasticity(const NorSand& law);
YoungPoisson young_poisson(const NorSand& law);

std::string law_name(const NorSand& law);
std::vector<FieldInfo> state_fields(const NorSand& law);

/// p_i with which the yield surface passes through the stress times overconsolidation_ratio; e that is given, or that of psi at this p'.
void initial_state(const NorSand& law, const SymTensor<3>& stress, Real* state);

std::optional<Real> band_width(const NorSand& law);
NorSand with_grain_size(NorSand law, Real d50);
/// With band_strain 4 size / band_width, but at most most_band_strain.
NorSand regularised_for(NorSand law, Real size);

/// Beyond this band_strain soil could soften faster than its elasticity unloads: there
///
///   -d eta / d(plastic deviatoric strain) <= s chi_tc (1 + e) chi_tc |psi| = 3/2 rigidity,   half of the elastic 3 G / p',
///
/// with the psi of the start at p' = 1 kPa and e at most Gamma. Infinite where the sand is loose.
Real most_band_strain(const NorSand& law);

/// The numbers of the law, the dilatancy apart.
struct NorSandConstants {
  static constexpr int state_size = 2;
  static constexpr bool elastic_is_largest = true;

  Elasticity elastic;  ///< at max_pressure
  PressureElasticity moduli;
  DeviatoricShape shape = DeviatoricShape::circle;
  Real slope = 0;              ///< M
  Real gamma = 0, lambda = 0;  ///< of e_c over log(p' / 1 Pa)
  Real coupling = 0;           ///< N chi_i
  Real hardening = 0, hardening_slope = 0;
  Real band_strain = 1;
  Real bedding_loss = 0, bedding_curvature = 0;
  Real normal_xx = 0, normal_yy = 1, normal_xy = 0;  ///< n_x^2, n_y^2 and 2 n_x n_y of the normal of the bedding
};

/// N is a vector where the dilatancy goes with the direction.
template <class N>
struct PreparedNorSandOf : NorSandConstants {
  N dilatancy{};  ///< chi_tc
};
using PreparedNorSand = PreparedNorSandOf<Real>;

PreparedNorSand prepare(const NorSand& law);

/// The surface in eta at a state: M_i, r = log(p_i / p'), its upper bound -D_min / M_i, and their derivatives with respect to log(p_i) (`_i`) and log(p').
template <class T>
struct ImageState {
  T slope, slope_i;              ///< M_i
  T bound, bound_i, bound_p;     ///< -D_min / M_i
  T r, below, below_i, below_p;  ///< the smaller of r and its bound
};

/// eta_max is kept between these parts of M_i, and M_i above this part of M: far from the critical state the formulas have no meaning.
constexpr Real least_bound = -0.5, most_bound = 1, least_slope = 0.2;

template <class N, class T>
[[gnu::always_inline]] inline ImageState<T> image_state(const PreparedNorSandOf<N>& law, const T& void_ratio, const T& log_pressure,
                                                        const T& log_image)
{
  const T zero{}, one = T{} + 1.;
  const T psi = void_ratio - law.gamma + law.lambda * log_pressure, psi_i = void_ratio - law.gamma + law.lambda * log_image;
  ImageState<T> s;
  const T slope = law.slope - law.coupling * magnitude(psi_i), flattest = zero + least_slope * law.slope;
  const auto steep = slope > flattest;
  const Real per_image = law.coupling * law.lambda;
  s.slope = steep ? slope : flattest;
  s.slope_i = steep ? (psi_i > zero ? zero - per_image : zero + per_image) : zero;
  const T per_slope = one / s.slope, bound = -law.dilatancy * psi * per_slope;
  const auto low = bound<zero + least_bound, high = bound> zero + most_bound;
  const auto free = (bound >= zero + least_bound) & (bound <= zero + most_bound);
  s.bound = low ? zero + least_bound : (high ? zero + most_bound : bound);
  s.bound_i = free ? -bound * s.slope_i * per_slope : zero;
  s.bound_p = free ? -law.dilatancy * law.lambda * per_slope : zero;
  s.r = log_image - log_pressure;
  const auto capped = s.r > s.bound;
  s.below = capped ? s.bound : s.r;
  s.below_i = capped ? s.bound_i : one;
  s.below_p = capped ? s.bound_p : zero - one;
  return s;
}

/// Where the elastic stress lies beyond the tip of the surface, eta = 0: the plastic volumetric strain of a return to it, with a hardening that is that of the
/// tip; the iteration is that of one unknown.
template <class T, class Mask>
[[gnu::always_inline]] inline T strain_to_tip(const NorSandConstants& law, const Trial<T>& trial, Mask left, const T& log_image,
                                              const T& hardening)
{
  constexpr int max_iterations = 20;
  constexpr Real small_step = 1e-14;
  T x{};
  for (int k = 0; k < max_iterations && any(left); ++k) {
    const PressureAfter<T> p = pressure_after(law.moduli, trial.pressure, trial.compression - x);
    const T step = (log_image + hardening * x - logarithm(p.value) + 1.) / (hardening + p.change / p.value);
    x = left ? larger(x - step, T{}) : x;
    left = left & (magnitude(step) * law.moduli.per_index > T{} + small_step);
  }
  return x;
}

/// The implicit return: with the plastic volumetric and deviatoric strains x, y, and u = log(p_i) - log(p_i at the beginning),
///
///   x = (M_i - eta) y,   q_trial - 3 G y = eta p',   u = H (p' / p_i)^2 (exp(-D_min / M_i) - p_i / p') y,
///
/// where p'(x), G(p'), M_i and D_min are exact at the end. Newton's iteration; a lane that has converged does not change any more, so that it does not depend
/// on the others. in_bands: where the soil softens at the beginning, u is band_strain-fold, and log(1 + e) changes by (1 - band_strain) x beside the volume.
template <bool in_bands, class D, class T, class N, class Mask>
[[gnu::noinline]] void return_to_image_surface(const PreparedNorSandOf<D>& law, const Trial<T>& trial, const N& three, T& void_ratio,
                                               const Mask& yields, Returned<T>& returned, T& image)
{
  constexpr int max_iterations = 40;
  constexpr Real small_step = 1e-5;  // the next one, of its square, is not needed
  const T zero{}, one = T{} + 1., most_step = T{} + 0.5, old = logarithm(image);
  const T log_begin = logarithm(trial.pressure), psi = void_ratio - law.gamma + law.lambda * log_begin;
  T log_pressure = logarithm_of(returned.pressure, log_begin), x{}, y{}, u{};
  T rate = larger(law.hardening - law.hardening_slope * psi, zero);
  ImageState<T> s = image_state(law, void_ratio, log_pressure, old);
  T more{}, loose = void_ratio;  // band_strain - 1 where the soil softens; e of the iteration
  if constexpr (in_bands) {
    const auto softens = yields & (s.r > s.bound) & (s.bound > zero);
    more = softens ? zero + (law.band_strain - 1) : zero;
    rate = softens ? rate * law.band_strain : rate;
  }

  const T least = smaller(logarithm(zero + law.moduli.min_pressure) - old, zero);

  // At the tip: all of the deviator goes where the plastic volumetric strain of the tip's flow would take more than it.
  Mask at_tip = yields & (s.r < zero - 1.);
  if (any(at_tip)) {
    constexpr Real e = 2.718281828459045;
    const T hardening = rate * (e * e * exponential(s.bound) - e) / s.slope;
    const T strain = strain_to_tip(law, trial, at_tip, old, hardening);
    const PressureAfter<T> after = pressure_after(law.moduli, trial.pressure, trial.compression - strain);
    const ShearModulus<T> shear_after = shear_modulus(law.moduli, trial.pressure, after);
    at_tip = at_tip & (square_root(trial.q_square(shear_after.value)) * s.slope <= three * shear_after.value * strain);
    take(at_tip, returned, after, shear_after);
    returned.part = at_tip ? zero : returned.part;
    image = at_tip ? after.value * (1 / e) : image;
  }

  const Mask to_side = yields & ((at_tip ? zero : one) > zero);
  Mask left = to_side;
  for (int k = 0; k < max_iterations && any(left); ++k) {
    const PressureAfter<T>& p = returned.pressure;
    const ShearModulus<T>& shear = returned.shear;
    const T q_trial = square_root(trial.q_square(shear.value)), q = q_trial - three * shear.value * y, per_pressure = one / p.value;
    const T change = -p.change * per_pressure;  // of log(p') with x
    const T h = exponential(-s.r), power = exponential(s.bound), drive = h * (power * h - 1.), drive_r = h * (1. - 2. * power * h);
    const T drive_bound = power * h * h;
    const T a = x + s.slope * s.below * y, b = q * per_pressure - s.slope * (1. + s.below), hardened = rate * y * drive;
    // The image pressure has the same minimum as p'.
    const auto soft = hardened <= least;
    const T c = u - (soft ? least : hardened), acts = soft ? zero : one;
    const T shear_change = -shear.change * p.change;
    const T q_change = q_trial > zero ? trial.q_square_change(shear.value) * shear_change * 0.5 / (q_trial > zero ? q_trial : one) : zero;
    T a_x = 1. + s.slope * s.below_p * change * y;
    const T a_y = s.slope * s.below, a_u = (s.slope_i * s.below + s.slope * s.below_i) * y;
    T b_x = (q_change - three * y * shear_change) * per_pressure - q * per_pressure * change - s.slope * s.below_p * change;
    const T b_y = -three * shear.value * per_pressure, b_u = -s.slope_i * (1. + s.below) - s.slope * s.below_i;
    T c_x = -acts * rate * y * (drive_bound * s.bound_p - drive_r) * change;
    const T c_y = -acts * rate * drive;
    const T c_u = 1. - acts * rate * y * (drive_bound * s.bound_i + drive_r);

    if constexpr (in_bands) {
      // e moves psi and psi_i alike, as log(p') and log(p_i) together do.
      const T e_x = -more * (1. + loose) * (1 / law.lambda), below_e = s.below_i + s.below_p;
      a_x += e_x * y * (s.slope_i * s.below + s.slope * below_e);
      b_x -= e_x * (s.slope_i * (1. + s.below) + s.slope * below_e);
      c_x -= e_x * acts * rate * y * drive_bound * (s.bound_i + s.bound_p);
    }

    const T yu = b_y * c_u - b_u * c_y, ux = b_u * c_x - b_x * c_u, xy = b_x * c_y - b_y * c_x;
    const T per = one / (a_x * yu + a_y * ux + a_u * xy);
    T dx = (a * yu + b * (a_u * c_y - a_y * c_u) + c * (a_y * b_u - a_u * b_y)) * per;
    T dy = (a * ux + b * (a_x * c_u - a_u * c_x) + c * (a_u * b_x - a_x * b_u)) * per;
    T du = (a * xy + b * (a_y * c_x - a_x * c_y) + c * (a_x * b_y - a_y * b_x)) * per;
    const T size = larger(magnitude(dx) * law.moduli.per_index, larger(magnitude(du), magnitude(b_y * dy)));
    if (any(size > most_step)) {
      const T part = size > most_step ? most_step / size : one;
      dx = dx * part, dy = dy * part, du = du * part;
    }
    x = left ? x - dx : x;
    y = left ? larger(y - dy, zero) : y;
    u = left ? larger(u - du, least) : u;
    const PressureAfter<T> next = pressure_after(law.moduli, trial.pressure, trial.compression - x);
    take(left, returned, next, shear_modulus(law.moduli, trial.pressure, next));
    log_pressure = logarithm_of(returned.pressure, log_begin);
    if constexpr (in_bands) loose = left ? void_ratio + (1. + void_ratio) * (exponential(-more * x) - 1.) : loose;
    s = image_state(law, loose, log_pressure, old + u);
    left = left & (size > zero + small_step);
  }
  // What has not converged comes to lie on the surface all the same.
  const T shear = returned.shear.value, q_trial = square_root(trial.q_square(shear)), iterated = larger(q_trial - three * shear * y, zero);
  const T on_surface = returned.pressure.value * s.slope * larger(1. + s.below, zero), q = left ? smaller(q_trial, on_surface) : iterated;
  returned.part = to_side ? (q_trial > zero ? q / (q_trial > zero ? q_trial : one) : one) : returned.part;
  image = to_side ? image * exponential(u) : image;
  if constexpr (in_bands) void_ratio = to_side ? loose : void_ratio;
}

/// A law whose bedding acts.
struct BeddedNorSand : PreparedNorSand {};

/// The law of a piece of an increment whose elastic deviator is s, Pa, tension positive. Where q is less than a thousandth of p', k tends to 0.
template <int dim, class T>
[[gnu::always_inline]] inline PreparedNorSandOf<T> in_direction(const BeddedNorSand& law, const SymTensor<dim, T>& s, const T& pressure)
{
  const T square = 1.5 * double_dot(s, s), q = square_root(square), small = pressure * 1e-3;
  const T along = law.normal_xx * s[0] + law.normal_yy * s[1] + law.normal_xy * s[3];
  const T k = -1.5 * along * square / (square * q + small * small * small), t = (1. - k) * (2. / 3);
  PreparedNorSandOf<T> here;
  static_cast<NorSandConstants&>(here) = law;
  here.dilatancy = law.dilatancy * (1. - law.bedding_loss * t * (1. + law.bedding_curvature * (1. - t)));
  return here;
}

/// Returns the elastic result of a piece of an increment, as update_with_shape asks for it.
template <class D, class T, class N, class Mask>
[[gnu::always_inline]] inline void return_piece(const PreparedNorSandOf<D>& law, const Trial<T>& trial, const N& three, const Mask& acts,
                                                Returned<T>& returned, T* state)
{
  const T least = T{} + law.moduli.min_pressure;
  T void_ratio = (1. + state[1]) * exponential(-trial.compression) - 1.;
  T image = larger(state[0], least);
  const ImageState<T> s = image_state(law, void_ratio, logarithm_of(returned.pressure, logarithm(trial.pressure)), logarithm(image));
  const T q = square_root(trial.q_square(returned.shear.value));
  const decltype(T{} < T{}) outside = acts & (q > returned.pressure.value * s.slope * (1. + s.below));
  if (any(outside)) {
    if (law.band_strain > 1) [[unlikely]]
      return_to_image_surface<true>(law, trial, three, void_ratio, outside, returned, image);
    else
      return_to_image_surface<false>(law, trial, three, void_ratio, outside, returned, image);
  }
  state[0] = acts ? larger(image, least) : state[0];
  state[1] = acts ? void_ratio : state[1];
}

/// Advances `stress` (Pa, tension positive) by an increment of any duration. state[0] is p_i, state[1] the void ratio.
template <int dim, class T>
[[gnu::always_inline]] inline void update(const PreparedNorSand& law, SymTensor<dim, T>& stress, const Increment<dim, T>& increment,
                                          T* state)
{
  if (law.bedding_loss > 0) [[unlikely]]
    update_copies_along<dim>(BeddedNorSand{law}, stress, increment.strain, state);
  else
    update_with_shape<dim>(law, stress, increment.strain, state);
}

}  // namespace berm::material
