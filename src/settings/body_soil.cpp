// SPDX-License-Identifier: BSD-3-Clause
#include "settings/body_soil.hpp"

#include "material/clay.hpp"
#include "material/mohr_coulomb.hpp"
#include "material/ngi_adp.hpp"
#include "os/error.hpp"
#include "settings/case.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::settings {
namespace {

/// The number of a material in the list, which it is added to where no equal one is there.
/// One that varies at random is no other's equal.
Index add(BodySoil& soil, const Case& c, const std::string& name)
{
  const material::Material& material = c.material[index_of(c.material, name)].second;
  const auto varies = [&](const std::string& other) {
    return std::any_of(c.random_field.begin(), c.random_field.end(), [&](const auto& field) { return field.second.material == other; });
  };
  for (std::size_t k = 0; k < soil.materials.size(); ++k)
    if (soil.names[k] == name || (soil.materials[k] == material && !varies(name) && !varies(soil.names[k]))) return static_cast<Index>(k);
  soil.materials.push_back(material);
  soil.names.push_back(name);
  return static_cast<Index>(soil.materials.size()) - 1;
}

/// Whether the stiffness of a material is that of its strength by a rigidity index.
bool has_rigidity_index(const material::Material& material)
{
  const auto* clay = material.get_if<material::Clay>();
  const auto* adp = material.get_if<material::NgiAdp>();
  return (clay != nullptr && clay->rigidity_index) || (adp != nullptr && adp->rigidity_index);
}

// Classes of a field of friction angles or densities, from -4 to 4 standard deviations of the logarithm.
constexpr Real class_width = 0.1;
constexpr int classes_to_a_side = 40, class_count = 2 * classes_to_a_side + 1;

/// The number of the class of a value of the Gaussian field, from 0.
Index class_of(Real score)
{
  const Real number = std::clamp<Real>(std::round(score / class_width), -classes_to_a_side, classes_to_a_side);
  return static_cast<Index>(number) + classes_to_a_side;
}

/// With tan(phi) so many times as large. The dilation angle stays, but is at most the friction angle; associated flow stays so.
material::Material with_friction_times(const material::Material& material, Real factor)
{
  material::MohrCoulomb law = *material.get_if<material::MohrCoulomb>();
  const bool associated = law.dilation_angle == law.friction_angle;
  law.friction_angle = std::atan(factor * std::tan(law.friction_angle));
  law.dilation_angle = associated ? law.friction_angle : std::min(law.dilation_angle, law.friction_angle);
  return material::Material(law);
}

/// tan(phi) or density of a class over the mean.
Real factor_of_class(const RandomFieldSettings& field, Index number)
{
  const Real deviation = field.log_deviation();
  return std::exp(deviation * (number - classes_to_a_side) * class_width - deviation * deviation / 2);
}

/// Appends the materials of the classes of a field, for each class of another field of its material.
void add_classes(BodySoil& soil, SoilField& field)
{
  Index first = field.material, count = 1;
  for (const SoilField& other : soil.fields)
    if (other.material == field.material && other.first_class != none) first = other.first_class, count *= class_count;
  const std::string name = soil.names[field.material];
  field.first_class = static_cast<Index>(soil.materials.size());
  for (Index k = first; k < first + count; ++k)
    for (Index number = 0; number < class_count; ++number) {
      const Real factor = factor_of_class(field.settings, number);
      soil.materials.push_back(field.settings.of_friction() ? with_friction_times(soil.materials[k], factor)
                                                            : with_density_times(soil.materials[k], factor));
      soil.names.push_back(name);
    }
}

/// The integral of density over its mean, less 1, from a depth to another on the vertical of a place, m.
Real excess_above(const SoilField& field, SoilPlace place, Real top, Real bottom)
{
  const Real cell = field.values->cell_size(1);
  const auto excess_in = [&](Real from, Real to) {
    place.depth = (from + to) / 2;
    return (to - from) * (factor_of_class(field.settings, class_of(field.values->at(place))) - 1);
  };
  if (!std::isfinite(cell)) return excess_in(top, bottom);
  Real sum = 0;
  for (auto k = static_cast<Index>(std::floor(top / cell)); k * cell < bottom; ++k)
    sum += excess_in(std::max(top, k * cell), std::min(bottom, (k + 1) * cell));
  return sum;
}

/// The random fields of the materials of a body.
void add_fields(BodySoil& soil, const Case& c)
{
  for (const auto& [name, field] : c.random_field) {
    const auto material = std::find(soil.names.begin(), soil.names.end(), field.material);
    if (material == soil.names.end()) continue;
    const auto number = static_cast<std::size_t>(material - soil.names.begin());
    if (field.by_classes()) {
      if (field.of_density() || has_friction(soil.materials[number]))
        soil.fields.push_back({"random_field." + name, field, static_cast<Index>(number), 0});
      continue;
    }
    const std::vector<FieldInfo> own = local_fields(soil.materials[number]);
    const auto place = std::find_if(own.begin(), own.end(), [&, &field = field](const FieldInfo& f) { return f.name == field.property; });
    if (place == own.end()) continue;  // of a visitor that does not throw
    soil.fields.push_back({"random_field." + name, field, static_cast<Index>(number), static_cast<std::size_t>(place - own.begin()),
                           place->name != stiffness_word && has_rigidity_index(soil.materials[number])});
  }
}

Real size_of_gravity(const Case& c)
{
  Real size = 0;
  for (const Real g : c.gravity) size = std::hypot(size, g);
  return size;
}

/// Whether density over inertia density of a material is another, beyond what digits in the input do to it.
bool differs_from(Real ratio, const material::Material& material)
{
  constexpr Real same = 1e-6;
  return !(std::abs(density(material) / inertia_density(material) / ratio - 1) < same);
}

/// Whether all materials that a body names are there.
bool knows_materials(const Case& c, const bodies::BodySettings& body)
{
  const std::vector<std::string> names = materials_of(body);
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) { return index_of(c.material, name) != none; });
}

