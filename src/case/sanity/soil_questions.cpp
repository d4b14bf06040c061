// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "material/laws.hpp"
#include "material/shear_band.hpp"
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"
#include "settings/drainage.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

constexpr Real rounding = 0.01;
/// An interface with so large a friction angle is meant to be rough: none that was measured has it.
constexpr Real rough = 75 * degree;

Real degrees(Real radians)
{
  return radians * 180 / pi;
}

/// A material that can yield, and the first body that has it.
struct Soil {
  Index body;
  std::string name;
  material::Material material;

  std::string key(const std::string& key) const { return fmt::format("material.{}.{}", name, key); }
  /// With the strength that it would have at the base of the body.
  material::Material at_base(const Scene& s) const
  {
    const Real depth = s.depth_of(body);
    return at_depth(material, depth, soil_of(s.c, s.c.body[body].second).vertical_stress(s.region_at(body, depth), depth));
  }
};

/// The soils of all bodies, each once.
std::vector<Soil> yielding(const Scene& s)
{
  std::vector<Soil> soils;
  for (Index b = 0; b < static_cast<Index>(s.bodies.size()); ++b) {
    const settings::BodySoil soil = soil_of(s.c, s.c.body[b].second);
    for (std::size_t k = 0; k < soil.materials.size(); ++k) {
      const auto same = [&](const Soil& other) { return other.name == soil.names[k]; };
      if (yields(soil.materials[k]) && std::none_of(soils.begin(), soils.end(), same))
        soils.push_back({b, soil.names[k], soil.materials[k]});
    }
  }
  return soils;
}

/// Ka and Kp of soil without cohesion, in words.
std::string bounds_of_k0(const material::Material& material)
{
  const std::optional<material::Strength> soil = strength_at_rest(material);
  if (!soil || soil->cohesion != 0 || soil->cohesion_gradient != 0) return "";
  const Real sine = std::sin(soil->friction_angle), active = (1 - sine) / (1 + sine);
  return fmt::format(" (Ka = {:.2f} to Kp = {:.2f} for {:.3g} deg without cohesion; 1 - sin phi = {:.2f} is usual)", active, 1 / active,
                     degrees(soil->friction_angle), 1 - sine);
}

/// m, of a bed that berm meshes; 0 where it is not known.
Real smallest_cell(const settings::Case& c)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  return bed == nullptr ? 0 : bed->near_size;
}

/// The same of the largest.
Real largest_cell(const settings::Case& c)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  if (bed == nullptr) return 0;
  const Real grown = bed->near_size + bed->growth * std::hypot(bed->length, bed->depth), far = bed->far_size.value_or(grown);
  return std::min({grown, far, bed->layer > 0 ? bed->layer : far});
}

/// "is 1: " of a clay whose stiffness follows from a rigidity index; else "".
std::string rigidity_words(const material::Material& material)
{
  const auto* clay = material.get_if<material::Clay>();
  return clay != nullptr && clay->rigidity_index ? fmt::format("is {:.4g}, and ", *clay->rigidity_index) : "";
}

}  // namespace

