// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/axis_and_circle.hpp"
#include "material/depth_profile.hpp"
#include "material/elasticity.hpp"
#include "material/increment.hpp"
#include "material/law_queries.hpp"

namespace berm::material {

/// Anisotropic undrained clay, NGI-ADP: strengths s_A, s_D, s_P and shear strains at failure in active (vertical compression), direct simple and passive
/// (vertical extension) shear; y is vertical. With R = (s_A + s_P)/2, r = R/s_D, the deviatoric stress s and T = diag(-2/3, 4/3, -2/3), the stretched stress
///
///   h = A s + c T,   A: xy and yz times r,   c = (1 - kappa) tau_0 + kappa (s_A - s_P)/2,
///   (h1 - h3)/2 <= kappa R,   kappa = 2 sqrt(x) / (1 + x) up to x = 1, beyond it 1,
///
/// which in plane strain is the ellipse ((s_yy - s_xx)/2 + c)^2 + (r s_xy)^2 <= (kappa R)^2. The plastic strain is along A h, in plane strain normal to the ellipse;
/// dx = d(g1 - g3) / gamma_f, g its A^-1-fold and gamma_f the plastic shear strain at failure in the direction of h, by an ellipse through those of the three
/// tests. [Grimstad, Andresen and Jostad 2012] (docs/theory/soil_and_contact.md, NGI-ADP)
///
/// State: x.
struct NgiAdp {
  static constexpr const char* word = "ngi_adp";
  static constexpr const char* strength_key = "undrained_strength";
  static constexpr int state_size = 1;
  static constexpr bool total_stress_alone = true;

  Real density = 0;                     ///< kg/m3, gives the weight
  std::optional<Real> inertia_density;  ///< kg/m3, gives the inertia; empty: density
  Real young_modulus = 0;               ///< Pa, of unloading and reloading; 0: by rigidity_index
  Real poisson_ratio = 0;
  std::optional<Real> rigidity_index;    ///< G / s_A, instead of young_modulus
  Real undrained_strength = 0;           ///< s_A, Pa
  Real undrained_strength_gradient = 0;  ///< Pa/m, increase with depth below the bed's surface at the start
  Real dss_ratio = 0;                    ///< s_D / s_A
  Real passive_ratio = 0;                ///< s_P / s_A
  Real active_failure_strain = 0;        ///< e1 - e3 from the start to failure, elastic and plastic
  Real dss_failure_strain = 0;
  Real passive_failure_strain = 0;
  Real initial_mobilisation = 0;    ///< tau_0 / s_A, tau_0 = (vertical less horizontal stress at rest)/2, compression positive
  Real young_modulus_gradient = 0;  ///< Pa/m, increase with depth
  ProfileOf<NgiAdp> profile = {};
  std::optional<Shansep> shansep = {};  ///< instead of undrained_strength
  std::optional<PoreWater> water = {};

  bool operator==(const NgiAdp&) const = default;
};

inline StrengthAtDepth strength_at_depth(NgiAdp& law)
{
  return {&law.undrained_strength, &law.undrained_strength_gradient};
}

void describe(Describe& d, NgiAdp& law);

/// Refuses stiffness given twice or not at all, a start beyond failure, and failure at strains that are elastic.
void check(Describe& d, const std::string& path, const NgiAdp& law);

/// With the strength at a depth (m) under the weight of the soil above (Pa), and the stiffness that goes with it.
NgiAdp at_depth(NgiAdp law, Real depth, Real weight_above = 0);

/// Of soil at the bed's surface.
Elasticity elasticity(const NgiAdp& law);
YoungPoisson young_poisson(const NgiAdp& law);

std::string law_name(const NgiAdp& law);
std::vector<FieldInfo> state_fields(const NgiAdp& law);

/// The least x whose surface holds the stress; 1 where none does.
void initial_state(const NgiAdp& law, const SymTensor<3>& stress, Real* state);

/// That in direct simple shear, which is near the mean of the three.
std::optional<Strength> strength_at_rest(const NgiAdp& law);

/// The three strengths over the factor; the stiffness, tau_0 and the strains at failure stay.
std::optional<NgiAdp> with_strength_over(NgiAdp law, Real factor);

/// What is the same for all particles; stresses over R.
struct NgiAdpConstants {
  Real per_strength = 1;                                 ///< R / s_A
  Real stretch = 1;                                      ///< r
  Real centre_begin = 0, centre_change = 0;              ///< c at kappa = 0, and what kappa = 1 adds to it
  Real active = 0, dss = 0, passive = 0;                 ///< strains at failure
  Real rise_active = 0, rise_dss = 0, rise_passive = 0;  ///< |shear stress at failure less that at the start|
  Real per_young_modulus = 0;                            ///< 1/Pa
};

/// Precomputed constants; N is a vector where particles have a strength and a Young's modulus of their own.
template <class N>
struct PreparedNgiAdpOf : NgiAdpConstants {
  static constexpr int state_size = 1, local_size = 2;