/// Refuses a strength by the vertical stress where that is not known.
void check_vertical_stress(Describe& d, const Case& c, const std::string& path, const bodies::BodySettings& body)
{
  if (!knows_materials(c, body)) return;  // of a visitor that does not throw
  const BodySoil soil = soil_of(c, body);
  const Real first = density(soil.materials.front());
  const bool one_density = std::all_of(soil.of_region.begin(), soil.of_region.end(),
                                       [&](const auto& region) { return density(soil.materials[region.second]) == first; });
  for (std::size_t k = 0; k < soil.materials.size(); ++k) {
    if (shansep(soil.materials[k]) == nullptr) continue;
    const std::string key = "material." + soil.names[k] + ".shansep";
    d.check(soil.gravity > 0 || soil.vertical_stress_at_start, key,
            fmt::format("needs the vertical stress at the start: there is neither gravity nor {}.initial_stress", path));
    d.check(soil.vertical_stress_at_start.value_or(1) > 0, path + ".initial_stress",
            fmt::format("needs vertical compression, a negative second number, from which the strength of [material.{}] follows",
                        soil.names[k]));
    d.check(one_density || soil.vertical_stress_at_start, key,
            fmt::format("counts the weight above in layers: give the soils of [{}] by soil_layer instead of region_material, or give them "
                        "one density",
                        path));
  }
}

}  // namespace

std::vector<std::string> materials_of(const bodies::BodySettings& body)
{
  std::vector<std::string> names = {body.material};
  for (const bodies::SoilLayerSettings& layer : body.soil_layer) names.push_back(layer.material);
  for (const auto& entry : body.region_material) names.push_back(entry.second);
  for (const bodies::FillSettings& fill : body.fill) names.push_back(fill.material);
  return names;
}

bool is_used(const Case& c, const std::string& material)
{
  return std::any_of(c.body.begin(), c.body.end(), [&](const auto& entry) {
    const std::vector<std::string> names = materials_of(entry.second);
    return std::find(names.begin(), names.end(), material) != names.end();
  });
}

Index BodySoil::material_index_at(const std::string& region, Real depth) const
{
  if (const auto found = of_region.find(region); found != of_region.end()) return found->second;
  Index number = 0;
  for (const SoilLayer& layer : layers)
    if (depth >= layer.top) number = layer.material;
  return number;
}

Index BodySoil::material_index_at(const std::string& region, const SoilPlace& place) const
{
  const Index mean = material_index_at(region, place.depth);
  Index first = mean, number = 0;
  for (const SoilField& field : fields)
    if (field.material == mean && field.first_class != none) {
      first = field.first_class;
      number = number * class_count + class_of(field.values->at(place));
    }
  return first + number;
}

material::Material BodySoil::at(const std::string& region, Real depth) const
{
  return at_depth(materials[material_index_at(region, depth)], depth, vertical_stress(region, depth));
}