void does_gravity_point_down(const Scene& s, Findings& found)
{
  const bool any_k0 = std::any_of(s.c.body.begin(), s.c.body.end(), [](const auto& body) { return body.second.has_k0(); });
  if (s.gravity == 0) {
    for (const auto& [name, body] : s.c.body)
      if (body.has_k0())
        found.refuse(
            fmt::format("body.{}.k0", name),
            "without gravity there is no stress at rest, and k0 has no effect; add gravity = [0, \"-9.81 m/s^2\"], or leave k0 out");
    for (const auto& [b, name, material] : yielding(s))
      if (const auto at_rest = settings::strength_under(material, 0, 0);
          !any_k0 && at_rest && *at_rest == 0 && s.c.body[b].second.initial_stress.empty() && s.c.traction.empty())
        found.warn("gravity", fmt::format("is missing: the soil of [body.{}] has friction only, so it has no strength without weight; add "
                                          "gravity = [0, \"-9.81 m/s^2\"]",
                                          s.c.body[b].first));
    return;
  }
  const bool seabed = std::holds_alternative<mesh::SeabedMesh>(s.c.mesh);
  if (seabed && (s.up != 1 || s.up_sign < 0)) {
    found.refuse("gravity",
                 "does not point down: the bed of a mesh of kind \"seabed\" lies below y = 0; write gravity = [0, \"-9.81 m/s^2\"]");
    return;
  }
  if (s.gravity > 300 * standard_gravity)
    found.warn("gravity",
               fmt::format(
                   "is {:.3g} times that of the earth; a centrifuge has up to some hundred; is the unit right? \"-50 gravity\" is 490 m/s2",
                   s.gravity / standard_gravity));
  else if (s.gravity < 0.15 * standard_gravity)
    found.warn("gravity",
               fmt::format("is {:.2g} of that of the earth; is the unit right? A plain number is in m/s2: \"-1 gravity\" is -9.81 m/s2",
                           s.gravity / standard_gravity));
}

void is_the_soil_a_soil(const Scene& s, Findings& found)
{
  constexpr Real slurry = 100;  // Pa: no clay on which anything lies is weaker
  for (const Soil& soil : yielding(s)) {
    const material::Material& material = soil.material;
    const bool as_weight = s.places.has(soil.key("submerged_unit_weight"));
    if (s.gravity > 0 && (density(material) < 100 || density(material) > 4000))
      found.warn(soil.key(as_weight ? "submerged_unit_weight" : "density"),
                 fmt::format("is {:.3g} kg/m3; soil has 1400 to 2200 saturated, 400 to 1200 submerged: write \"{}\"", density(material),
                             as_weight ? "8.6 kN/m^3" : "877 kg/m^3"));
    const std::optional<material::Strength> strength = strength_at_rest(material);
    if (!strength) continue;
    const std::optional<material::Strength> at_base = strength_at_rest(soil.at_base(s));
    if (strength->cohesion == 0 && strength->friction_angle == 0 && !(at_base && at_base->cohesion > 0))
      strength_key(material) == "cohesion"
          ? found.refuse(soil.key("friction_angle"),
                         "and cohesion are both 0: the soil has no strength and flows like water; give one of them")
          : found.refuse(soil.key(strength_key(material)), "is 0: the soil has no strength and flows like water");
    else if (strength->friction_angle > 50 * degree)
      found.warn(soil.key("friction_angle"), fmt::format("is {:.3g} deg; sand has 28 to 45 deg", degrees(strength->friction_angle)));
    const Real weight = density(material) * s.gravity * s.depth_of(soil.body), base = at_base ? at_base->cohesion : 0;
    if (strength->friction_angle == 0 && weight > 0 && base > 0 && base < std::max(1e-3 * weight, slurry))
      found.warn(soil.key(strength_key(material)),
                 fmt::format("is {0:.3g} Pa, and {1:.3g} Pa at the base, under a weight of {2:.3g} Pa: "
                             "such soil flows under its own weight; soft clay has 1 to 10 kPa: is the unit "
                             "right? A plain number is in Pa: write \"{0:.3g} kPa\" where that is meant",
                             strength->cohesion, base, weight));
    constexpr Real cemented = 3;  // of the weight on it at the base
    if (strength->friction_angle > 20 * degree && weight > 0 && strength->cohesion > cemented * weight)
      found.warn(soil.key(strength_key(material)),
                 fmt::format("is {:.3g} kPa with a friction angle of {:.3g} deg, {:.2g} times the weight above the base of the bed: that "
                             "is rock; sand has 0, silt and clay drained 2 to 20 kPa: is the unit right (\"Pa\")?",
                             strength->cohesion / 1e3, degrees(strength->friction_angle), strength->cohesion / weight));
    if (strength->cohesion > 1e7)
      found.warn(soil.key(strength_key(material)),
                 fmt::format("is {:.3g} kPa, that of rock; soil has up to some hundred kPa: is the unit right?", strength->cohesion / 1e3));
  }
}

