// SPDX-License-Identifier: BSD-3-Clause
#include "material/mohr_coulomb.hpp"

#include "material/describe_elasticity.hpp"
#include "material/principal_axes.hpp"
#include "material/shear_band.hpp"

#include <algorithm>

namespace berm::material {

void describe(Describe& d, MohrCoulomb& law)
{
  // 60 degrees, and a little for rounding.
  constexpr Real steepest = 1.0472;
  describe_elasticity(d, law);
  describe_shansep(d, law);
  d.value("cohesion", law.cohesion,
          {.meaning = "cohesion; the undrained strength where friction_angle is 0", .unit = "Pa", .range = not_negative});
  d.value("cohesion_gradient", law.cohesion_gradient,
          {.meaning = "increase of the cohesion with depth below the seabed at the start; a particle keeps the cohesion of its "
                      "initial position",
           .unit = "Pa/m"});
  d.value("friction_angle", law.friction_angle,
          {.meaning = "angle of internal friction; 0 is Tresca", .unit = "rad", .range = {0, steepest}, .required = true});
  d.value("dilation_angle", law.dilation_angle,
          {.meaning = "angle of dilation, not larger than friction_angle", .unit = "rad", .range = {0, steepest}});
  d.value("tension_cutoff", law.tension_cutoff,
          {.meaning = "tension cut-off; left out, the apex of the cone", .unit = "Pa", .range = not_negative});
  describe_bands(d, law);
  d.value("max_opening", law.max_opening,
          {.meaning = "limit of the stored tensile volumetric strain, which must close before the soil carries compression again; 0: "
                      "none is stored; absent: "
                      "0.2 where dilation_angle is above 0, else 0",
           .range = {0, 1}});
  take_surface_strength(law);
}

void check(Describe& d, const std::string& path, const MohrCoulomb& law)
{
  d.check(law.dilation_angle <= law.friction_angle, path + ".dilation_angle",
          "the dilation angle cannot be larger than the friction angle");
  d.check(!law.shansep || law.friction_angle == 0, path + ".shansep", "gives the undrained strength: it needs friction_angle = 0");
  check_bands(d, path, law);
}

std::optional<Real> band_width(const MohrCoulomb& law)
{
  return non_associated(law) ? given_band_width(law) : std::nullopt;
}

MohrCoulomb with_grain_size(MohrCoulomb law, Real d50)
{
  return with_grains(std::move(law), d50);
}

MohrCoulomb regularised_for(MohrCoulomb law, Real size)
{
  const std::optional<Real> width = band_width(law);
  if (!width) return law;
  const Real angle = friction_angle_in_cells(*strength_at_rest(law), *width, size);
  const Real share = std::tan(angle) / std::tan(law.friction_angle);
  law.friction_angle = angle;
  law.cohesion *= share;
  law.cohesion_gradient *= share;
  for (Real& strength : law.profile.strength) strength *= share;
  law.cohesion_share *= share;
  law.band_width.reset();
  law.d50.reset();
  return law;
}

std::optional<MohrCoulomb> with_strength_over(MohrCoulomb law, Real factor)
{
  law.friction_angle = std::atan(std::tan(law.friction_angle) / factor);
  law.dilation_angle = std::min(law.dilation_angle, law.friction_angle);
  law.cohesion /= factor;
  law.cohesion_gradient /= factor;
  for (Real& strength : law.profile.strength) strength /= factor;
  if (law.shansep) law.shansep->ratio /= factor, law.shansep->min_strength /= factor;
  if (law.tension_cutoff) *law.tension_cutoff /= factor;
  return law;
}

namespace {

/// The largest and the smallest principal stress.
std::pair<Real, Real> extreme_stresses(const SymTensor<2>& stress)
{
  const Real mean = (stress[0] + stress[1]) / 2, radius = std::hypot((stress[0] - stress[1]) / 2, stress[3]);
  return {std::max(mean + radius, stress[2]), std::min(mean - radius, stress[2])};
}

}  // namespace

PreparedMohrCoulomb prepare(const MohrCoulomb& law)
{
  PreparedMohrCoulomb p;
  p.elastic = elasticity(law);
  p.per_young_modulus = 1 / law.young_modulus;
  const Real lame = p.elastic.lame, shear = p.elastic.shear;
  const Real friction = std::sin(law.friction_angle), dilation = std::sin(law.dilation_angle);
  p.sin_friction = friction;
  p.cos_friction = std::cos(law.friction_angle);
  p.weight_1 = (1 + friction) / 2;
  p.weight_3 = (1 - friction) / 2;
  p.cutoff = law.tension_cutoff.value_or(infinity);
  p.cohesion_share = law.cohesion_share;
  p.set_cohesion(law.cohesion);
  constexpr Real of_dilating_soil = 0.2;
  p.max_opening = p.apex < infinity ? law.max_opening.value_or(dilation > 0 ? of_dilating_soil : 0) : 0;

  p.drop_1 = lame * dilation + shear * (1 + dilation);
  p.drop_2 = lame * dilation;
  p.drop_3 = lame * dilation - shear * (1 - dilation);
  p.drop_high = (p.drop_1 + p.drop_2) / 2;
  p.drop_low = (p.drop_2 + p.drop_3) / 2;
  p.per_face = 1 / (p.weight_1 * p.drop_1 - p.weight_3 * p.drop_3);
  p.per_high = 1 / (p.weight_1 * p.drop_high - p.weight_3 * p.drop_3);
  p.per_low = 1 / (p.weight_1 * p.drop_1 - p.weight_3 * p.drop_low);

  if (p.cutoff < infinity) {
    const Real stiffness = p_wave_modulus(p.elastic);
    p.pull_one = lame / stiffness;
    p.pull_two = lame / (2 * (lame + shear));
    const Real determinant = p.drop_1 * lame - p.drop_3 * stiffness;
    p.line_1 = (p.drop_2 * lame - p.drop_3 * lame) / determinant;
    p.line_3 = (p.drop_1 * lame - p.drop_2 * stiffness) / determinant;
  }
  p.inner_cone = std::sqrt(1 + friction * friction / 3);
  return p;
}

MohrCoulomb without_dilation(MohrCoulomb law)
{
  if (!dilates(law)) return law;
  law.max_opening = prepare(law).max_opening;
  law.dilation_angle = 0;
  return law;
}

std::optional<Real> shear_strength(const MohrCoulomb& law, Real middle, const Real* /*state*/)
{
  return law.cohesion * std::cos(law.friction_angle) - middle * std::sin(law.friction_angle);
}

MohrCoulomb associated(const MohrCoulomb& law, const SymTensor<2>& stress)
{
  if (law.dilation_angle == law.friction_angle) return law;
  const Real apex = law.cohesion / std::tan(law.friction_angle);
  MohrCoulomb same = law;
  same.friction_angle = law.dilation_angle;
  same.tension_cutoff = law.tension_cutoff ? std::min(*law.tension_cutoff, apex) : apex;
  const auto [s1, s3] = extreme_stresses(stress);
  const Real middle = std::min((s1 + s3) / 2, *same.tension_cutoff);
  same.cohesion = (law.cohesion * std::cos(law.friction_angle) - middle * (std::sin(law.friction_angle) - std::sin(law.dilation_angle))) /
                  std::cos(law.dilation_angle);
  return same;
}

namespace {

Real yield_value(const PreparedMohrCoulomb& law, Real s1, Real s3)
{
  return std::max(law.weight_1 * s1 - law.weight_3 * s3 - law.strength, s1 - law.tension);
}

}  // namespace

Real yield_value(const PreparedMohrCoulomb& law, const SymTensor<2>& stress)
{
  const auto [s1, s3] = extreme_stresses(stress);
  return yield_value(law, s1, s3);
}

Real yield_value(const PreparedMohrCoulomb& law, const SymTensor<3>& stress)
{
  const PrincipalAxes axes = principal_axes(stress);
  return yield_value(law, axes.value[0], axes.value[2]);
}

}  // namespace berm::material