  ElasticityOf<N> elastic;
  N radius{}, per_radius{};  ///< R, Pa, and its inverse
  N axial{}, axial_odd{};    ///< R / (G gamma_f): half of the sum and of the difference of active and passive shear
  N along_planes{};          ///< the same of simple shear

  /// Sets what follows from s_A, Pa, and the moduli.
  [[gnu::always_inline]] void set_strength(const N& strength)
  {
    constexpr Real no_strength = 1e-6;    // Pa
    constexpr Real least_plastic = 1e-3;  // times R / G, where the strain at failure is elastic, which check refuses at the surface alone
    radius = larger(strength * per_strength, N{} + no_strength);
    per_radius = 1. / radius;
    const N index = elastic.shear * per_radius, least = N{} + least_plastic;
    const N of_active = 1. / larger(active * index - rise_active, least), of_passive = 1. / larger(passive * index - rise_passive, least);
    axial = 0.5 * (of_active + of_passive);
    axial_odd = 0.5 * (of_active - of_passive);
    along_planes = stretch / larger(dss * index - rise_dss, least);
  }
};
using PreparedNgiAdp = PreparedNgiAdpOf<Real>;

PreparedNgiAdp prepare(const NgiAdp& law);

/// The law with the strength own[0] and Young's modulus own[1], Pa, of each lane.
template <class T>
[[gnu::always_inline]] inline PreparedNgiAdpOf<T> with_local(const PreparedNgiAdp& law, const T* own)
{
  PreparedNgiAdpOf<T> made{static_cast<const NgiAdpConstants&>(law), scaled(law.elastic, own[1] * law.per_young_modulus)};
  made.set_strength(own[0]);
  return made;
}

/// (h1 - h3)/2 over R, and `scale` times its derivatives with respect to c and to the part that is left of the shear stress on horizontal planes; and the normal
/// stress on these from the middle of the largest Mohr circle, normal = (h1 + h3)/2 - h_yy.
template <class T>
struct StretchedShear {
  T value, scale, by_centre, by_part, normal;
};

/// The strain at failure in the direction whose stress on horizontal planes has, from the middle of the largest Mohr circle, this normal part and the root of `along2`
/// as shear stress: active shear, triaxial and plane, is at one end of the circle's diameter, passive shear at the other and simple shear on top.
template <class T>
struct FailureStrain {
  T size, share;  ///< of the circle; R / (G gamma_f) = share / size

  template <class N>
  [[gnu::always_inline]] FailureStrain(const PreparedNgiAdpOf<N>& law, const T& normal, const T& along2, const T& radius)
      : size(radius),
        share(square_root(law.axial * law.axial * normal * normal + law.along_planes * law.along_planes * along2) + law.axial_odd * normal)
  {
  }
};

/// A deviatoric stress over R whose shear stress on horizontal planes is r-fold: h without c.
template <int dim, class T>
struct StretchedStress;

/// Of plane strain and around an axis: (xx - yy)/2, zz - (xx + yy)/2 and xy.
template <class T>
struct StretchedStress<2, T> {
  T half, across, shear;

  [[gnu::always_inline]] StretchedStress(const SymTensor<2, T>& stress, const T& per_radius, const Real& stretch)
      : half((stress[0] - stress[1]) * (0.5 * per_radius)),
        across((stress[2] - 0.5 * (stress[0] + stress[1])) * per_radius),
        shear(stress[3] * (stretch * per_radius))
  {
  }

