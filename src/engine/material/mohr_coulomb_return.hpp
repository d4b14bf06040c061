// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/axis_and_circle.hpp"
#include "material/elasticity.hpp"

namespace berm::material {

/// Precomputed constants of MohrCoulomb. With m = ((1 + sin psi)/2, 0, -(1 - sin psi)/2) the flow direction on the face f =
/// weight_1 s1 - weight_3 s3 - strength, a plastic multiplier g lowers the principal stresses by g (drop_1, drop_2, drop_3)
/// = g C m.
///
/// What does not change with cohesion and Young's modulus: drop_... and per_... are those of the law's own modulus, since only their products matter.
struct MohrCoulombConstants {
  Real sin_friction = 0, cos_friction = 1;
  Real weight_1 = 0, weight_3 = 0;  ///< (1 + sin phi)/2, (1 - sin phi)/2
  Real cutoff = infinity;           ///< tension cut-off, Pa
  Real max_opening = 0;             ///< 0 also where there is no apex
  Real per_young_modulus = 0;       ///< 1/Pa
  Real cohesion_share = 1;          ///< the cohesion over that which a particle keeps

  Real drop_1 = 0, drop_2 = 0, drop_3 = 0;       ///< C m, Pa
  Real drop_high = 0, drop_low = 0;              ///< means of drop_1 and drop_2, of drop_2 and drop_3
  Real per_face = 0, per_high = 0, per_low = 0;  ///< plastic multiplier per Pa of f: on the face, on the edges s1 = s2 and s2 = s3
  Real pull_one = 0, pull_two = 0;               ///< reduction of the other principal stresses per Pa of the one or two that are cut
  Real line_1 = 0, line_3 = 0;                   ///< reduction of s2 per Pa of s1 and of s3 on the line where face and cut-off meet
  Real inner_cone = 1;                           ///< sqrt(1 + sin2 phi / 3): f <= inner_cone sqrt(J2) + p sin phi - strength
};

/// All of them; N is a vector where particles have a cohesion and a Young's modulus of their own.
template <class N>
struct PreparedMohrCoulombOf : MohrCoulombConstants {
  static constexpr int state_size = 1, local_size = 2;

  ElasticityOf<N> elastic;
  N strength{};                  ///< c cos phi, Pa
  N tension = infinity - N{};    ///< cut-off, Pa; infinity where the cone ends below it
  N cone_apex = infinity - N{};  ///< c cot phi, Pa
  N apex = infinity - N{};       ///< maximum mean stress, Pa
  N cut_3{};                     ///< s3 where the face meets the cut-off s1 = tension, Pa

