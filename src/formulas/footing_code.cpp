// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/footing_code.hpp"

#include "formulas/footing.hpp"

#include <algorithm>

namespace berm::formulas {
namespace {

constexpr Source undrained{Label::fit, "ISO 19901-4, API RP 2GEO (2011)", "kB/s_u0 <= 10, z <= B", "annex A"};
constexpr Source sliding{Label::fit, "ISO 19901-4, API RP 2GEO (2011)", "z <= B", "7.15"};
constexpr Source drained{Label::fit, "ISO 19901-4, API RP 2GEO (2011)", "20 <= phi <= 50 deg, at the surface", "annex A"};

constexpr Real N_c = 5.14, skirt_reaction = 4;

/// Factor of clay whose strength grows, x = k B'/s_u0.
Real growth_factor(Real x, Real roughness)
{
  const auto of = [x](Real a, Real b, Real c, Real d) { return a + b * x - std::hypot(c + b * x, d); };
  return std::lerp(of(1.372, 0.07, -0.128, 0.342), of(2.56, 0.457, 0.713, 1.38), roughness);
}

/// What soil above the base carries of H.
Real above_base(const FoundationBase& base, const ClayOfFoundation& clay)
{
  const Real across = base.shape == FoundationBase::Shape::strip       ? 1
                      : base.shape == FoundationBase::Shape::rectangle ? base.length
                                                                       : base.width;
  return skirt_reaction * clay.above * across * base.depth;
}

bool is_shallow(const FoundationBase& base)
{
  return within(base.depth, 0, base.width);
}

}  // namespace

Real FoundationBase::area() const
{
  return under(0).area;
}

EffectiveBase FoundationBase::under(Real eccentricity) const
{
  const Real e = std::abs(eccentricity), R = width / 2;
  if (e >= R) return {0, 0, 0};
  if (shape == Shape::strip) return {width - 2 * e, width - 2 * e, infinity};
  if (shape == Shape::rectangle) {
    const Real b = width - 2 * e;
    return {b * length, std::min(b, length), std::max(b, length)};
  }
  const Real area = pi * R * R - 2 * (e * std::sqrt(R * R - e * e) + R * R * std::asin(e / R)), part = std::sqrt((R - e) / (R + e));
  const Real longer = std::sqrt(area / part);
  return {area, longer * part, longer};
}

Formula code_bearing_clay(const FoundationBase& base, const ClayOfFoundation& clay, Real H, Real eccentricity)
{
  const EffectiveBase on = base.under(eccentricity);
  const Real x = clay.growth * on.width / clay.strength;
  const bool valid = is_shallow(base) && within(x, 0, 10) && within(clay.roughness, 0, 1) && clay.strength > 0;
  const Real left = std::max(Real(0), std::abs(H) - above_base(base, clay)), most = on.area * clay.strength * clay.roughness;
  if (!(on.area > 0) || !(left <= most * (1 + 1e-9))) return formula(nan, undrained, false);
  const Real inclined = 0.5 - 0.5 * std::sqrt(std::max(Real(0), 1 - left / (on.area * clay.strength)));
  const Real F = x > 0 ? growth_factor(x, clay.roughness) : 1, s_cv = 0.18 - 0.155 * std::sqrt(x) + 0.021 * x;
  const Real mean = F * (N_c * clay.strength + clay.growth * on.width / 4);
  const Real deep = base.depth > 0 ? 0.3 * clay.above * N_c / mean * std::atan(base.depth / on.width) : 0;
  const Real K = 1 + s_cv * (1 - 2 * inclined) * on.ratio() + deep - inclined;
  return formula((mean * K + clay.overburden) * on.area, undrained, valid);
}

Formula code_sliding_clay(const FoundationBase& base, const ClayOfFoundation& clay)
{
  return formula(clay.strength * clay.roughness * base.area() + above_base(base, clay), sliding, is_shallow(base) && clay.strength > 0);
}

Formula code_bearing_sand(const FoundationBase& base, const SandOfFoundation& sand, Real H_over_V, Real eccentricity)
{
  const EffectiveBase on = base.under(eccentricity);
  const Real left = std::max(Real(0), 1 - 0.7 * std::abs(H_over_V)), inclined = left * left * left * left * left;
  const Real value =
      sand.unit_weight * on.width / 2 * n_gamma_hansen(sand.friction_angle).value * (1 - 0.4 * inclined * on.ratio()) * inclined * on.area;
  return formula(value, drained, within(sand.friction_angle, 20 * degree, 50 * degree) && base.depth <= 1e-6 * base.width);
}

}  // namespace berm::formulas
