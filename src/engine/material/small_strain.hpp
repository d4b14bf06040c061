// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dual.hpp"
#include "core/lanes.hpp"
#include "core/tensor.hpp"

namespace berm::material {

/// Stiffness at small strains (Hardin and Drnevich 1972): in first loading, with the shear strain g = sqrt(3/2 e : e) of the deviatoric strain e (s1 - s3 of
/// the triaxial test; 0.87 of the shear strain of simple shear),
///
///   G = G_0 / (1 + a g)^2, the tangent of tau = G_0 g / (1 + a g),   G >= G_ur,   a = 0.385 / gamma_07: the secant at gamma_07 is 0.722 G_0.
///
/// After a reversal g is half of the strain from the turning point (Masing 1926). Strain that comes back by less than a tenth of the largest g of its branch,
/// as in vibration, has that stiffness to and fro and forgets it once it is beyond the turning point; more is a reversal, and e begins anew at the turning
/// point. Soil that comes back to the point at which it left first loading goes on with it there, and with first loading in the other direction when it is
/// twice the largest strain of first loading away. Positions on branches are measured along them.
///
/// History: e (xx yy zz xy yz zx, which rotate with the soil); the largest g of the branch; the farthest way back from it; the largest g of first loading; and how far from the point
/// where first loading was left the branch began: positive if it leads away from there, negative if back, zero in first loading.
struct SmallStrain {
  static constexpr int size = 10;

  Real ratio = 1;       ///< G_0 / G_ur; 1: none
  Real per_strain = 0;  ///< a
};

/// Over G_ur: the mean shear modulus of an increment, and the smallest of first loading so far.
template <class T>
struct Stiffening {
  T mean, least;
};

/// g of a deviatoric strain.
template <int dim, class T>
[[gnu::always_inline]] inline T shear_size(const SymTensor<dim, T>& deviator)
{
  return square_root(1.5 * double_dot(deviator, deviator));
}

/// Adds a deviatoric strain increment to the history, in the lanes of the mask.
template <int dim, class T, class Mask>
[[gnu::always_inline]] inline Stiffening<T> add_strain(const SmallStrain& law, T* history, const SymTensor<dim, T>& increment,
                                                       const Mask& acts)
{
  constexpr Real reversal = 0.1, smallest = 1e-100;
  const T zero{}, one = T{} + 1., farthest = history[6], retreat = history[7], loading = history[8], start = history[9];
  SymTensor<dim, T> e, next, turned;
  for (int k = 0; k < tensor_size<dim>; ++k) e[k] = history[k];
  const T g = shear_size(e), to_turning_point = farthest / larger(g, zero + smallest);
  for (int k = 0; k < tensor_size<dim>; ++k) {
    next[k] = e[k] + increment[k];
    turned[k] = next[k] - to_turning_point * e[k];
  }
  const T g_next = shear_size(next), back = shear_size(turned);
  const auto inward = double_dot(e, increment) < zero, reverses = inward & (back > reversal * farthest);

  // Outward: first back to the turning point, then along the branch, then in first loading.
  const auto first = (start <= zero) & (start >= zero), away = start > zero;
  const T from = magnitude(start), length = away ? 2. * loading - from : from, branch_end = first ? farthest : larger(length, farthest);
  const T advance = g_next - g, per_advance = one / (advance > zero ? advance : one);
  const T inside = smaller(g_next, farthest) - g, along = larger(smaller(g_next, branch_end) - farthest, zero);
  const auto still = advance <= zero, at_front = g_next >= farthest;
  const T of_inside = still ? (at_front ? zero : one) : inside * per_advance;
  const T of_branch = still ? (at_front ? (first ? zero : one) : zero) : along * per_advance;
  const auto loads = at_front & (first | (g_next > branch_end));
  const T loaded = loads ? (first ? g_next : loading + (g_next - branch_end)) : loading;

  const auto secant = [&](const T& a, const T& b) { return one / ((1. + law.per_strain * a) * (1. + law.per_strain * b)); };
  const T outside = farthest - g, left = larger(farthest - g_next, zero);
  const T begin = 0.5 * (inward ? outside : retreat - outside);
  const T end = 0.5 * (reverses ? back : (inward ? left : retreat - left));
  const T in_loading = larger(1. - of_inside - of_branch, zero);
  const T inner = secant(larger(begin, zero), larger(end, zero));
  const T mean = inward ? inner
                        : of_inside * inner + of_branch * secant(0.5 * farthest, 0.5 * smaller(larger(g_next, farthest), branch_end)) +
                              in_loading * secant(first ? farthest : loading, loaded);

  const auto resumes = loads & !inward, onward = at_front & !inward;
  const T scale = (resumes & !first) ? loaded / larger(g_next, zero + smallest) : one;
  const auto store = [&](T& number, const T& value) { number = acts ? value : number; };
  for (int k = 0; k < tensor_size<dim>; ++k) store(history[k], reverses ? turned[k] : scale * next[k]);
  const T now = resumes ? loaded : loading;
  store(history[6], reverses ? back : (resumes ? loaded : (onward ? g_next : farthest)));
  store(history[7], reverses | onward ? zero : (inward ? larger(retreat, left) : retreat));
  store(history[8], now);
  const T begun = first ? zero + smallest : (away ? -(from + farthest) : larger(from - farthest, zero + smallest));
  store(history[9], reverses ? begun : (resumes ? zero : start));

  const T of_now = 1. + law.per_strain * now;
  return {larger(law.ratio * mean, one), larger(law.ratio / (of_now * of_now), one)};
}

}  // namespace berm::material
