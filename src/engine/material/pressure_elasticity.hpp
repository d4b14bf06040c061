// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/elasticity.hpp"
#include "material/exponential.hpp"
#include "material/increment.hpp"

#include <algorithm>

namespace berm::material {

/// Elasticity of soil whose moduli are in proportion to its mean effective stress p', compression positive:
///
///   K = p' / index,   G = shear_over_bulk K,   min_pressure <= p',   K <= max_pressure / index.
///
/// So that p' = p'_0 exp(volumetric strain / index), which is exact for an increment of any size. The cap on K bounds the speed of waves.
struct PressureElasticity {
  Real per_index = 0;        ///< 1 / index, the slope of volumetric strain over log(p')
  Real shear_over_bulk = 0;  ///< G / K = 3 (1 - 2 nu) / (2 (1 + nu))
  Real min_pressure = 0;     ///< Pa
  Real max_pressure = 0;     ///< Pa
};

inline Real shear_over_bulk(Real poisson_ratio)
{
  return 3 * (1 - 2 * poisson_ratio) / (2 * (1 + poisson_ratio));
}

/// The moduli at the maximum pressure.
inline Elasticity stiffest(const PressureElasticity& elastic)
{
  const Real bulk = elastic.max_pressure * elastic.per_index, shear = bulk * elastic.shear_over_bulk;
  return {bulk, shear, bulk - 2. / 3 * shear};
}

/// p', at least the minimum, and q = sqrt(3/2 s : s) of a stress, Pa.
struct Invariants {
  Real pressure, q;
};
inline Invariants invariants(SymTensor<3> stress, Real min_pressure)
{
  const Real mean = trace(stress) / 3;
  for (int k = 0; k < 3; ++k) stress[k] -= mean;
  return {std::max(-mean, min_pressure), std::sqrt(1.5 * double_dot(stress, stress))};
}

/// p' after an elastic volumetric strain (compression positive), Pa.
template <class T>
struct PressureAfter {
  using Mask = decltype(T{} < T{});
  T value, change;  ///< p', and its derivative with respect to the strain
  T part;           ///< the strain over the index: log(p') grows by it where
  Mask free;        ///< neither the floor nor the cap acts
};

template <class T>
[[gnu::always_inline]] inline PressureAfter<T> pressure_after(const PressureElasticity& elastic, const T& begin, const T& strain)
{
  using Mask = decltype(T{} < T{});
  const T part = strain * elastic.per_index, power = exponential(part), least = T{} + elastic.min_pressure;
  const T grown = begin * (power - 1.), straight = part * elastic.max_pressure;
  const Mask capped = magnitude(grown) > magnitude(straight);
  const T end = begin + (capped ? straight : grown);
  const Mask floored = end < least;
  const T change = elastic.per_index * (capped ? T{} + elastic.max_pressure : begin * power);
  const Mask free = (magnitude(grown) <= magnitude(straight)) & (end >= least);
  return {floored ? least : end, floored ? T{} : change, part, free};
}

/// log(p') after the strain.
template <class T>
[[gnu::always_inline]] inline T logarithm_of(const PressureAfter<T>& end, const T& log_begin)
{
  const T grown = log_begin + end.part;
  if (!any((end.free ? T{} : T{} + 1.) > T{})) [[likely]]
    return grown;
  return end.free ? grown : logarithm(end.value);
}

/// The shear modulus of an increment, Pa, and its derivative with respect to the second pressure (of first order in the growth of p'): the mean of p' that
/// grows exponentially, by the trapezoidal rule with its correction at the ends (relative error 5e-6 in the largest piece of an increment).
template <class T>
struct ShearModulus {
  T value, change;
};

template <class T>
[[gnu::always_inline]] inline ShearModulus<T> shear_modulus(const PressureElasticity& elastic, const T& begin, const PressureAfter<T>& end)
{
  const Real factor = elastic.per_index * elastic.shear_over_bulk;
  const T corrected = (begin + end.value) * 0.5 - end.part * (end.value - begin) * (1. / 12);
  const T mean = larger(corrected, smaller(begin, end.value)), most = T{} + elastic.max_pressure;
  const auto capped = mean > most;
  return {factor * (capped ? most : mean), capped ? T{} : factor * (0.5 - end.part * (1. / 6))};
}

/// An increment as a return to a surface in p' and q sees it, Pa: the elastic stress is deviator + 2 G strain, whose q = sqrt(3/2 s : s) has the square
/// deviator_square + G (mixed + G strain_square).
template <class T>
struct Trial {
  T pressure;                               ///< p' at the beginning
  T compression;                            ///< volumetric strain, compression positive
  T deviator_square, mixed, strain_square;  ///< 3/2 s : s, 6 s : e, 6 e : e

