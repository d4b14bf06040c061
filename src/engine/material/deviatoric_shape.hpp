// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "material/pressure_elasticity.hpp"

namespace berm::material {

/// The shape of the yield surface in the deviatoric plane.
///
/// matsuoka_nakai: in place of q = sqrt(3/2 s : s) the surface has the q of triaxial compression with the same I1 I2 / I3 [Matsuoka and Nakai, Proc. JSCE
/// 232 (1974); Matsuoka, Yao and Sun, Soils and Foundations 39 (1999)]. With c = cos(3 theta), 1 in triaxial compression and -1 in extension, and the
/// stress ratios m = q / p' of the equivalent and n = q / p' of the stress itself, y = m / n is the largest root of
///
///   y^3 - (1 + b) y + b c = 0,   b = m (3 + m) / 9.
///
/// The friction angle of triaxial extension is then that of compression, at the critical state and at a peak.
enum class DeviatoricShape { circle, matsuoka_nakai };

/// Declares the key of the shape.
void describe_deviatoric_shape(Describe& d, DeviatoricShape& shape);

/// y at the equivalent stress ratio m, by four steps of Newton's method from the parabola in c through its values at -1, 0 and 1: to 1e-11. Beyond 59 degrees
/// it is that of 59 degrees.
template <class T>
[[gnu::always_inline]] inline T equivalent_over_actual(const T& m, const T& c)
{
  const T steepest = T{} + 2.4, level = smaller(m, steepest), b = level * (level + 3.) * (1. / 9), one_b = b + 1.;
  const T middle = square_root(one_b), sixth = level * (1. / 6);
  T y = middle + c * (c * (1. + sixth - middle) - sixth);
  for (int k = 0; k < 4; ++k) {
    const T square = y * y;
    y -= (y * (square - one_b) + b * c) / (3. * square - one_b);
  }
  return y;
}

/// m of the stress ratio n, in closed form; beyond n = 2.8, which no soil has, of 2.8.
template <class T>
[[gnu::always_inline]] inline T equivalent_ratio(const T& ratio, const T& c)
{
  const T most = T{} + 2.8, n = smaller(ratio, most), v = 3. - c * n, d = 9. - n * n;
  return n * (n * v + square_root(v * (n * n * v + 12. * d))) / (2. * d);
}

/// cos(3 theta) of a deviator s, Pa, tension positive: -27/2 det(s) / q^3. Where q is less than a thousandth of p' it tends to that of triaxial compression.
template <int dim, class T>
[[gnu::always_inline]] inline T cosine_of_three_theta(const SymTensor<dim, T>& s, const T& pressure)
{
  T determinant = s[2] * (s[0] * s[1] - s[3] * s[3]);
  if constexpr (dim == 3) determinant += s[4] * (2. * s[3] * s[5] - s[0] * s[4]) - s[1] * s[5] * s[5];
  const T q_square = 1.5 * double_dot(s, s), small = pressure * 1e-3, least = small * small * small;
  return (least - 13.5 * determinant) / (least + q_square * square_root(q_square));
}

/// p', at least the minimum, and the q which the surface of this shape has, Pa.
Invariants equivalent_invariants(DeviatoricShape shape, const SymTensor<3>& stress, Real min_pressure);

/// The law in a piece of an increment whose elastic deviator is s, Pa, tension positive: the law itself, unless it goes with the direction.
template <int dim, class Law, class T>
[[gnu::always_inline]] inline const Law& in_direction(const Law& law, const SymTensor<dim, T>& /*s*/, const T& /*pressure*/)
{
  return law;
}

/// The update of a law whose surface is not a circle, apart from that of a circle, which must not become slower. Flow stays radial in the deviatoric plane, so
/// that theta of a piece of the increment is that of its elastic deviator. With q, the plastic deviatoric strain and the shear modulus multiplied by y, 1 / y
/// and y^2 the return is that to the circle; y is that of its end.
template <int dim, class Law, class T>
[[gnu::noinline]] void update_along(const Law& law, SymTensor<dim, T>& stress, const SymTensor<dim, T>& strain, T* state)
{
  constexpr int most_passes = 10;
  constexpr Real small_change = 1e-6;
  update_in_pieces<dim>(
      law.moduli, stress, strain,
      [&](const Trial<T>& trial, Returned<T>& returned, const auto& acts, SymTensor<dim, T> s, const SymTensor<dim, T>& e) {
        const Returned<T> elastic = returned;
        T begin[Law::state_size];
        std::copy_n(state, Law::state_size, begin);
        const T along = elastic.shear.value, q_along = square_root(trial.q_square(along)), zero{}, one = T{} + 1.;
        const T least_slope = zero - 4., most_slope = zero + 0.5;
        for (int k = 0; k < tensor_size<dim>; ++k) s[k] += 2. * along * e[k];
        const T c = cosine_of_three_theta(s, trial.pressure);
        const auto& here = in_direction<dim>(law, s, trial.pressure);
        const auto shaped = [&](const T& m) { return law.shape == DeviatoricShape::circle ? one : equivalent_over_actual(m, c); };
        T y = shaped(equivalent_ratio(T(q_along / elastic.pressure.value), c)), q{}, last{}, slope{};
        auto left = acts;
        for (int pass = 0; pass < most_passes; ++pass) {
          const T square = y * y;
          const Trial<T> equivalent = {trial.pressure, trial.compression, square * trial.deviator_square, square * trial.mixed,
                                       square * trial.strain_square};
          returned = elastic;
          std::copy_n(begin, Law::state_size, state);
          return_piece(here, equivalent, T(3. * square), acts, returned, state);
          q = returned.part * square_root(trial.q_square(returned.shear.value));
          if (pass == 0) {
            left = left & (returned.part < one);  // y of the elastic stress is exact
            if (!any(left)) break;
          }
          const T change = shaped(T(y * q / returned.pressure.value)) - y;
          left = left & (magnitude(change) > T{} + small_change);
          if (!any(left)) break;
          // The secant method, where the step before was not rounding.
          const auto known = magnitude(last) > T{} + small_change;
          slope = known ? smaller(larger(slope + change / (known ? last : one), least_slope), most_slope) : slope;
          last = left ? change / (1. - slope) : zero;
          y += last;
        }
        // The return changes G a little, and with it q, but not the direction.
        returned.part = q_along > zero ? q / (q_along > zero ? q_along : one) : returned.part;
        returned.shear.value = along;
      });
}

/// The same of copies, so that what the circle works on stays in registers.
template <int dim, class Law, class T>
[[gnu::always_inline]] inline void update_copies_along(const Law& law, SymTensor<dim, T>& stress, const SymTensor<dim, T>& strain, T* state)
{
  SymTensor<dim, T> own_stress = stress;
  const SymTensor<dim, T> own_strain = strain;
  T own_state[Law::state_size];
  std::copy_n(state, Law::state_size, own_state);
  update_along<dim>(law, own_stress, own_strain, own_state);
  stress = own_stress;
  std::copy_n(own_state, Law::state_size, state);
}

/// Advances `stress` (Pa, tension positive) by an increment, to the surface of a law with `moduli` and a `shape`. return_piece(law, trial, three, acts,
/// returned, state) returns the elastic result of a piece and changes the state variables of the lanes of the mask `acts`; q of the trial falls by three G
/// times the plastic deviatoric strain.
template <int dim, class Law, class T>
[[gnu::always_inline]] inline void update_with_shape(const Law& law, SymTensor<dim, T>& stress, const SymTensor<dim, T>& strain, T* state)
{
  if (law.shape == DeviatoricShape::circle) [[likely]] {
    update_in_pieces<dim>(law.moduli, stress, strain,
                          [&](const Trial<T>& trial, Returned<T>& returned, const auto& acts, const SymTensor<dim, T>&,
                              const SymTensor<dim, T>&) { return_piece(law, trial, 3., acts, returned, state); });
    return;
  }
  update_copies_along<dim>(law, stress, strain, state);
}

}  // namespace berm::material
