// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/increment.hpp"
#include "material/law_answers.hpp"
#include "material/mohr_coulomb_return.hpp"

namespace berm::material {

/// Linear elasticity with the Mohr-Coulomb strength, as the user gives it. Angles in radians, stresses in Pa, tension positive:
///
///   f = (s1 - s3)/2 + (s1 + s3)/2 sin(friction_angle) - cohesion cos(friction_angle) <= 0,   s1 <= tension_cutoff,   s1 >= s2 >= s3.
///
/// Perfectly plastic; flow on the planes of f follows the same planes with the dilation angle, flow on the tension planes is associated.
/// friction_angle = 0 is Tresca with the undrained strength su = cohesion. Cones: de Souza Neto, Peric and Owen, Computational Methods for
/// Plasticity (2008), section 8.2.
///
/// Soil that cannot carry tension comes apart. A particle keeps one number for it, the `opening` >= 0: the volumetric strain by which it has come
/// apart. Where the returned stress is the apex (three equal principal stresses), the volumetric plastic strain (p_trial - p_apex) / K of the
/// increment is added to the opening. While the opening lasts, the stress is the apex, volumetric strain changes the opening only and shear does
/// nothing. An increment that closes it is split at that moment, and its rest acts on closed soil. So soil that fell apart and comes together again
/// carries load when it is closed and not before. The work p_apex x opening is given back on closing: no cycle of opening and closing makes
/// energy, and for c = 0 no work is done at all. The opening is bounded by max_opening, beyond which expansion is forgotten; 0 is plain
/// Mohr-Coulomb.
struct MohrCoulomb {
  static constexpr const char* word = "mohr_coulomb";
  static constexpr int state_size = 1;

  Real density = 0;                     ///< kg/m3, of the weight
  std::optional<Real> inertia_density;  ///< kg/m3; empty: density
  Real young_modulus = 0;               ///< Pa
  Real poisson_ratio = 0;
  Real cohesion = 0;                   ///< Pa
  Real cohesion_gradient = 0;          ///< Pa/m, growth of the cohesion with the depth below the bed's surface at the start
  Real friction_angle = 0;             ///< rad
  Real dilation_angle = 0;             ///< rad
  std::optional<Real> tension_cutoff;  ///< Pa; absent, or above the apex c cot(phi): the cone alone
  std::optional<Real> max_opening;     ///< empty: 0.2 where the soil dilates, else 0
};

void describe(Describe& d, MohrCoulomb& law);

/// The dilation angle is not larger than the friction angle.
void check(Describe& d, const std::string& path, const MohrCoulomb& law);

inline Elasticity elasticity(const MohrCoulomb& law)
{
  return elasticity(law.young_modulus, law.poisson_ratio);
}

inline std::string law_name(const MohrCoulomb& law)
{
  return law.friction_angle == 0 ? "Tresca" : "Mohr-Coulomb";
}

PreparedMohrCoulomb prepare(const MohrCoulomb& law);

/// Soil that cannot come apart keeps an opening of zero, which no frame needs.
inline std::vector<FieldInfo> state_fields(const MohrCoulomb& law)
{
  const unsigned travel = prepare(law).max_opening > 0 ? everywhere : everywhere & ~to_frame;
  return {{"opening", "opening: volumetric strain by which the soil has come apart", "", 1, travel}};
}

inline std::optional<Strength> strength_at_rest(const MohrCoulomb& law)
{
  return Strength{law.cohesion, law.cohesion_gradient, law.friction_angle, law.dilation_angle};
}
std::optional<Real> shear_strength(const MohrCoulomb& law, Real middle, const Real* state);

inline bool dilates(const MohrCoulomb& law)
{
  return law.dilation_angle > 0;
}
inline bool non_associated(const MohrCoulomb& law)
{
  return law.dilation_angle < law.friction_angle;
}
inline std::string depth_key(const MohrCoulomb& law)
{
  return law.cohesion_gradient > 0 ? "cohesion_gradient" : "";
}

/// With a dilation angle of zero; it remembers the opening as before.
MohrCoulomb without_dilation(MohrCoulomb law);

/// How far a stress lies outside the surface, Pa: max(f, s1 - tension_cutoff), at most 0 inside.
Real yield_value(const PreparedMohrCoulomb& law, const SymTensor<2>& stress);
Real yield_value(const PreparedMohrCoulomb& law, const SymTensor<3>& stress);

/// The law at a depth (m) below the bed's surface: its cohesion has grown.
MohrCoulomb at_depth(MohrCoulomb law, Real depth);

/// The law whose flow is associated and which for one increment stands for this one, from a stress on (Krabbenhoft, Karim, Lyamin and Sloan, Int. J.
/// Numer. Meth. Engng 90, 2012): its friction angle is the dilation angle, and its cohesion such that the shear strength at the present mean of the
/// extreme principal stresses, (s1 + s3)/2, is the same; the largest tension is the same. A steady flow of the one is a steady flow of the other. The
/// law itself where its flow is associated.
MohrCoulomb associated(const MohrCoulomb& law, const SymTensor<2>& stress);

/// Advances `stress` (Pa, tension positive) by an increment, whatever its time: elastic predictor, then the exact implicit return to the surface. state[0] is the
/// opening. Lanes without a particle may hold any numbers. T should fit a register of the machine: Real or LanePart.
template <int dim, class T>
[[gnu::always_inline]] inline void update(const PreparedMohrCoulomb& law, SymTensor<dim, T>& stress, const Increment<dim, T>& increment,
                                          T* state)
{
  using Mask = decltype(T{} < T{});
  T& opening = state[0];
  SymTensor<dim, T> strain = increment.strain;
  const Mask was_open = opening > T{};
  if (any(was_open)) [[unlikely]] {
    const T volume = trace(strain), left = opening + volume, one = T{} + 1.;
    const Mask stays_open = was_open & (left > T{}), closes = was_open & (left <= T{});
    const T part_after_closing = closes ? left / (closes ? volume : one) : (stays_open ? T{} : one);
    const T apex = law.apex - T{};
    for (int k = 0; k < tensor_size<dim>; ++k) {
      strain[k] *= part_after_closing;
      stress[k] = was_open ? (k < 3 ? apex : T{}) : stress[k];
    }
    opening = stays_open ? smaller(left, law.max_opening - T{}) : T{};
  }
  add_elastic_stress(law.elastic, stress, strain);
  return_to_surface(law, stress, opening);
}

}  // namespace berm::material