void does_the_strength_grow_as_that_of_clay(const Scene& s, Findings& found)
{
  constexpr Real most = 10;  // of the weight above: 0.2 to 0.35 where it was never overloaded, 0.25 OCR^0.8 else
  for (const Soil& soil : yielding(s)) {
    const std::optional<material::Strength> strength = strength_at_rest(soil.material);
    const Real weight = density(soil.material) * s.gravity;
    if (!strength || strength->friction_angle > 0 || !(weight > 0) || !(strength->cohesion_gradient > most * weight)) continue;
    found.warn(
        soil.key(strength_key(soil.material) + "_gradient"),
        fmt::format(
            "is {:.3g} kPa/m, {:.3g} times the submerged unit weight, {:.3g} kN/m3; normally consolidated clay has 0.2 to 0.35 times, "
            "overconsolidated clay a few times that: is the unit right (\"kPa/m\")?",
            strength->cohesion_gradient / 1e3, strength->cohesion_gradient / weight, weight / 1e3));
  }
}

void is_the_stiffness_that_of_soil(const Scene& s, Findings& found)
{
  constexpr Real stiff_rock = 1e11, rock = 2e9, peat = 5e4, rock_strength = 1e6;  // Pa
  constexpr Real least_index = 10, most_index = 2e4;                              // of clay: E over s_u
  constexpr Real heaviest = 2e4;                                                  // kg/m3
  const auto key = [&](const std::string& name) {
    const auto word = [](const auto& law) {
      if constexpr (requires { law.max_pressure; }) return "max_pressure";
      if constexpr (requires { law.rigidity_index; })
        if (law.rigidity_index) return "rigidity_index";
      return "young_modulus";
    };
    return fmt::format("material.{}.{}", name, material::visit(word, s.c.material[index_of(s.c.material, name)].second));
  };
  for (Index b = 0; b < static_cast<Index>(s.bodies.size()); ++b) {
    const settings::BodySoil soil = soil_of(s.c, s.c.body[b].second);
    // Where the soil is softest for the weight above it; of one that is the same at all depths that is at the base.
    constexpr int parts = 10;
    Real weight = 0, modulus = 0, least = infinity;
    Index softest = 0;
    for (int k = 1; k <= parts; ++k) {
      const Real depth = s.depth_of(b) * k / parts, here = p_wave_modulus(elasticity(s.material_at(b, depth))),
                 above = s.weight_above(b, depth);
      if (!yields(s.material_at(b, depth)) || !(above > 0) || here / above >= least) continue;
      least = here / above, weight = above, modulus = here, softest = soil.material_index_at(s.region_at(b, depth), depth);
    }
    if (weight == 0 || modulus >= 3 * weight) continue;
    const std::string words =
        fmt::format("is {:.3g} Pa, too soft for the weight of the soil above it, {:.3g} Pa: it would be compressed to a fraction of its "
                    "height; sand has 5 to 50 MPa, soft clay 0.3 to 5 MPa: is the unit right (\"MPa\", not \"mPa\")?",
                    young_poisson(soil.materials[softest]).young_modulus, weight);
    modulus < weight / 2 ? found.refuse(key(soil.names[softest]), words) : found.warn(key(soil.names[softest]), words);
  }
  for (const Soil& soil : yielding(s)) {
    const material::Material at_base = soil.at_base(s);
    const Real young = young_poisson(soil.material).young_modulus, E = young_poisson(at_base).young_modulus;
    const std::optional<material::Strength> strength = strength_at_rest(at_base);
    const bool is_clay = strength && strength->friction_angle == 0 && strength->cohesion > 0;
    const bool is_rock = strength && strength->cohesion > rock_strength;
    const Real index = is_clay ? E / strength->cohesion : nan;
    if (young > stiff_rock)
      found.warn(
          key(soil.name),
          fmt::format("is {:.3g} Pa, stiffer than rock: time steps become very small; sand has 5 to 50 MPa: is the unit right?", young));
    else if (is_clay && (index < least_index || index > most_index))
      found.warn(key(soil.name),
                 fmt::format("{}gives Young's modulus E = {:.3g} Pa at the base, {:.3g} times the strength of the clay there, "
                             "{:.3g} Pa; clay has 100 to 2000 times its strength: is the unit of either right?",
                             rigidity_words(soil.material), E, index, strength->cohesion));
    else if (!is_clay && !is_rock && (E > rock || (E < peat && E > 0)))
      found.warn(key(soil.name), fmt::format("is {:.3g} Pa, {}; sand has 5 to 50 MPa: is the unit right (\"MPa\")?", young,
                                             E > rock ? "as stiff as rock" : "softer than peat"));
    if (const Real inertia = inertia_density(soil.material); inertia > heaviest && inertia > density(soil.material))
      found.warn(soil.key("inertia_density"),
                 fmt::format("is {:.3g} kg/m3; saturated soil has 1400 to 2200: a larger one makes time steps longer (mass scaling), "
                             "and the drive must be slower by the same factor; if that is not intended, is the unit right (\"kg/m^3\")?",
                             inertia));
  }
}