  [[gnu::always_inline]] StretchedShear<T> about(const T& centre, const T& part) const
  {
    constexpr Real smallest = 1e-100;
    const T x = half - centre, z = across - centre, y = shear * part;
    const T radius = square_root(x * x + y * y), scale = larger(radius, T{} + smallest), depth = magnitude(z);
    const auto out_of_plane = depth > radius;  // zz is the largest or the smallest
    const T share = out_of_plane ? T{} + 0.5 : T{} + 1., away = out_of_plane ? (z > T{} ? T{} - 0.5 : T{} + 0.5) : T{};
    return {share * radius + magnitude(away) * depth, scale, away * scale - share * x, share * y * shear, x + away * (radius - depth)};
  }

  template <class Mask>
  [[gnu::always_inline]] void write(SymTensor<2, T>& stress, const Mask& where, const T& radius, const T& centre, const T& left,
                                    const T& left_along) const
  {
    const T mean = trace(stress) * (1. / 3);
    const T x = radius * (centre + left * (half - centre)), z = radius * (centre + left * (across - centre));
    const T middle = mean - z * (1. / 3);
    stress[0] = where ? middle + x : stress[0];
    stress[1] = where ? middle - x : stress[1];
    stress[2] = where ? mean + z * (2. / 3) : stress[2];
    stress[3] = where ? left_along * stress[3] : stress[3];
  }
};

/// Of space: yy, the square of the shear stress in the horizontal plane, that on it, and what both together add to the third invariant.
template <class T>
struct StretchedStress<3, T> {
  T vertical, in_plane, along_planes, mixed;

  [[gnu::always_inline]] StretchedStress(const SymTensor<3, T>& stress, const T& per_radius, const Real& stretch)
  {
    const T half = (stress[0] - stress[2]) * (0.5 * per_radius), zx = stress[5] * per_radius;
    const T along = stretch * per_radius, xy = stress[3] * along, yz = stress[4] * along;
    vertical = (2. * stress[1] - stress[0] - stress[2]) * (per_radius * (1. / 3));
    in_plane = half * half + zx * zx;
    along_planes = xy * xy + yz * yz;
    mixed = half * (xy * xy - yz * yz) + 2. * zx * xy * yz;
  }

  [[gnu::always_inline]] StretchedShear<T> about(const T& centre, const T& part) const
  {
    constexpr Real smallest = 1e-100, root3 = 1.7320508075688772;
    constexpr Real smallest_sine = 1e-6;  // of three times the angle from an edge, where the derivative is that beside it
    const T n = vertical + centre * (4. / 3), part2 = part * part, v = along_planes * part2, n2 = n * n;
    const T j2 = larger(0.75 * n2 + in_plane + v, T{} + smallest);
    const T inner = 0.5 * along_planes * n + mixed, j3 = n * (0.25 * n2 - in_plane) + part2 * inner;
    const T root = square_root(j2), per = 1. / root, per2 = per * per;
    const T odd = j3 * per * per2 * (1.5 * root3), sine = smaller(magnitude(odd), T{} + 1.);
    const T x = cosine_of_third(sine), y = square_root(larger(1. - x * x, T{}));
    const T value = 0.5 * root3 * x + 0.5 * y;
    // value = cos(30 deg - a), cos(3 a) = sine
    const T slope = (0.5 * root3 * y - 0.5 * x) / (3. * larger(y * (3. - 4. * y * y), T{} + smallest_sine));
    const T by_j2 = per * (0.5 * value - 1.5 * slope * sine), by_j3 = (odd > T{} ? slope : -slope) * per2 * (1.5 * root3);
    const T by_n = by_j2 * 1.5 * n + by_j3 * (0.75 * n2 - in_plane + 0.5 * v);
    const T far_from_middle = root * (0.5 * y - 0.5 / root3 * x);  // (h1 + h3)/2 is -h2/2
    return {root * value, T{} + 1., by_n * (4. / 3), 2. * part * (by_j2 * along_planes + by_j3 * inner),
            (odd > T{} ? -far_from_middle : far_from_middle) - n};
  }