  /// Sets what follows from the cohesion.
  [[gnu::always_inline]] void set_cohesion(const N& cohesion)
  {
    strength = cohesion * cos_friction;
    if (sin_friction > 0) cone_apex = strength / sin_friction;
    if (cutoff < infinity) {
      const auto cuts = cone_apex > cutoff;
      tension = cuts ? cutoff - N{} : tension;
      cut_3 = (weight_1 * cutoff - strength) / weight_3;
    }
    apex = smaller(tension, cone_apex);
  }
};
using PreparedMohrCoulomb = PreparedMohrCoulombOf<Real>;

/// The law with the cohesion own[0] and Young's modulus own[1], Pa, of each lane.
template <class T>
[[gnu::always_inline]] inline PreparedMohrCoulombOf<T> with_local(const PreparedMohrCoulomb& law, const T* own)
{
  PreparedMohrCoulombOf<T> made{static_cast<const MohrCoulombConstants&>(law), scaled(law.elastic, own[1] * law.per_young_modulus)};
  made.set_cohesion(own[0] * law.cohesion_share);
  return made;
}

/// Returns principal trial stresses to the yield surface and gives the volumetric plastic strain of returns to the apex, 0
/// elsewhere. Stresses on or inside the surface are unchanged. Without branches over the lanes: face, two edges and apex of
/// the cone; then, where the tension exceeds the cut-off, its planes and their intersection with the cone. `strength`, Pa,
/// replaces law.strength; it may differ between lanes where the law has neither apex nor cut-off.
template <class N, class T, class S>
[[gnu::always_inline]] inline T return_principal(const PreparedMohrCoulombOf<N>& law, const S& strength, Principal<T>& s)
{
  using Mask = decltype(T{} < T{});
  const T s1 = s.s1, s2 = s.s2, s3 = s.s3;
  const T cone_apex = law.cone_apex - T{}, apex = law.apex - T{};

  const T f = law.weight_1 * s1 - law.weight_3 * s3 - strength;
  const T face = f * law.per_face;
  const T face_1 = s1 - face * law.drop_1, face_2 = s2 - face * law.drop_2, face_3 = s3 - face * law.drop_3;
  const T mean_12 = (s1 + s2) * 0.5, mean_23 = (s2 + s3) * 0.5;
  const T high = (law.weight_1 * mean_12 - law.weight_3 * s3 - strength) * law.per_high;
  const T high_1 = mean_12 - high * law.drop_high, high_3 = s3 - high * law.drop_3;
  const T low = (law.weight_1 * s1 - law.weight_3 * mean_23 - strength) * law.per_low;
  const T low_1 = s1 - low * law.drop_1, low_3 = mean_23 - low * law.drop_low;

  // A stress on an edge is beyond the apex where its smaller principal stress is above it.
  const Mask outside = f > T{}, above = face_2 > face_1, below = face_2 < face_3;
  const Mask on_high = above & (high_3 <= cone_apex), on_low = below & (low_3 <= cone_apex), off_face = above | below;
  T r1 = on_low ? low_1 : (on_high ? high_1 : (off_face ? cone_apex : face_1));
  T r2 = on_low ? low_3 : (on_high ? high_1 : (off_face ? cone_apex : face_2));
  T r3 = on_low ? low_3 : (on_high ? high_3 : (off_face ? cone_apex : face_3));
  r1 = outside ? r1 : s1;
  r2 = outside ? r2 : s2;
  r3 = outside ? r3 : s3;

  const T tension = law.tension - T{};
  if (any(law.tension < infinity)) {
    const Mask cut = r1 > tension;
    if (any(cut)) {
      const T over_1 = s1 - tension, over_2 = s2 - tension;
      const T one_2 = s2 - law.pull_one * over_1, one_3 = s3 - law.pull_one * over_1;
      const T two_3 = s3 - law.pull_two * (over_1 + over_2);
      const T line_2 = s2 - law.line_1 * over_1 - law.line_3 * (s3 - law.cut_3);
      const T cut_3 = law.cut_3 - T{};
      const Mask two = one_2 > tension;
      const T cut_only_2 = two ? tension : one_2, cut_only_3 = two ? smaller(two_3, tension) : one_3;
      const Mask with_cone = cut_only_3 < cut_3;
      r1 = cut ? tension : r1;
      r2 = cut ? (with_cone ? smaller(larger(line_2, cut_3), tension) : cut_only_2) : r2;
      r3 = cut ? (with_cone ? cut_3 : cut_only_3) : r3;
    }
  }

  s = {r1, r2, r3};
  if (law.max_opening > 0) {
    // Uniaxial stretching of stress-free soil ends exactly at the corner of the cut-off; rounding must not decide.
    constexpr Real rounding = 1e-10;
    const Mask at_apex = (outside | (s1 > tension)) & (r3 >= apex - rounding * magnitude(s1 - apex));
    const T opened = ((s1 + s2 + s3) * (1. / 3) - apex) * (1 / law.elastic.bulk);
    s.s1 = at_apex ? apex : r1;
    s.s2 = at_apex ? apex : r2;
    s.s3 = at_apex ? apex : r3;
    return at_apex ? larger(opened, T{}) : T{};
  }
  return T{};
}

/// Returns a trial stress of plane strain to the yield surface; the volumetric plastic strain at the apex is added to the
/// opening.
template <class N, class T, class S>
[[gnu::always_inline]] inline void return_to_surface(const PreparedMohrCoulombOf<N>& law, const S& strength, SymTensor<2, T>& stress,
                                                     T& opening)
{
  using Mask = decltype(T{} < T{});
  const T mean = (stress[0] + stress[1]) * 0.5, half = (stress[0] - stress[1]) * 0.5, z = stress[2];
  const T radius = square_root(half * half + stress[3] * stress[3]);
  const T a = mean + radius, b = mean - radius;
  Principal<T> s{larger(a, z), T{}, smaller(b, z)};
  const T f = law.weight_1 * s.s1 - law.weight_3 * s.s3 - strength;
  const Mask outside = (f > T{}) | (s.s1 > law.tension);
  if (!any(outside)) [[likely]]
    return;

  s.s2 = larger(b, smaller(a, z));
  const Mask z_first = z > a, z_last = z < b;
  const T opened = return_principal(law, strength, s);
  const T new_z = z_first ? s.s1 : (z_last ? s.s3 : s.s2);
  const T new_a = z_first ? s.s2 : s.s1, new_b = z_last ? s.s2 : s.s3;
  const T new_mean = (new_a + new_b) * 0.5;
  const T shrink = (new_a - new_b) * 0.5 / (radius > T{} ? radius : T{} + 1.);
  stress[0] = outside ? new_mean + shrink * half : stress[0];
  stress[1] = outside ? new_mean - shrink * half : stress[1];
  stress[2] = outside ? new_z : stress[2];
  stress[3] = outside ? shrink * stress[3] : stress[3];
  opening = smaller(opening + (outside ? opened : T{}), law.max_opening - T{});
}

/// Returns trial stresses in space that lie outside the yield surface. A separate function, because it is long and rarely needed.
template <class N, class T, class S>
[[gnu::noinline]] void return_by_axes(const PreparedMohrCoulombOf<N>& law, const S& strength, SymTensor<3, T>& stress, T& opening)
{
  using Mask = decltype(T{} < T{});
  const AxisAndCircle<T> trial = axis_and_circle(stress);
  Principal<T> s = principal(trial);
  const Mask outside = (law.weight_1 * s.s1 - law.weight_3 * s.s3 - strength > T{}) | (s.s1 > law.tension);
  if (!any(outside)) return;
  const T opened = return_principal(law, strength, s);
  opening = smaller(opening + (outside ? opened : T{}), law.max_opening - T{});
  const SymTensor<3, T> returned = with_principal(trial, s);
  for (int k = 0; k < 6; ++k) stress[k] = outside ? returned[k] : stress[k];
}

/// Returns a trial stress in space to the yield surface. The check uses the cone inscribed in the pyramid, which needs no
/// principal stresses.
template <class N, class T, class S>
[[gnu::always_inline]] inline void return_to_surface(const PreparedMohrCoulombOf<N>& law, const S& strength, SymTensor<3, T>& stress,
                                                     T& opening)
{
  const T mean = trace(stress) * (1. / 3);
  SymTensor<3, T> deviator = stress;
  for (int k = 0; k < 3; ++k) deviator[k] -= mean;
  const T size = square_root(double_dot(deviator, deviator) * 0.5);
  const auto outside = (law.inner_cone * size + (law.weight_1 - law.weight_3) * mean - strength > T{}) |
                       (mean + 1.1547005383792517 * size > law.tension);  // 2/sqrt(3): s1 <= p + 2/sqrt(3) sqrt(J2)
  if (any(outside)) [[unlikely]]
    return_by_axes(law, strength, stress, opening);
}

/// With the law's own strength.
template <int dim, class N, class T>
[[gnu::always_inline]] inline void return_to_surface(const PreparedMohrCoulombOf<N>& law, SymTensor<dim, T>& stress, T& opening)
{
  return_to_surface(law, law.strength, stress, opening);
}

}  // namespace berm::material