void is_the_strain_rate_smooth(const Scene& s, Findings& found)
{
  if (s.c.method != settings::Method::mpm) return;
  const bool none_by_speed = std::all_of(s.c.stage.begin(), s.c.stage.end(),
                                         [](const settings::StageSettings& stage) { return !drives(stage.kind) || speed_of(stage) == 0; });
  for (const Soil& soil : yielding(s)) {
    const auto* clay = soil.material.get_if<material::Clay>();
    if (clay == nullptr || !is_rate_dependent(*clay) || clay->rate_smoothing || !none_by_speed) continue;
    found.warn(soil.key("rate_parameter"),
               "no stage drives a body by a velocity, from which the averaging time of the strain rate follows: with the rate of single "
               "time steps vibration makes clay stronger; give rate_smoothing, the time in which the body moves a hundredth of its width");
  }
}

void is_softening_free_of_the_cells(const Scene& s, Findings& found)
{
  constexpr Real brittle = 2;  // flow around a pipe shears clay by about 4 a passage: that softens bands before it softens flow
  for (const Soil& soil : yielding(s)) {
    const auto* clay = soil.material.get_if<material::Clay>();
    if (clay == nullptr || clay->sensitivity == 1 || clay->ductility >= brittle || clay->softening_length) continue;
    const Real cell = smallest_cell(s.c);
    found.warn(
        soil.key("ductility"),
        fmt::format("is {:.3g}: such brittle clay fails in shear bands one or two cells wide, and the result depends on the size of the "
                    "cells; give softening_length, the width of real bands{}, or compare runs of several cell sizes (berm study)",
                    clay->ductility, cell > 0 ? fmt::format(" (the cells here are {})", words_of(cell, "m")) : ""));
  }
}

void are_bands_as_wide_as_the_soil_makes_them(const Scene& s, Findings& found)
{
  using material::cells_of_band;
  const auto has_grains = [](const auto* law) { return law != nullptr && law->d50; };
  const Real cell = smallest_cell(s.c);
  for (const Soil& soil : yielding(s)) {
    const auto* mohr_coulomb = soil.material.get_if<material::MohrCoulomb>();
    const auto* norsand = soil.material.get_if<material::NorSand>();
    const std::string key = soil.key(has_grains(mohr_coulomb) || has_grains(norsand) ? "d50" : "band_width");
    if (mohr_coulomb != nullptr && given_band_width(*mohr_coulomb) && !non_associated(*mohr_coulomb))
      found.warn(key, "does nothing: with dilation_angle = friction_angle shear bands do not lose friction");
    const std::optional<Real> width = band_width(soil.material);
    if (!width) continue;
    if (cells_of_band * cell < *width * (1 - rounding) && cell > 0)
      found.warn(key, fmt::format("makes bands of {}, and the cells are {}: finer than a quarter of that, deformation localises in bands "
                                  "narrower than those of the soil, and resistance is too small; take mesh.near_size = {} or more",
                                  words_of(*width, "m"), words_of(cell, "m"), words_of(*width / cells_of_band, "m")));
    else if (norsand != nullptr && material::strain_in_band(*width, cell) > most_band_strain(*norsand) * (1 + rounding))
      found.warn(
          key, fmt::format("makes bands of {}, too narrow for cells of {}: these would soften faster than elastic soil unloads, so they "
                           "soften more slowly than the sand, and resistance after the peak is too large; take cells of {} or less",
                           words_of(*width, "m"), words_of(cell, "m"), words_of(most_band_strain(*norsand) * *width / cells_of_band, "m")));
  }
}