material::Material BodySoil::at(const std::string& region, const SoilPlace& place) const
{
  if (fields.empty()) return at(region, place.depth);
  const material::Material& own_law = materials[material_index_at(region, place)];
  const bool by_history = shansep(own_law) != nullptr;  // alone takes the stress, a sum along the vertical
  const material::Material there = at_depth(own_law, place.depth, by_history ? vertical_stress(region, place) : 0);
  const Index number = material_index_at(region, place.depth);
  std::vector<Real> own = local_values(there);
  for (const SoilField& field : fields) {
    if (field.material != number || field.settings.by_classes()) continue;
    const Real deviation = field.settings.log_deviation();
    const Real over_mean = std::exp(deviation * field.values->at(place) - deviation * deviation / 2);
    own[field.place] *= over_mean;
    if (field.with_stiffness) own.back() *= over_mean;
  }
  return with_local_values(there, own.data());
}

material::Material BodySoil::in_fill(Index material, Real depth) const
{
  return at_depth(materials[material], depth, gravity * density(materials[material]) * depth);
}

Real BodySoil::vertical_stress(const std::string& region, Real depth) const
{
  return vertical_stress_at_start.value_or(gravity * mass_above(region, std::max(Real(0), depth)));
}

Real BodySoil::mass_above(const std::string& region, Real depth) const
{
  if (layers.empty()) return density(materials[material_index_at(region, depth)]) * depth;
  Real sum = 0, top = 0, of_layer = density(materials.front());
  for (const SoilLayer& layer : layers) {
    if (layer.top >= depth) break;
    sum += of_layer * (layer.top - top);
    top = layer.top;
    of_layer = density(materials[layer.material]);
  }
  return sum + of_layer * (depth - top);
}

Real BodySoil::mass_above(const std::string& region, const SoilPlace& place) const
{
  Real sum = mass_above(region, std::max(Real(0), place.depth));
  for (const SoilField& field : fields) {
    if (!field.settings.of_density() || field.first_class == none) continue;
    const auto add = [&](Index material, Real top, Real bottom) {
      if (material == field.material && top < bottom) sum += density(materials[material]) * excess_above(field, place, top, bottom);
    };
    Real top = 0;
    Index above = layers.empty() ? material_index_at(region, place.depth) : 0;
    for (const SoilLayer& layer : layers) {
      add(above, top, std::min(layer.top, place.depth));
      top = layer.top, above = layer.material;
    }
    add(above, top, place.depth);
  }
  return sum;
}

Real BodySoil::vertical_stress(const std::string& region, const SoilPlace& place) const
{
  return vertical_stress_at_start.value_or(gravity * mass_above(region, place));
}

BodySoil soil_of_one(const material::Material& material, const std::string& name)
{
  return {{material}, {name}};
}

BodySoil soil_of(const Case& c, const bodies::BodySettings& body)
{
  BodySoil soil;
  soil.gravity = size_of_gravity(c);
  if (body.initial_stress.size() == 3) soil.vertical_stress_at_start = -body.initial_stress[1];
  add(soil, c, body.material);
  for (const bodies::SoilLayerSettings& layer : body.soil_layer) soil.layers.push_back({layer.top, add(soil, c, layer.material)});
  for (const auto& [region, name] : body.region_material) soil.of_region[region] = add(soil, c, name);
  for (const bodies::FillSettings& fill : body.fill) soil.of_fill.push_back(add(soil, c, fill.material));
  if (c.method == Method::mpm && !hydraulics(soil.materials.front())) {
    const Real ratio = density(soil.materials.front()) / inertia_density(soil.materials.front());
    for (material::Material& material : soil.materials)
      if (differs_from(ratio, material)) material = with_inertia_density(material, density(material) / ratio);
  }
  if (!c.random_field.empty()) add_fields(soil, c);
  if (soil.materials.size() > 1) return soil;
  soil.layers.clear();
  soil.of_region.clear();
  return soil;
}

bool has_friction(const material::Material& material)
{
  const auto* law = material.get_if<material::MohrCoulomb>();
  return law != nullptr && law->friction_angle > 0;
}

void make_random_fields(BodySoil& soil, const SoilPlace& lower, const SoilPlace& upper)
{
  for (SoilField& field : soil.fields) {
    const material::Material material = soil.materials[field.material];
    const Real deviation = field.settings.log_deviation();
    std::vector<RandomField::Known> known;
    for (const SoundingSettings& sounding : field.settings.sounding)
      for (std::size_t k = 0; k < sounding.depth.size(); ++k) {
        const Real depth = sounding.depth[k], mean = local_values(at_depth(material, depth, soil.vertical_stress("", depth)))[field.place];
        if (!(mean > 0))
          throw KeyError(fmt::format("{}.sounding: {:.4g} m deep the mean of {} is 0", field.path, depth, field.settings.property));
        known.push_back({{sounding.x, depth, sounding.z}, std::log(sounding.value[k] / mean) / deviation + deviation / 2});
      }
    field.values = std::make_shared<const RandomField>(field.settings, field.path, lower, upper, known);
    if (field.settings.by_classes()) add_classes(soil, field);
  }
}

