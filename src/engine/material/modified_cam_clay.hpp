// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/deviatoric_shape.hpp"
#include "material/law_queries.hpp"

namespace berm::material {

/// Modified Cam clay: with p' the mean effective stress (compression positive) and q = sqrt(3/2 s : s),
///
///   f = q^2 / M^2 + p' (p' - p_c) <= 0,   associated flow,   d p_c / p_c = v0 / (lambda - kappa) d(plastic volumetric strain),
///   K = v0 p' / kappa,   G by Poisson's ratio,   M = 6 sin(phi) / (3 - sin(phi)).
///
/// v0 = 1 + void_ratio is that of the beginning: log(v) and not v is linear in log(p'), with the slopes lambda / v0 and kappa / v0 (Butterfield 1979). M is
/// that of triaxial compression; in other directions q is that of deviatoric_shape.hpp. Source: Roscoe and Burland (1968); return: Borja and Lee, Comput.
/// Meth. Appl. Mech. Engng 78 (1990).
///
/// State: the preconsolidation pressure p_c, Pa.
struct ModifiedCamClay {
  static constexpr const char* word = "modified_cam_clay";
  static constexpr int state_size = 1;

  Real density = 0;                     ///< kg/m3, gives the weight
  std::optional<Real> inertia_density;  ///< kg/m3, gives the inertia; empty: density
  Real critical_friction_angle = 0;     ///< rad
  Real compression_index = 0;           ///< lambda
  Real swelling_index = 0;              ///< kappa
  Real void_ratio = 0;                  ///< at the start
  Real overconsolidation_ratio = 1;
  Real poisson_ratio = 0;
  Real min_pressure = 100;  ///< Pa
  Real max_pressure = 0;    ///< Pa
  DeviatoricShape deviatoric_shape = DeviatoricShape::circle;
  std::optional<PoreWater> water = {};

  bool operator==(const ModifiedCamClay&) const = default;
};

void describe(Describe& d, ModifiedCamClay& law);

/// kappa < lambda; min_pressure < max_pressure.
void check(Describe& d, const std::string& path, const ModifiedCamClay& law);

/// The slope M = q / p' of the critical state: that of triaxial compression.
Real critical_slope(Real friction_angle);

/// q / p' of virgin compression without strain across, of the law itself: where the strains of plastic flow and of elasticity are those of one direction,
///
///   2 eta / (M^2 - eta^2) (lambda - kappa) + kappa eta / (3 G/K) = 2 lambda / 3.
Real virgin_stress_ratio(const ModifiedCamClay& law);

/// K0 of normally consolidated soil: (3 - eta) / (3 + 2 eta).
Real virgin_k0(const ModifiedCamClay& law);

/// The moduli at max_pressure, which no particle exceeds.
Elasticity elasticity(const ModifiedCamClay& law);
YoungPoisson young_poisson(const ModifiedCamClay& law);

std::string law_name(const ModifiedCamClay& law);
std::vector<FieldInfo> state_fields(const ModifiedCamClay& law);

/// p_c with which the yield surface passes through the virgin state (virgin_k0) under overconsolidation_ratio times the vertical stress, -stress_yy; at least
/// that through the present stress.
void initial_state(const ModifiedCamClay& law, const SymTensor<3>& stress, Real* state);

struct PreparedModifiedCamClay {
  static constexpr int state_size = 1;
  static constexpr bool elastic_is_largest = true;