void what_inertia_do_layers_get(const Scene& s, Findings& found)
{
  constexpr Real worth_a_word = 0.01;
  if (!s.is_mpm()) return;
  for (const auto& [name, body] : s.c.body) {
    const settings::BodySoil soil = soil_of(s.c, body);
    for (std::size_t k = 1; k < soil.materials.size(); ++k) {
      const material::Material& asked = s.c.material[index_of(s.c.material, soil.names[k])].second;
      const Real taken = inertia_density(soil.materials[k]);
      const bool given = inertia_density(asked) != density(asked);
      if (!given || std::abs(taken / inertia_density(asked) - 1) < worth_a_word) continue;
      found.warn(fmt::format("material.{}.inertia_density", soil.names[k]),
                 fmt::format("is taken as {:.4g} kg/m^3 instead of {:.4g} kg/m^3: the soils of [body.{}] need the same ratio of density to "
                             "inertia_density, that of [material.{}]; slow motion does not depend on it",
                             taken, inertia_density(asked), name, soil.names.front()));
    }
  }
}

void is_all_soil_used(const Scene& s, Findings& found)
{
  for (const auto& [name, material] : s.c.material)
    if (!settings::is_used(s.c, name))
      found.warn("material." + name, "is not used: no body, layer or region names it; name it, or leave the table out");
  for (Index b = 0; b < static_cast<Index>(s.bodies.size()); ++b) {
    const bodies::BodySettings& body = s.c.body[b].second;
    for (std::size_t k = 0; k < body.soil_layer.size(); ++k) {
      const Real top = body.soil_layer[k].top, depth = s.depth_of(b);
      const Real thickness = (k + 1 < body.soil_layer.size() ? std::min(body.soil_layer[k + 1].top, depth) : depth) - top;
      const std::string path = fmt::format("body.{}.soil_layer[{}].top", s.c.body[b].first, k);
      if (top >= depth)
        found.warn(
            path,
            fmt::format("is {}, and the body ends at a depth of {}: the layer is below the mesh; leave it out, or make the mesh deeper",
                        words_of(top, "m"), words_of(depth, "m")));
      else if (thickness < smallest_cell(s.c))
        found.warn(path, fmt::format("is {}, and the layer ends {} below it, less than a cell, {}: it shares each of its cells with its "
                                     "neighbours; take mesh.near_size = {} or less, or leave the layer out",
                                     words_of(top, "m"), words_of(thickness, "m"), words_of(smallest_cell(s.c), "m"),
                                     words_of(thickness / 2, "m")));
    }
  }
}