bool varies(const BodySoil& soil)
{
  return soil.materials.size() > 1 || !soil.fields.empty() || varies(soil.materials.front());
}

std::vector<FieldInfo> local_fields(const BodySoil& soil)
{
  if (!varies(soil)) return {};
  std::vector<FieldInfo> fields = local_fields(soil.materials.front());
  if (soil.materials.size() > 1) fields.push_back({"material", "number of the material in its body, from 0", ""});
  return fields;
}

std::vector<Real> local_values(const BodySoil& soil, const std::string& region, const SoilPlace& place)
{
  if (!varies(soil)) return {};
  return local_values(soil, soil.material_index_at(region, place), soil.at(region, place));
}

std::vector<Real> local_values(const BodySoil& soil, Index material, const material::Material& there)
{
  if (!varies(soil)) return {};
  std::vector<Real> values = local_values(there);
  if (soil.materials.size() > 1) values.push_back(static_cast<Real>(material));
  return values;
}

int material_index_offset(const BodySoil& soil)
{
  if (soil.materials.size() < 2) return none;
  return state_size(soil.materials.front()) + static_cast<int>(local_fields(soil.materials.front()).size());
}

const material::Material& material_of(const BodySoil& soil, const Real* extra)
{
  const int offset = material_index_offset(soil);
  return offset == none ? soil.materials.front() : soil.materials[static_cast<std::size_t>(extra[offset])];
}

std::vector<FieldInfo> particle_extra(const BodySoil& soil)
{
  std::vector<FieldInfo> fields = state_fields(soil.materials.front());
  // A state variable is shown where one of the materials shows it.
  for (const material::Material& material : soil.materials) {
    const std::vector<FieldInfo> own = state_fields(material);
    for (std::size_t k = 0; k < fields.size(); ++k) fields[k].travel |= own[k].travel;
  }
  const std::vector<FieldInfo> own = local_fields(soil);
  fields.insert(fields.end(), own.begin(), own.end());
  return fields;
}

void check_soil(Describe& d, const Case& c, const std::string& path, const bodies::BodySettings& body)
{
  std::vector<std::string> known;
  for (const auto& entry : c.material) known.push_back(entry.first);
  const auto check_material = [&](const std::string& key, const std::string& name) {
    const Index own = index_of(c.material, body.material), other = index_of(c.material, name);
    d.check(other != none, key, fmt::format("there is no [material.{}]", name), known);
    if (own == none || other == none) return;
    const material::Material &first = c.material[own].second, &second = c.material[other].second;
    d.check(same_law(first, second), key,
            fmt::format("[material.{}] has the law \"{}\", [material.{}] of the same body \"{}\": all materials of a body need one law; "
                        "make another body of it, a region of the mesh, and join the two by a [contact] with scheme = \"tied\"",
                        name, law_word(second), body.material, law_word(first)));
    d.check(
        has_pore_pressure(first) == has_pore_pressure(second) && hydraulics(first).has_value() == hydraulics(second).has_value(), key,
        fmt::format("[material.{}] and [material.{}] of the same body differ in water.drainage: give all materials of a body the same, or "
                    "make another body of it",
                    name, body.material));
    d.check(state_size(first) == state_size(second), key,
            fmt::format("[material.{}] has {} state variables, [material.{}] of the same body {}: they need as many", name,
                        state_size(second), body.material, state_size(first)));
    const Real ratio = density(first) / inertia_density(first);
    d.check(c.method == Method::fem || !hydraulics(first) || !differs_from(ratio, second), key,
            fmt::format(
                "the materials of a body whose water flows need the same ratio of density to inertia_density: inertia_density = \"{:.9g} "
                "kg/m^3\" in [material.{}] gives that of [material.{}]",
                density(second) / ratio, name, body.material));
  };
  d.check(body.soil_layer.empty() || body.region_material.empty(), path + ".region_material", "cannot be combined with soil_layer");
  for (std::size_t k = 0; k < body.soil_layer.size(); ++k) {
    const std::string item = fmt::format("{}.soil_layer[{}]", path, k);
    check_material(item + ".material", body.soil_layer[k].material);
    const bodies::K0Settings at_rest = body.soil_layer[k].at_rest();
    d.check(!at_rest.given() || body.has_k0(),
            item + (at_rest.k0    ? ".k0"
                    : at_rest.ocr ? ".k0_ocr"
                                  : ".k0_pop"),
            fmt::format("needs {}.k0, that of the soil above", path));
    d.check(k == 0 || body.soil_layer[k].top > body.soil_layer[k - 1].top, item + ".top", "must be deeper than that of the layer above");
  }
  for (const auto& [region, name] : body.region_material) {
    const std::string key = path + ".region_material." + region;
    d.check(std::find(body.regions.begin(), body.regions.end(), region) != body.regions.end(), key, "the body does not fill this region",
            body.regions);
    check_material(key, name);
  }
  for (std::size_t k = 0; k < body.fill.size(); ++k) check_material(fmt::format("{}.fill[{}].material", path, k), body.fill[k].material);
  check_vertical_stress(d, c, path, body);
}