  Elasticity elastic;  ///< at max_pressure
  PressureElasticity moduli;
  DeviatoricShape shape = DeviatoricShape::circle;
  Real per_slope_square = 0;  ///< 1 / M^2
  Real hardening = 0;         ///< v0 / (lambda - kappa)
};

PreparedModifiedCamClay prepare(const ModifiedCamClay& law);

/// f of a stress, Pa^2, positive outside.
template <class T>
[[gnu::always_inline]] inline T yield_value(const PreparedModifiedCamClay& law, const T& pressure, const T& q_square,
                                            const T& consolidation)
{
  return q_square * law.per_slope_square + pressure * (pressure - consolidation);
}

/// The implicit return: with the plastic volumetric strain x and the multiplier g,
///
///   x = g (2 p' - p_c),   q_trial^2 / (M^2 (1 + 6 G g / M^2)^2) + p' (p' - p_c) = 0,
///
/// where p'(x), p_c(x) and G(p') are exact. Newton's iteration; a lane that has converged does not change any more, so that it does not depend on the others. A
/// separate function, because it is long.
template <class T, class N, class Mask>
[[gnu::noinline]] void return_to_cap(const PreparedModifiedCamClay& law, const Trial<T>& trial, const N& three, const Mask& yields,
                                     Returned<T>& returned, T& consolidation)
{
  constexpr int max_iterations = 30;
  constexpr Real small_step = 1e-5;  // the next one, of its square, is not needed
  const T one = T{} + 1., least = T{} + 2 * law.moduli.min_pressure, most = T{} + 0.5 / law.moduli.per_index, old = consolidation;
  const Real per_slope_square = law.per_slope_square;
  const N six_per_slope_square = 2. * three * per_slope_square;
  T x{}, g{}, size = consolidation;
  Mask left = yields;
  for (int k = 0; k < max_iterations && any(left); ++k) {
    const PressureAfter<T>& p = returned.pressure;
    const ShearModulus<T>& shear = returned.shear;
    const T shear_change = -(shear.change * p.change), size_change = size > least ? law.hardening * size : T{};
    const T spread = six_per_slope_square * shear.value, shrink = one / (one + spread * g), shrunk = per_slope_square * shrink * shrink;
    const T ellipse = trial.q_square(shear.value) * shrunk, distance = 2. * p.value - size;
    const T flow = x - g * distance, f = ellipse + p.value * (p.value - size);
    const T flow_x = one + g * (2. * p.change + size_change), f_g = -2. * ellipse * shrink * spread;
    const T f_x = (shrunk * trial.q_square_change(shear.value) - 2. * six_per_slope_square * ellipse * shrink * g) * shear_change -
                  p.change * distance - p.value * size_change;
    const T per = one / (flow_x * f_g + distance * f_x);
    const T step = smaller(larger((distance * f + f_g * flow) * per, -most), most), step_g = (f_x * flow - flow_x * f) * per;
    x = left ? x - step : x;
    g = left ? larger(g + step_g, T{}) : g;
    const PressureAfter<T> next = pressure_after(law.moduli, trial.pressure, trial.compression - x);
    take(left, returned, next, shear_modulus(law.moduli, trial.pressure, next));
    size = left ? larger(old * exponential(law.hardening * x), least) : size;
    left = left & ((magnitude(step) * law.moduli.per_index > T{} + small_step) | (magnitude(step_g) * spread > T{} + small_step));
  }
  const T shrunk = one / (one + six_per_slope_square * returned.shear.value * g);
  returned.part = yields ? shrunk : returned.part;
  consolidation = size;
  if (!any(left)) [[likely]]
    return;
  // What has not converged comes to lie on the surface all the same.
  const T pressure = smaller(returned.pressure.value, size), q = square_root(trial.q_square(returned.shear.value));
  const T height = square_root(larger(pressure * (size - pressure), T{}) / per_slope_square);
  returned.pressure.value = left ? pressure : returned.pressure.value;
  returned.part = left ? (q > height ? height / (q > T{} ? q : one) : one) : returned.part;
}

/// Returns the elastic result of a piece of an increment, as update_with_shape asks for it.
template <class T, class N, class Mask>
[[gnu::always_inline]] inline void return_piece(const PreparedModifiedCamClay& law, const Trial<T>& trial, const N& three, const Mask& acts,
                                                Returned<T>& returned, T* state)
{
  T consolidation = larger(state[0], T{} + 2 * law.moduli.min_pressure);
  const decltype(T{} < T{}) outside =
      acts & (yield_value(law, returned.pressure.value, trial.q_square(returned.shear.value), consolidation) > T{});
  if (any(outside)) return_to_cap(law, trial, three, outside, returned, consolidation);
  state[0] = acts ? consolidation : state[0];
}

/// Advances `stress` (Pa, tension positive) by an increment of any duration. state[0] is p_c.
template <int dim, class T>
[[gnu::always_inline]] inline void update(const PreparedModifiedCamClay& law, SymTensor<dim, T>& stress, const Increment<dim, T>& increment,
                                          T* state)
{
  update_with_shape<dim>(law, stress, increment.strain, state);
}

}  // namespace berm::material