  /// q^2 of the elastic stress, and its derivative with respect to G.
  [[gnu::always_inline]] T q_square(const T& shear) const { return larger(deviator_square + shear * (mixed + shear * strain_square), T{}); }
  [[gnu::always_inline]] T q_square_change(const T& shear) const { return mixed + 2. * shear * strain_square; }
};

/// What remains of an increment: p', G, and the part of the elastic deviator that remains.
template <class T>
struct Returned {
  PressureAfter<T> pressure;
  ShearModulus<T> shear;
  T part;
};

/// Takes over the lanes of a mask.
template <class T, class Mask>
[[gnu::always_inline]] inline void take(const Mask& mask, Returned<T>& old, const PressureAfter<T>& p, const ShearModulus<T>& g)
{
  old.pressure.value = mask ? p.value : old.pressure.value;
  old.pressure.change = mask ? p.change : old.pressure.change;
  old.pressure.part = mask ? p.part : old.pressure.part;
  old.pressure.free = mask ? p.free : old.pressure.free;
  old.shear.value = mask ? g.value : old.shear.value;
  old.shear.change = mask ? g.change : old.shear.change;
}

/// A piece of an increment changes p' and q by at most this part of p', so that Newton's iteration converges; up to as many pieces.
constexpr Real max_change = 0.25, max_pieces = 256;

/// Advances `stress` (Pa, tension positive) by an increment, in equal pieces where it is large. return_to_surface(trial, returned, acts, s, e) gets the
/// elastic result of a piece and returns it to the law's surface; it changes the state variables of the lanes of the mask `acts`. The elastic deviator is
/// s + 2 G e.
template <int dim, class T, class Return>
[[gnu::always_inline]] inline void update_in_pieces(const PressureElasticity& elastic, SymTensor<dim, T>& stress,
                                                    const SymTensor<dim, T>& of_increment, const Return& return_to_surface)
{
  const T mean = trace(stress) * (1. / 3), third = trace(of_increment) * (1. / 3);
  SymTensor<dim, T> strain;
  for (int k = 0; k < tensor_size<dim>; ++k) {
    if (k < 3) stress[k] -= mean;
    strain[k] = k < 3 ? of_increment[k] - third : of_increment[k];
  }
  Trial<T> trial;
  trial.pressure = larger(-mean, T{} + elastic.min_pressure);
  trial.compression = -3. * third;
  trial.strain_square = 6. * double_dot(strain, strain);

  T pieces = T{} + 1.;
  const T across = elastic.shear_over_bulk * elastic.shear_over_bulk * trial.strain_square;
  const T bound =
      (2 * elastic.per_index * elastic.per_index) * (trial.compression * trial.compression + across);  // (a + b)^2 <= 2 (a^2 + b^2)
  if (any(bound > T{} + max_change * max_change)) [[unlikely]] {
    const T change = elastic.per_index * (magnitude(trial.compression) + square_root(across));
    while (any((change > pieces * max_change) & (pieces < T{} + max_pieces)))
      pieces = (change > pieces * max_change) & (pieces < T{} + max_pieces) ? pieces * 2. : pieces;
    const T piece = 1. / pieces;
    trial.compression *= piece;
    trial.strain_square *= piece * piece;
    for (int k = 0; k < tensor_size<dim>; ++k) strain[k] *= piece;
  }

  const T one = T{} + 1.;
  do {
    trial.deviator_square = 1.5 * double_dot(stress, stress);
    trial.mixed = 6. * double_dot(stress, strain);
    Returned<T> returned;
    returned.pressure = pressure_after(elastic, trial.pressure, trial.compression);
    returned.shear = shear_modulus(elastic, trial.pressure, returned.pressure);
    returned.part = one;
    const auto acts = pieces > T{};
    return_to_surface(trial, returned, acts, stress, strain);
    for (int k = 0; k < tensor_size<dim>; ++k)
      stress[k] = acts ? returned.part * (stress[k] + 2. * returned.shear.value * strain[k]) : stress[k];
    trial.pressure = acts ? returned.pressure.value : trial.pressure;
    pieces -= one;
  } while (any(pieces > T{}));
  for (int k = 0; k < 3; ++k) stress[k] -= trial.pressure;
}

}  // namespace berm::material