namespace {

/// Warns where the shear stress at rest, Pa, is not the one that NGI-ADP begins with; whether it warned.
bool does_anisotropic_clay_begin_otherwise(const Scene& s, Index b, Real depth, Real shear, Findings& found)
{
  constexpr Real much = 0.1;  // of the active strength
  const material::Material material = s.material_at(b, depth);
  const auto* clay = material.get_if<material::NgiAdp>();
  const std::optional<Real> simple_shear = clay ? settings::strength_under(material, depth, 0) : std::nullopt;
  if (!simple_shear || !(*simple_shear > 0)) return false;
  const Real active = *simple_shear / clay->dss_ratio, part = shear / active;
  if (std::abs(part - clay->initial_mobilisation) <= much) return false;
  const std::string path = "body." + s.c.body[b].first + ".k0";
  if (part >= 1 || part <= -clay->passive_ratio)
    found.warn(path,
               fmt::format("is beyond the strength of the soil: at a depth of {} the shear stress is {:.3g} Pa, and the active strength "
                           "{:.3g} Pa; the bed fails before any load is applied",
                           words_of(depth, "m"), shear, active));
  else
    found.warn(path,
               fmt::format("gives {:.2g} of the active strength as shear stress at a depth of {}, and initial_mobilisation is {:.2g}: the "
                           "clay begins with the shear strain that the difference takes, and has lost as much stiffness; let both be one",
                           part, words_of(depth, "m"), clay->initial_mobilisation));
  return true;
}

}  // namespace

void does_the_soil_bear_its_initial_stress(const Scene& s, Findings& found)
{
  constexpr int parts = 10;
  for (Index b = 0; b < static_cast<Index>(s.bodies.size()); ++b) {
    const bodies::BodySettings& body = s.c.body[b].second;
    const std::string path = "body." + s.c.body[b].first;
    const auto beyond = [&](Real depth, Real largest, Real smallest) -> std::optional<std::pair<Real, Real>> {
      if (s.material_at(b, depth).template get_if<material::NgiAdp>() != nullptr) return {};  // asked below
      const std::optional<Real> strength =
          settings::strength_under(regularised_for(s.material_at(b, depth), largest_cell(s.c)), depth, -(largest + smallest) / 2);
      const Real shear = (largest - smallest) / 2;
      if (!strength || (*strength >= 0 && shear <= *strength * (1 + rounding) + 1e-9)) return {};
      return std::pair(shear, std::max(Real(0), *strength));
    };
    if (body.initial_stress.size() == 3) {
      const auto [least, most] = std::minmax_element(body.initial_stress.begin(), body.initial_stress.end());
      if (const auto over = beyond(0, *most, *least))
        found.warn(path + ".initial_stress", fmt::format("exceeds the strength of the soil: the shear stress is {:.3g} Pa, and the "
                                                         "strength {:.3g} Pa; stress is negative in compression",
                                                         over->first, over->second));
    }
    for (int k = 1; k <= parts && body.has_k0() && s.gravity > 0; ++k) {
      const Real depth = s.depth_of(b) * k / parts, vertical = -s.weight_above(b, depth), k0 = *body.k0_at(depth, -vertical),
                 across = k0 * vertical;
      const auto over = beyond(depth, std::max(vertical, across), std::min(vertical, across));
      if (does_anisotropic_clay_begin_otherwise(s, b, depth, (across - vertical) / 2, found)) break;
      if (!over) continue;
      found.warn(path + ".k0", fmt::format("is {:.3g}, beyond the strength of the soil{}: at a depth of {} the shear stress is {:.3g} Pa, "
                                           "and the strength {:.3g} Pa; the bed fails before any load is applied",
                                           k0, bounds_of_k0(regularised_for(s.material_at(b, depth), largest_cell(s.c))),
                                           words_of(depth, "m"), over->first, over->second));
      break;
    }
  }
}

namespace {

/// m, from the surface of a body's soil to the deepest place that a rigid body takes in a stage.
Real deepest(const Scene& s, const Way& way, Index b)
{
  const Span taken = swept(s, way, s.up), &soil = s.bodies[b].space[s.up];
  return std::clamp(s.up_sign > 0 ? soil.to - taken.from : taken.to - soil.from, Real(0), s.depth_of(b));
}

/// Mean stress of a body's soil at rest, Pa, compression positive.
Real pressure_at_rest(const Scene& s, Index b, Real depth)
{
  const bodies::BodySettings& body = s.c.body[b].second;
  if (body.initial_stress.size() == 3) return -(body.initial_stress[0] + body.initial_stress[1] + body.initial_stress[2]) / 3;
  const Real vertical = s.weight_above(b, depth);
  return body.has_k0() ? vertical * (1 + 2 * *body.k0_at(depth, vertical)) / 3 : 0;
}

}  // namespace

