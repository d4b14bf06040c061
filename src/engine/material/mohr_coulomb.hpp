// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/depth_profile.hpp"
#include "material/increment.hpp"
#include "material/law_queries.hpp"
#include "material/mohr_coulomb_return.hpp"

namespace berm::material {

/// Linear elasticity with Mohr-Coulomb strength, perfectly plastic. Angles in radians, stresses in Pa, tension positive:
///
///   f = (s1 - s3)/2 + (s1 + s3)/2 sin(friction_angle) - cohesion cos(friction_angle) <= 0,   s1 <= tension_cutoff,   s1 >= s2 >= s3.
///
/// The flow on the planes of f has the dilation angle; that on the tension planes is associated. friction_angle = 0 is
/// Tresca with s_u = cohesion. Source: de Souza Neto, Peric and Owen, Computational Methods for Plasticity (2008), section
/// 8.2.
///
/// State: the `opening` >= 0, the volumetric strain by which the soil has come apart and which must close before it carries
/// load again (docs/theory/soil_and_contact.md, Opening and bounds of volume).
struct MohrCoulomb {
  static constexpr const char* word = "mohr_coulomb";
  static constexpr const char* strength_key = "cohesion";
  static constexpr int state_size = 1;

  Real density = 0;                     ///< kg/m3, gives the weight
  std::optional<Real> inertia_density;  ///< kg/m3, gives the inertia; empty: density
  Real young_modulus = 0;               ///< Pa
  Real poisson_ratio = 0;
  Real cohesion = 0;                   ///< Pa
  Real cohesion_gradient = 0;          ///< Pa/m, increase with depth below the bed's surface at the start
  Real friction_angle = 0;             ///< rad
  Real dilation_angle = 0;             ///< rad
  std::optional<Real> tension_cutoff;  ///< Pa; empty or above the apex c cot(phi): the cone alone
  std::optional<Real> band_width;      ///< m, of shear bands
  std::optional<Real> d50;             ///< m, of the grains: bands are 15 of them wide
  std::optional<Real> max_opening;     ///< upper bound of the opening; empty: 0.2 where the soil dilates, else 0
  Real young_modulus_gradient = 0;     ///< Pa/m, increase with depth
  ProfileOf<MohrCoulomb> profile = {};
  std::optional<Shansep> shansep = {};  ///< instead of the cohesion, where friction_angle is 0
  Real cohesion_share = 1;              ///< of this law: the cohesion over that which particles keep (regularised_for)
  std::optional<PoreWater> water = {};

  bool operator==(const MohrCoulomb&) const = default;
};

inline StrengthAtDepth strength_at_depth(MohrCoulomb& law)
{
  return {&law.cohesion, &law.cohesion_gradient};
}

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

/// Soil that cannot open keeps an opening of zero, which frames leave out.
inline std::vector<FieldInfo> state_fields(const MohrCoulomb& law)
{
  const unsigned travel = prepare(law).max_opening > 0 ? everywhere : everywhere & ~to_frame;
  return {{"opening", "opening: volumetric strain of the separated soil", "", 1, travel}};
}

inline std::optional<Strength> strength_at_rest(const MohrCoulomb& law)
{
  return Strength{law.cohesion, law.cohesion_gradient, law.friction_angle, law.dilation_angle};
}
/// Empty where flow is associated: then bands lose nothing.
std::optional<Real> band_width(const MohrCoulomb& law);
MohrCoulomb with_grain_size(MohrCoulomb law, Real d50);
/// Friction and cohesion fall by the same share. [Davis 1968]
MohrCoulomb regularised_for(MohrCoulomb law, Real size);

/// Cohesion, tan(friction_angle) and tension cut-off over the factor; the dilation angle stays, but is at most the friction angle.
std::optional<MohrCoulomb> with_strength_over(MohrCoulomb law, Real factor);

std::optional<Real> shear_strength(const MohrCoulomb& law, Real middle, const Real* state);

inline bool dilates(const MohrCoulomb& law)
{
  return law.dilation_angle > 0;
}
inline bool non_associated(const MohrCoulomb& law)
{
  return law.dilation_angle < law.friction_angle;
}
/// With a dilation angle of zero; the opening stays as it is.
MohrCoulomb without_dilation(MohrCoulomb law);

/// Distance of a stress from the yield surface, Pa: max(f, s1 - tension_cutoff), positive outside.
Real yield_value(const PreparedMohrCoulomb& law, const SymTensor<2>& stress);
Real yield_value(const PreparedMohrCoulomb& law, const SymTensor<3>& stress);

/// The associated law that replaces this one in an increment from a stress on (Krabbenhoft, Karim, Lyamin and Sloan, Int. J.
/// Numer. Meth. Engng 90, 2012): its friction angle is the dilation angle, its cohesion gives the same shear strength at the
/// present (s1 + s3)/2, and the tension cut-off is the same. Their steady flows coincide. The law itself where its flow is
/// associated.
MohrCoulomb associated(const MohrCoulomb& law, const SymTensor<2>& stress);

/// Advances `stress` (Pa, tension positive) by an increment of any duration: elastic predictor, then the exact implicit
/// return to the yield surface. state[0] is the opening. Lanes without a particle may hold any numbers. T should fit a
/// register: Real or LanePart.
template <int dim, class N, class T>
[[gnu::always_inline]] inline void update(const PreparedMohrCoulombOf<N>& law, SymTensor<dim, T>& stress,
                                          const Increment<dim, T>& increment, T* state)
{
  using Mask = decltype(T{} < T{});
  T& opening = state[0];
  // That of a cell is the same for all its particles, and made once.
  SymTensor<dim, T> change = elastic_stress(law.elastic, increment.strain);
  const Mask was_open = opening > T{};
  if (any(was_open)) [[unlikely]] {
    const T volume = trace(increment.strain), left = opening + volume, one = T{} + 1.;
    const Mask stays_open = was_open & (left > T{}), closes = was_open & (left <= T{});
    const T fraction_after_closing = closes ? left / (closes ? volume : one) : (stays_open ? T{} : one);
    const T apex = law.apex - T{};
    for (int k = 0; k < tensor_size<dim>; ++k) {
      change[k] *= fraction_after_closing;
      stress[k] = was_open ? (k < 3 ? apex : T{}) : stress[k];
    }
    opening = stays_open ? smaller(left, law.max_opening - T{}) : T{};
  }
  for (int k = 0; k < tensor_size<dim>; ++k) stress[k] += change[k];
  return_to_surface(law, stress, opening);
}

}  // namespace berm::material