  template <class Mask>
  [[gnu::always_inline]] void write(SymTensor<3, T>& stress, const Mask& where, const T& radius, const T& centre, const T& left,
                                    const T& left_along) const
  {
    const T mean = trace(stress) * (1. / 3), moved = radius * centre * (1. - left);
    for (int k = 0; k < 6; ++k) {
      const T t = k == 1 ? mean - (4. / 3) * moved : mean + (2. / 3) * moved;
      const T now = k < 3 ? t + left * (stress[k] - mean) : (k == 5 ? left : left_along) * stress[k];
      stress[k] = where ? now : stress[k];
    }
  }
};

/// x over u, which is sqrt(x) up to failure and (1 + x)/2 beyond it, so that it is smooth, and linear where the soil is perfectly plastic; w = min(u, 1), with which
/// kappa = 2 w / (1 + w^2).
template <class T>
struct Mobilisation {
  T w, square, x;  ///< square: 1 + w^2

  [[gnu::always_inline]] explicit Mobilisation(const T& u) : w(smaller(u, T{} + 1.)), square(1. + w * w), x(w * w + 2. * (u - w)) {}

  [[gnu::always_inline]] T x_slope() const { return 2. * w; }
  [[gnu::always_inline]] T kappa_slope(const T& per_square) const { return 2. * (2. - square) * per_square * per_square; }
};
template <class T>
[[gnu::always_inline]] inline T mobilisation_root(const T& x)
{
  return x < T{} + 1. ? square_root(x) : 0.5 * (1. + x);
}

/// kappa and p, times share of the strain at failure, of a mobilisation that follows x_begin; what is left of the shear stress on horizontal planes over what is left
/// of the rest, (kappa + p)/(kappa + r^2 p).
template <class T>
struct Shares {
  T grown, plastic, kappa, part, per_square, per_along;