void does_pressure_shake_the_clay(const Scene& s, Findings& found)
{
  constexpr Real most = 20, loss = 0.002;  // of the strength; of the resistance, by each strength (examples/lateral_pile)
  if (!s.is_mpm()) return;
  for (const Way& way : s.ways) {
    const Index b = way.rigid == none ? none : s.touched_by(way.rigid);
    if (b == none || !s.rigids[way.rigid].bounded || !may_meet_soil(s, way)) continue;
    const Real depth = deepest(s, way, b), pressure = pressure_at_rest(s, b, depth);
    const material::Material soil = s.material_at(b, depth);
    const std::optional<Real> strength = yields(soil) ? settings::strength_under(soil, depth, 0) : std::nullopt;
    if (!strength || !(*strength > 0) || !(pressure > most * *strength)) continue;
    if (*settings::strength_under(soil, depth, pressure) > *strength * (1 + rounding)) continue;  // it grows with pressure
    const Real over = pressure / *strength;
    found.warn(
        fmt::format("body.{}.{}", s.c.body[b].first, s.c.body[b].second.has_k0() ? "k0" : "initial_stress"),
        fmt::format("gives the clay at the rigid body a pressure of {:.2g} times its strength: particles that change cells there disturb "
                    "the soil in proportion, and a slow drive loses {:.2g} % of its resistance or more on cells of any size "
                    "(docs/how_to/what_will_catch_you.md); take method = \"fem\", or about 8 times the strength where the pressure only "
                    "keeps the clay at the body",
                    over, 100 * loss * over));
    return;
  }
}

namespace {

/// Of a body of several materials: friction beside each of them, which has to be less than its own.
void ask_of_each_soil(const Scene& s, const std::string& name, const contact::ContactSettings& contact, Findings& found)
{
  const settings::BodySoil soil = soil_of(s.c, s.c.body[index_of(s.c.body, contact.body)].second);
  for (std::size_t k = 0; k < soil.materials.size() && soil.materials.size() > 1; ++k) {
    const std::optional<material::Strength> strength = strength_at_rest(soil.materials[k]);
    if (!strength || !yields(soil.materials[k])) continue;
    const auto beside =
        std::find_if(contact.soil.begin(), contact.soil.end(), [&](const auto& own) { return own.material == soil.names[k]; });
    const bool own = beside != contact.soil.end();
    const Real angle = own ? beside->friction_angle : contact.friction_angle;
    if (!(angle < rough) || !(std::tan(angle) > std::tan(strength->friction_angle) * (1 + rounding)) || (!own && k == 0)) continue;
    if (own)
      found.warn(
          fmt::format("contact.{}.soil[{}].friction_angle", name, beside - contact.soil.begin()),
          fmt::format("is {:.3g} deg, more than that of [material.{}], {:.3g} deg: the adjacent soil shears first; take at most that",
                      degrees(angle), soil.names[k], degrees(strength->friction_angle)));
    else
      found.warn(fmt::format("contact.{}.friction_angle", name),
                 fmt::format("is {:.3g} deg for [material.{}], too, whose own angle is {:.3g} deg: give the interface of each soil by "
                             "itself, [[contact.{}.soil]] with material = \"{}\", friction_angle and adhesion or adhesion_factor",
                             degrees(angle), soil.names[k], degrees(strength->friction_angle), name, soil.names[k]));
  }
}

}  // namespace

