// SPDX-License-Identifier: BSD-3-Clause
#include "material/clay.hpp"

#include "core/usual.hpp"
#include "material/describe_elasticity.hpp"
#include "material/mohr_coulomb.hpp"
#include "material/rigidity_index.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::material {

void describe(Describe& d, Clay& law)
{
  d.value("rigidity_index", law.rigidity_index,
          {.meaning = "shear modulus divided by the intact undrained strength, G / s_u, instead of young_modulus", .range = positive});
  describe_elasticity(d, law, !law.rigidity_index);
  describe_shansep(d, law);
  d.value("undrained_strength", law.undrained_strength,
          {.meaning = "intact undrained shear strength up to the reference rate",
           .unit = "Pa",
           .range = not_negative,
           .required = law.profile.strength.empty() && !law.shansep});
  d.value("undrained_strength_gradient", law.undrained_strength_gradient,
          {.meaning = "increase of the undrained strength with depth below the seabed at the start; a particle keeps that of its "
                      "initial position",
           .unit = "Pa/m"});
  d.value("sensitivity", law.sensitivity,
          {.meaning = "intact divided by fully remoulded strength; 1: the clay does not soften", .range = {1, 1000}});
  d.value("ductility", law.ductility,
          {.meaning =
               "plastic shear strain at which 95 % of the strength loss by remoulding has occurred, xi_95 (10 to 50 for most clays); "
               "needed where sensitivity is above 1",
           .range = not_negative});
  d.value("rate_parameter", law.rate_parameter,
          {.meaning = "relative increase of the strength for each tenfold rate of plastic shear strain above the reference rate",
           .range = not_negative});
  d.value("reference_rate", law.reference_rate,
          {.meaning = "rate of shear strain up to which the strength is undrained_strength; needed where rate_parameter is above 0",
           .unit = "1/s",
           .range = not_negative});
  d.value("rate_scale", law.rate_scale,
          {.meaning = "rate of the real motion divided by that of the model, which may be faster than the real pipe", .range = positive});
  d.value("rate_smoothing", law.rate_smoothing,
          {.meaning = "time over which the rate is averaged; left out: the time in which the driven body travels D/100 in the material "
                      "point method, and none in finite elements",
           .unit = "s",
           .range = not_negative});
  d.value("softening_length", law.softening_length,
          {.meaning =
               "width of shear bands: softening by plastic shear strain is scaled by cell size divided by this length, so that results for "
               "brittle clay depend less on the mesh; left out: not scaled",
           .unit = "m",
           .range = positive});
  declare_usual(d, {{"undrained_strength", {0, hard_clay}},
                    {"profile.undrained_strength", {0, hard_clay}},
                    {"shansep.pop", {0, 1e7}},
                    {"shansep.ocr", {0, 100}},
                    {"poisson_ratio", {0.3, 0.495}},
                    {"sensitivity", {1, 50}},
                    {"ductility", {0.5, 500}},
                    {"rate_parameter", {0.01, 0.5}}});
  take_surface_strength(law);
}

void check(Describe& d, const std::string& path, const Clay& law)
{
  check_rigidity_index(d, path, law);
  d.check(law.sensitivity == 1 || law.ductility > 0, path + ".ductility", "is missing: sensitivity is above 1, so the clay softens");
  d.check(law.rate_parameter == 0 || law.reference_rate > 0, path + ".reference_rate", "is missing: rate_parameter is above 0");
  if (law.ductility > 0 && law.undrained_strength > 0) {
    const Real index = elasticity(law).shear / law.undrained_strength, least = 3 * (1 - 1 / law.sensitivity) / index;
    d.check(law.ductility > least || law.softening_length, path + ".ductility",
            fmt::format("{:.3g} softens faster than the clay unloads elastically, which has no solution: take more than {:.3g}",
                        law.ductility, least));
  }
}

Clay at_depth(Clay law, Real depth, Real weight_above)
{
  return with_stiffness_at_depth(law, depth, weight_above);
}

Elasticity elasticity(const Clay& law)
{
  return elasticity(young_modulus_of(law), law.poisson_ratio);
}

YoungPoisson young_poisson(const Clay& law)
{
  return {young_modulus_of(law), law.poisson_ratio};
}

std::vector<FieldInfo> state_fields(const Clay& law)
{
  const auto shown_if = [](bool shown) { return shown ? everywhere : everywhere & ~to_frame; };
  return {{"plastic_shear", "plastic shear strain", ""},
          {"rate_part", "strength added by the strain rate, divided by the strength at the reference rate", "", 1,
           shown_if(law.rate_parameter > 0)},
          {"strength_change", "undrained strength divided by the intact one, minus 1", "", 1, shown_if(law.sensitivity > 1)}};
}

std::optional<Strength> strength_at_rest(const Clay& law)
{
  return Strength{.cohesion = law.undrained_strength, .cohesion_gradient = law.undrained_strength_gradient};
}

std::optional<Real> shear_strength(const Clay& law, Real /*middle*/, const Real* state)
{
  return law.undrained_strength * (1 + state[2]);
}

std::optional<Clay> with_strength_over(Clay law, Real factor)
{
  if (law.rigidity_index) *law.rigidity_index *= factor;
  law.undrained_strength /= factor;
  law.undrained_strength_gradient /= factor;
  for (Real& strength : law.profile.strength) strength /= factor;
  if (law.shansep) law.shansep->ratio /= factor, law.shansep->min_strength /= factor;
  law.rate_parameter = 0;
  return law;
}

Clay with_rate_smoothing(Clay law, Real time)
{
  if (!law.rate_smoothing) law.rate_smoothing = time;
  return law;
}

void recover(const Clay& law, Real share, Real* state)
{
  if (!(law.ductility > 0)) return;
  const Real remoulded = 1 / law.sensitivity, damage = std::exp(-3 * state[0] / law.ductility), healed = damage + share * (1 - damage);
  const auto left = [&](Real part) { return remoulded + (1 - remoulded) * part; };
  state[0] = -law.ductility / 3 * std::log(healed);
  state[2] = (1 + state[2]) * left(healed) / left(damage) - 1;
}

PreparedClay prepare(const Clay& law)
{
  MohrCoulomb tresca;
  tresca.young_modulus = young_modulus_of(law);
  tresca.poisson_ratio = law.poisson_ratio;
  tresca.cohesion = law.undrained_strength;
  ClayConstants constants;
  constants.remoulded = 1 / law.sensitivity;
  if (law.sensitivity > 1) constants.per_shear = 3 / law.ductility;
  if (law.rate_parameter > 0) {
    constants.per_e_fold = law.rate_parameter / std::log(10.);
    constants.per_relative = 1 / constants.per_e_fold;
    constants.per_reference = law.rate_scale / law.reference_rate;
  }
  constants.smoothing = law.rate_smoothing.value_or(0);
  constants.softening_length = law.softening_length.value_or(0);
  return {constants, elasticity(law), prepare(tresca)};
}

}  // namespace berm::material
