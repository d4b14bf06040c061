// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "material/pressure_elasticity.hpp"

namespace berm::material {

/// The shape of a yield surface in the deviatoric plane.
enum class DeviatoricShape { circle, matsuoka_nakai };

/// Declares the key of the shape.
void describe_deviatoric_shape(Describe& d, DeviatoricShape& shape);

/// How the slope M(theta) of q / p' depends on the direction of the deviator, c = cos(3 theta) = 1 in triaxial compression, -1 in extension. I1 I2 / I3 is
/// constant [Matsuoka and Nakai, Proc. JSCE 232 (1974)], which is
///
///   y^3 - (1 + b) y + b c = 0,   y = M / M(theta),   b = 2 sin(phi) (3 + sin(phi)) / (3 - sin(phi))^2,
///
/// with M and phi of triaxial compression; y is the largest root. b = 0 is the circle.
struct StrengthShape {
  Real b = 0;
  Real first[3] = {1, 0, 0};  ///< the parabola in c through y at c = -1, 0 and 1

  bool is_circle() const { return b == 0; }
};

StrengthShape strength_shape(DeviatoricShape shape, Real friction_angle);

/// M / M(theta) by four steps of Newton's method: to rounding for angles up to 45 degrees, 1e-8 at 69.
template <class T>
[[gnu::always_inline]] inline T slope_over_slope_there(const StrengthShape& shape, const T& c)
{
  T y = shape.first[0] + c * (shape.first[1] + c * shape.first[2]);
  for (int k = 0; k < 4; ++k) {
    const T square = y * y;
    y -= (y * (square - (1 + shape.b)) + shape.b * c) / (3. * square - (1 + shape.b));
  }
  return y;
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

/// q of a stress over M(theta) / M, Pa: that of the stress in triaxial compression which is as near to failure. p' is at least the minimum.
Invariants equivalent_invariants(const StrengthShape& shape, const SymTensor<3>& stress, Real min_pressure);

/// The update of a law whose surface is not a circle, apart from that of a circle, which must not become slower. Flow stays radial in the deviatoric plane, so
/// that theta of a piece of the increment is that of its elastic deviator. With q, the plastic deviatoric strain and the shear modulus multiplied by y, 1 / y
/// and y^2 the return is that to the circle.
template <int dim, class Law, class T>
[[gnu::noinline]] void update_along(const Law& law, SymTensor<dim, T>& stress, const SymTensor<dim, T>& strain, T* state)
{
  update_in_pieces<dim>(
      law.moduli, stress, strain,
      [&](const Trial<T>& trial, Returned<T>& returned, const auto& acts, SymTensor<dim, T> s, const SymTensor<dim, T>& e) {
        const T along = returned.shear.value, q_along = square_root(trial.q_square(along)), zero{}, one = T{} + 1.;
        for (int k = 0; k < tensor_size<dim>; ++k) s[k] += 2. * along * e[k];
        const T y = slope_over_slope_there(law.shape, cosine_of_three_theta(s, trial.pressure)), square = y * y;
        const Trial<T> equivalent = {trial.pressure, trial.compression, square * trial.deviator_square, square * trial.mixed,
                                     square * trial.strain_square};
        return_piece(law, equivalent, 3. * square, acts, returned, state);
        // The return changes G a little, and with it q, but not the direction.
        const T q = square_root(trial.q_square(returned.shear.value));
        returned.part = q_along > zero ? returned.part * q / (q_along > zero ? q_along : one) : returned.part;
        returned.shear.value = along;
      });
}

/// Advances `stress` (Pa, tension positive) by an increment, to the surface of a law with `moduli` and a `shape`. return_piece(law, trial, three, acts,
/// returned, state) returns the elastic result of a piece and changes the state variables of the lanes of the mask `acts`; q of the trial falls by three G
/// times the plastic deviatoric strain.
template <int dim, class Law, class T>
[[gnu::always_inline]] inline void update_with_shape(const Law& law, SymTensor<dim, T>& stress, const SymTensor<dim, T>& strain, T* state)
{
  if (law.shape.is_circle()) [[likely]] {
    update_in_pieces<dim>(law.moduli, stress, strain,
                          [&](const Trial<T>& trial, Returned<T>& returned, const auto& acts, const SymTensor<dim, T>&,
                              const SymTensor<dim, T>&) { return_piece(law, trial, 3., acts, returned, state); });
    return;
  }
  // Of copies, so that what the circle works on stays in registers.
  SymTensor<dim, T> own_stress = stress;
  const SymTensor<dim, T> own_strain = strain;
  T own_state[Law::state_size];
  std::copy_n(state, Law::state_size, own_state);
  update_along<dim>(law, own_stress, own_strain, own_state);
  stress = own_stress;
  std::copy_n(own_state, Law::state_size, state);
}

}  // namespace berm::material