  [[gnu::always_inline]] Shares(const Mobilisation<T>& m, const T& x_begin, const FailureStrain<T>& failure, const Real& stretch2)
  {
    plastic = (m.x - x_begin) * failure.size;
    const T grown_square = 2. * failure.share * m.w, along = grown_square + stretch2 * plastic * m.square,
            inverse = 1. / (along * m.square);
    per_square = along * inverse;
    per_along = m.square * m.square * inverse;
    kappa = 2. * m.w * per_square;
    grown = grown_square * per_square;
    part = (grown + plastic) * per_along;
  }
};

/// The root of the return's equation, expanded to the second order at the trial: a d^2 + b d = c with d = u - u_begin up to failure, and a d = c with x beyond it.
template <class T>
[[gnu::always_inline]] inline T expected_root(const Mobilisation<T>& begin, const T& u_begin, const T& per_square,
                                              const FailureStrain<T>& failure, const StretchedShear<T>& trial, const Real& centre_change,
                                              const Real& stretch2)
{
  const T one = T{} + 1., kappa = 2. * begin.w * per_square, scale = trial.scale * failure.share;
  const T a = failure.size * trial.scale + (stretch2 - 1.) * trial.by_part, c = scale * (failure.size - kappa);
  const T b = failure.share * begin.kappa_slope(per_square) * (trial.scale - centre_change * trial.by_centre) + a * begin.x_slope();
  const T bend = 2. * begin.w * (begin.square - 4.) * per_square * per_square * per_square;  // half of the second derivative of kappa
  const T root = square_root(b * b + 4. * larger(a + scale * bend, 0.25 * a) * c), to_failure = one - u_begin;
  const auto fails = (to_failure <= T{}) | ((b + a * to_failure) * to_failure < c);
  const T step = (fails ? scale * (failure.size - 1.) : 2. * c) / (fails ? 2. * a : b + root);
  return fails ? larger(0.5 * (1. + begin.x) + step, one) : u_begin + step;
}

/// The implicit return. With p the plastic shear strain of the increment times G / R, p = (x - x_begin) G gamma_f / R, the stretched stress is kappa/(kappa + p)
/// times that of the elastic trial about the new centre, in shear on horizontal planes kappa/(kappa + r^2 p) times: one equation for u,
///
///   kappa + p = (h1 - h3)/2 of the trial whose shear on horizontal planes is (kappa + p)/(kappa + r^2 p)-fold,
///
/// increasing with u, here times failure.share. By Newton's method between bounds, from the root that is expected at the trial, which also gives the direction that
/// gamma_f belongs to. A lane that has converged does not change any more, so that it does not depend on the others.
template <int dim, class N, class T>
[[gnu::noinline]] void return_to_mobilised_surface(const PreparedNgiAdpOf<N>& law, const StretchedStress<dim, T>& trial,
                                                   decltype(T{} < T{}) yields, const T& u_begin, const T& per_square,
                                                   const StretchedShear<T>& at_begin, SymTensor<dim, T>& stress, T& x)
{
  constexpr int max_iterations = 60;
  constexpr Real precision = 1e-5;  // Newton's method squares it
  constexpr Real flattest = 0.05, smallest = 1e-100;
  const Real stretch2 = law.stretch * law.stretch;
  const T zero{};
  const Mobilisation<T> begin(u_begin);
  const T kappa = 2. * begin.w * per_square, normal = at_begin.normal;
  const T along2 = larger(at_begin.value * at_begin.value - normal * normal, zero);

  const FailureStrain<T> first(law, normal, along2, at_begin.value);
  T u = expected_root(begin, u_begin, per_square, first, at_begin, law.centre_change, stretch2);
  const Shares<T> ahead(Mobilisation<T>(u), begin.x, first, stretch2);
  const T turned = normal - law.centre_change * (ahead.kappa - kappa), turned2 = along2 * ahead.part * ahead.part;
  const FailureStrain<T> failure(law, turned, turned2, square_root(larger(turned * turned + turned2, zero + smallest)));

  T low = u_begin, high = zero + infinity;
  decltype(yields) left = yields;
  for (int n = 0; n < max_iterations && any(left); ++n) {
    const Mobilisation<T> m(u);
    const Shares<T> now(m, begin.x, failure, stretch2);
    const StretchedShear<T> f = trial.about(law.centre_begin + law.centre_change * now.kappa, now.part);
    const T kappa_slope = m.kappa_slope(now.per_square), grown_slope = failure.share * kappa_slope,
            plastic_slope = failure.size * m.x_slope();
    const T part_slope = (stretch2 - 1.) * (grown_slope * now.plastic - plastic_slope * now.grown) * now.per_along * now.per_along;
    const T both = now.grown + now.plastic, both_slope = grown_slope + plastic_slope, residual = both - failure.share * f.value;
    const T slope = both_slope * f.scale - failure.share * (f.by_centre * law.centre_change * kappa_slope + f.by_part * part_slope);
    low = left & (residual < zero) ? u : low;
    high = left & (residual > zero) ? u : high;
    const T newton = u - residual * f.scale / larger(slope, flattest * both_slope * f.scale);
    u = left ? ((newton < low) | (newton > high) ? 0.5 * (low + high) : newton) : u;
    left = left & (magnitude(residual) > precision * both);
  }
  const Mobilisation<T> m(u);
  const Shares<T> end(m, begin.x, failure, stretch2);
  const T left_along = end.grown * end.per_along;
  trial.write(stress, yields, law.radius - zero, law.centre_begin + law.centre_change * end.kappa, left_along / end.part, left_along);
  x = yields ? m.x : x;
}

/// Advances `stress` (Pa, tension positive) by an increment of any duration. state[0] is x.
template <int dim, class N, class T>
[[gnu::always_inline]] inline void update(const PreparedNgiAdpOf<N>& law, SymTensor<dim, T>& stress, const Increment<dim, T>& increment,
                                          T* state)
{
  const T one = T{} + 1., per_radius = law.per_radius - T{};
  add_elastic_stress(law.elastic, stress, increment.strain);
  const StretchedStress<dim, T> trial(stress, per_radius, law.stretch);
  const T u = mobilisation_root(state[0]);
  const Mobilisation<T> begin(u);
  const T per_square = 1. / begin.square, kappa = 2. * begin.w * per_square;
  const StretchedShear<T> shear = trial.about(law.centre_begin + law.centre_change * kappa, one);
  const auto yields = shear.value > kappa;
  if (any(yields)) return_to_mobilised_surface<dim>(law, trial, yields, u, per_square, shear, stress, state[0]);
}

}  // namespace berm::material