void is_the_interface_weaker_than_the_soil(const Scene& s, Findings& found)
{
  for (const auto& [name, contact] : s.c.contact) {
    if (rules_of(contact.scheme).tied) continue;
    const Index body = index_of(s.c.body, contact.body);
    const material::Material at_surface = s.material_at(body, 0);
    const std::optional<material::Strength> soil = strength_at_rest(at_surface);
    if (!soil || !yields(at_surface)) continue;
    ask_of_each_soil(s, name, contact, found);
    if (!contact.soil.empty()) continue;
    // Of the soil that the body meets: between the surface and its width, or of a bed that has no driven body to the base.
    const Index rigid = contact.rigid.empty() ? none : index_of(s.c.rigid, contact.rigid);
    const Real depth = rigid != none && s.rigids[rigid].width > 0 ? std::min(s.rigids[rigid].width, s.depth_of(body)) : s.depth_of(body);
    const std::optional<material::Strength> below = strength_at_rest(s.material_at(body, depth));
    const Real cohesion = std::max(soil->cohesion, below ? below->cohesion : 0);
    if (contact.friction_angle < rough && std::tan(contact.friction_angle) > std::tan(soil->friction_angle) * (1 + rounding))
      found.warn(fmt::format("contact.{}.friction_angle", name),
                 fmt::format("is {:.3g} deg, more than that of the soil, {:.3g} deg: the adjacent soil shears first; take at most that of "
                             "the soil, two thirds of it for a smooth coating",
                             degrees(contact.friction_angle), degrees(soil->friction_angle)));
    if (contact.adhesion > cohesion * (1 + rounding))
      found.warn(
          fmt::format("contact.{}.adhesion", name),
          fmt::format("is {:.3g} Pa, more than the cohesion of the soil, {:.3g} Pa: the adjacent soil shears first; take at most that",
                      contact.adhesion, cohesion));
  }
}

void is_tension_that_of_clay(const Scene& s, Findings& found)
{
  for (const auto& [name, contact] : s.c.contact) {
    if (!(contact.tension > 0)) continue;
    const material::Material& material = s.material_of(index_of(s.c.body, contact.body));
    if (has_pore_pressure(material)) continue;
    const std::optional<material::Strength> soil = strength_at_rest(material);
    const bool effective = material::visit(
        [](const auto& law) {
          return requires
          {
            law.critical_friction_angle;
          };
        },
        material);
    if (effective || (soil && soil->friction_angle > 0))
      found.warn(fmt::format("contact.{}.tension", name),
                 fmt::format("is suction of undrained soil, and this soil has friction{}: water flows into drained sand, which separates "
                             "without tension; leave tension out",
                             soil ? fmt::format(", {:.3g} deg", degrees(soil->friction_angle)) : ""));
  }
}

void may_the_sand_rest(const Scene& s, Findings& found)
{
  if (!s.c.mpm.active_distance) return;
  for (const Soil& soil : yielding(s))
    if (const std::optional<material::Strength> strength = strength_at_rest(soil.material); strength && strength->friction_angle > 0)
      return found.warn("mpm.active_distance",
                        fmt::format("makes part of the sand inactive, [material.{}]: with 3 D the sand in a drag vibrated more "
                                    "and H was 15 to 23 % smaller (docs/how_to/what_will_catch_you.md); leave it "
                                    "out, or compare with a run without it",
                                    soil.name));
}

void do_tractions_press(const Scene& s, Findings& found)
{
  for (const auto& [name, traction] : s.c.traction) {
    const bool up = !traction.pressure && s.gravity > 0 && traction.stress.size() > static_cast<std::size_t>(s.up) &&
                    s.up_sign * traction.stress[s.up] > 0;
    const bool pulls = traction.pressure && *traction.pressure < 0;
    if (pulls)
      found.warn(fmt::format("traction.{}.pressure", name),
                 fmt::format("is {:.3g} Pa: it pulls on the soil; a compressive pressure is positive", *traction.pressure));
    if (up)
      found.warn(fmt::format("traction.{}.stress", name),
                 fmt::format("points up, {:.3g} Pa: it pulls on the soil; a surcharge is [0, \"-20 kPa\"]", traction.stress[s.up]));
  }
}

}  // namespace berm::sanity
