// SPDX-License-Identifier: BSD-3-Clause
#include "material/hypoplastic.hpp"

#include "core/usual.hpp"
#include "material/describe_elasticity.hpp"

namespace berm::material {

void describe(Describe& d, Hypoplastic& law)
{
  describe_density(d, law);
  d.value("critical_friction_angle", law.critical_friction_angle,
          {.meaning = "angle of friction at the critical state, phi_c; other directions by Matsuoka and Nakai",
           .unit = "rad",
           .range = {0.1, 1},
           .required = true});
  d.value(
      "granular_hardness", law.granular_hardness,
      {.meaning = "h_s: reference stress of compression, e = e_0 exp(-(3 p' / h_s)^n)", .unit = "Pa", .range = positive, .required = true});
  d.value("hardness_exponent", law.hardness_exponent,
          {.meaning = "n, the exponent of compression", .range = {0.05, 0.95}, .required = true});
  d.value("min_void_ratio", law.min_void_ratio,
          {.meaning = "e_d0: least void ratio at zero pressure, about e_min", .range = positive, .required = true});
  d.value("critical_void_ratio", law.critical_void_ratio,
          {.meaning = "e_c0: void ratio of the critical state at zero pressure, about e_max", .range = positive, .required = true});
  d.value("max_void_ratio", law.max_void_ratio,
          {.meaning = "e_i0: largest void ratio at zero pressure, about 1.15 e_max", .range = positive, .required = true});
  d.value("dilatancy_exponent", law.dilatancy_exponent,
          {.meaning = "alpha: how much strength and dilatancy at the peak increase with density; 0.1 to 0.3",
           .range = {0, 1},
           .required = true});
  d.value("stiffness_exponent", law.stiffness_exponent,
          {.meaning = "beta: how much stiffness increases with density; 1 to 2.5", .range = {0, 5}, .required = true});
  d.value("void_ratio", law.void_ratio, {.meaning = "void ratio at the start; or relative_density", .range = positive});
  d.value(
      "relative_density", law.relative_density,
      {.meaning = "(e_c - e) / (e_c - e_d) at the start, at its pressure: 0 at the critical state, 1 at the densest", .range = {-1, 1}});
  d.value("small_strain", law.small_strain,
          {.meaning = "R: range of strain with the stiffness after a reversal; left out: no intergranular strain, and cyclic "
                      "strains accumulate too much",
           .range = {0, 0.01}});
  d.value("reversal_stiffness", law.reversal_stiffness,
          {.meaning = "m_R: stiffness after a reversal of the strain (180 degrees), divided by that after a long monotonic path; 2 to 6",
           .range = {0, 50}});
  d.value("turn_stiffness", law.turn_stiffness,
          {.meaning = "m_T: the same after a change of direction by 90 degrees; 1 to m_R", .range = {0, 50}});
  d.value("evolution_exponent", law.evolution_exponent,
          {.meaning = "beta_r: how quickly the intergranular strain evolves; 0.05 to 0.5", .range = {0, 5}});
  d.value("decay_exponent", law.decay_exponent,
          {.meaning = "chi: how quickly the stiffness after a change of direction decays; 1 to 6", .range = {0, 20}});
  describe_pressure_limits(d, law);
  declare_usual(d, {{"critical_friction_angle", {25 * degree, 40 * degree}},
                    {"granular_hardness", {3e6, 5e10}},
                    {"hardness_exponent", {0.15, 0.6}},
                    {"min_void_ratio", {0.2, 1.5}},
                    {"critical_void_ratio", {0.4, 2.5}},
                    {"dilatancy_exponent", {0.05, 0.4}},
                    {"stiffness_exponent", {0.5, 3}},
                    {"void_ratio", {0.3, 1.5}},
                    {"small_strain", {1e-5, 1e-3}}});
}

void check(Describe& d, const std::string& path, const Hypoplastic& law)
{
  d.check(law.void_ratio.has_value() != law.relative_density.has_value(), path + ".void_ratio",
          law.void_ratio ? "cannot be combined with relative_density: give one of them"
                         : "is missing: give void_ratio or relative_density");
  d.check(law.min_void_ratio < law.critical_void_ratio, path + ".min_void_ratio", "must be less than critical_void_ratio");
  d.check(law.critical_void_ratio < law.max_void_ratio, path + ".max_void_ratio", "must be larger than critical_void_ratio");
  d.check(law.void_ratio.value_or(0) < law.max_void_ratio, path + ".void_ratio",
          "must be less than max_void_ratio, that of the loosest packing");
  const Real loosest = law.critical_void_ratio - law.relative_density.value_or(0) * (law.critical_void_ratio - law.min_void_ratio);
  d.check(loosest < law.max_void_ratio, path + ".relative_density", "is that of sand looser than max_void_ratio");
  const bool of_grains = law.reversal_stiffness > 0 || law.turn_stiffness > 0 || law.evolution_exponent > 0 || law.decay_exponent > 0;
  d.check(law.small_strain > 0 || !of_grains, path + ".small_strain",
          "is missing: without it reversal_stiffness, turn_stiffness, evolution_exponent and decay_exponent do nothing");
  if (law.max_void_ratio > law.critical_void_ratio && law.critical_void_ratio > law.min_void_ratio)
    d.check(prepare(law).stiffness > 0, path + ".dilatancy_exponent",
            "is too small for this friction angle and these void ratios: soil at max_void_ratio would have no stiffness in compression");
  d.check(law.small_strain == 0 || law.turn_stiffness >= 1, path + ".turn_stiffness", "must be at least 1 where small_strain is given");
  d.check(law.small_strain == 0 || law.reversal_stiffness >= law.turn_stiffness, path + ".reversal_stiffness",
          "must be at least turn_stiffness where small_strain is given");
  d.check(law.small_strain == 0 || (law.evolution_exponent > 0 && law.decay_exponent > 0), path + ".evolution_exponent",
          "and decay_exponent must be above 0 where small_strain is given");
  check_pressures(d, path, law);
}

namespace {

/// t = (vertical, across, across) of the critical state in compression has |t*| = 1 / a: the largest of L : D : D over that of isotropic stress.
Real most_over_isotropic(Real a)
{
  const Real across = 1 / a, square = 1. / 3 + across * across;
  const Real of_shear = 1 / (3 * square), of_volume = 1 / ((3 + a * a) * square), along = a / std::sqrt(square);
  const Real shear = along * across / std::sqrt(3.), volume = along / std::sqrt(3 * (3 + a * a));
  const Real m = of_shear + shear * shear, n = of_volume + volume * volume, mixed = shear * volume;
  return (m + n) / 2 + std::sqrt((m - n) * (m - n) / 4 + mixed * mixed);
}

}  // namespace

Elasticity elasticity(const Hypoplastic& law)
{
  return prepare(law).elastic;
}

YoungPoisson young_poisson(const Hypoplastic& law)
{
  const Elasticity elastic = elasticity(law);
  return {young_modulus(elastic), elastic.lame / (2 * (elastic.lame + elastic.shear))};
}

std::string law_name(const Hypoplastic&)
{
  return "hypoplastic sand";
}

std::vector<FieldInfo> state_fields(const Hypoplastic&)
{
  std::vector<FieldInfo> fields = {{"void_ratio", "void ratio", ""}};
  for (const char* component : {"xx", "yy", "zz", "xy", "yz", "zx"})
    fields.push_back({std::string("intergranular_strain_") + component, std::string("intergranular strain ") + component, ""});
  return fields;
}

void initial_state(const Hypoplastic& law, const SymTensor<3>& stress, Real* state)
{
  const Real pressure = invariants(stress, law.min_pressure).pressure;
  const Real shrink = std::exp(-std::pow(3 * pressure / law.granular_hardness, law.hardness_exponent));
  const Real loosest = law.critical_void_ratio, densest = law.min_void_ratio;
  state[0] = law.void_ratio.value_or(shrink * (loosest - law.relative_density.value_or(0) * (loosest - densest)));
}

PreparedHypoplastic prepare(const Hypoplastic& law)
{
  const Real sine = std::sin(law.critical_friction_angle), n = law.hardness_exponent;
  PreparedHypoplastic prepared;
  const Real a = prepared.a = std::sqrt(3. / 8) * (3 - sine) / sine;
  prepared.min_pressure = law.min_pressure;
  prepared.max_pressure = law.max_pressure;
  prepared.per_hardness = 3 / law.granular_hardness;
  prepared.exponent = n;
  prepared.min_void_ratio = law.min_void_ratio;
  prepared.per_range_of_void_ratio = 1 / (law.critical_void_ratio - law.min_void_ratio);
  prepared.per_max_void_ratio = 1 / law.max_void_ratio;
  prepared.alpha = law.dilatancy_exponent;
  prepared.beta = law.stiffness_exponent;
  const Real loosest =
      std::pow((law.max_void_ratio - law.min_void_ratio) / (law.critical_void_ratio - law.min_void_ratio), law.dilatancy_exponent);
  prepared.stiffness =
      law.granular_hardness / n * std::pow(law.max_void_ratio, law.stiffness_exponent) / (3 + a * a - a * std::sqrt(3.) * loosest);
  if (law.small_strain > 0) {
    prepared.range = law.small_strain;
    prepared.per_range = 1 / law.small_strain;
    prepared.reversal = law.reversal_stiffness;
    prepared.turn = law.turn_stiffness;
    prepared.evolution = law.evolution_exponent;
    prepared.decay = law.decay_exponent;
  }

  const Real share = law.max_pressure * prepared.per_hardness, shrink = std::exp(-std::pow(share, n));
  const Real factor = prepared.stiffness * (1 + 1 / (law.max_void_ratio * shrink)) * std::pow(share, 1 - n) *
                      std::pow(law.min_void_ratio, -law.stiffness_exponent) * most_over_isotropic(a) * prepared.reversal;
  const Real bulk = factor * (1 + a * a / 3), shear = 1.5 * factor;
  prepared.elastic = {bulk, shear, bulk - 2. / 3 * shear};
  return prepared;
}

}  // namespace berm::material