namespace {

/// The sine of the friction angle of a material; NaN where its law has none.
Real sin_friction_of(const Case& c, const std::string& name)
{
  const Index number = index_of(c.material, name);
  const std::optional<material::Strength> strength = number == none ? std::nullopt : strength_at_rest(c.material[number].second);
  return strength && strength->friction_angle > 0 ? std::sin(strength->friction_angle) : nan;
}

void check_k0(Describe& d, const Case& c, const std::string& path, const bodies::K0Settings& own, const bodies::K0Settings& acts,
              const std::string& material, Real sine)
{
  d.check(own.k0.has_value() + own.ocr.has_value() + own.pop.has_value() <= 1, path + ".k0", "is given by one of k0, k0_ocr and k0_pop");
  const Index number = index_of(c.material, material);
  if (number == none) return;
  d.check(!acts.by_history() || !std::isnan(sine),
          path + (own.ocr   ? ".k0_ocr"
                  : own.pop ? ".k0_pop"
                            : ""),
          fmt::format("K0 follows from it by the friction angle, and [material.{}] with the law \"{}\" has none: give k0", material,
                      law_word(c.material[number].second)));
}

}  // namespace

void find_k0(Describe& d, const Case& c, const std::string& path, bodies::BodySettings& body)
{
  body.sin_friction = sin_friction_of(c, body.material);
  check_k0(d, c, path, body.at_rest(), body.at_rest(), body.material, body.sin_friction);
  for (std::size_t k = 0; k < body.soil_layer.size(); ++k) {
    bodies::SoilLayerSettings& layer = body.soil_layer[k];
    layer.sin_friction = sin_friction_of(c, layer.material);
    check_k0(d, c, fmt::format("{}.soil_layer[{}]", path, k), layer.at_rest(), layer.at_rest().given() ? layer.at_rest() : body.at_rest(),
             layer.material, layer.sin_friction);
  }
  d.check(!body.at_rest().by_history() || body.region_material.empty(), path + ".region_material",
          "cannot be combined with k0_ocr and k0_pop, which follow layers: give the soils by soil_layer, or k0");
}

void refuse_no_strength(const BodySoil& soil, const std::string& region, Real depth, const std::string& body)
{
  const Index number = soil.material_index_at(region, depth);
  const material::Material there = soil.at(region, depth);
  const std::vector<FieldInfo> fields = local_fields(there);
  const std::vector<Real> values = local_values(there);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const bool stiffness = fields[k].name == "young_modulus";
    if (stiffness ? values[k] > 0 : values[k] >= 0) continue;
    throw KeyError(
        fmt::format("material.{0}.{1}_gradient: {2:.4g} m below the surface {1} is {3:.4g} Pa, and [body.{4}] reaches that deep: {5}",
                    soil.names[number], fields[k].name, depth, values[k], body, "take a smaller decrease, or a profile"));
  }
}

SoilWaves waves_of(const material::Material& material)
{
  const Real density = inertia_density(material), speed = std::sqrt(p_wave_modulus(material) / density);
  const std::optional<material::Hydraulics> water = hydraulics(material);
  const Real stiffness = water_stiffness(material);
  const Real fastest = water ? material::fast_wave_speed(p_wave_modulus(material) - stiffness, stiffness, density, water->porosity) : speed;
  const Real shear = elasticity(material).shear, bulk = p_wave_modulus(material) - 4. / 3 * shear;
  return {fastest, speed, speed, density, std::sqrt(p_wave_modulus(material) * density), density, bulk / density, 2 * shear / density};
}

}  // namespace berm::settings
