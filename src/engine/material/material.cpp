// SPDX-License-Identifier: BSD-3-Clause
#include "material/material.hpp"

#include "material/laws.hpp"

#include <fmt/format.h>

namespace berm::material {

Material::Material() : Material(LinearElastic{}) {}

bool Material::operator==(const Material& other) const
{
  return visit(
      [&](const auto& law) {
        const auto* same = other.get_if<std::decay_t<decltype(law)>>();
        return same != nullptr && law == *same;
      },
      *this);
}

void describe(Describe& d, Material& material)
{
  Laws::Any law = visit([](const auto& own) { return Laws::Any(own); }, material);
  d.one_of("law", law, Laws::words(), {.meaning = "constitutive law", .required = true});
  material = std::visit([](const auto& chosen) { return Material(chosen); }, law);
}

void check(Describe& d, const std::string& path, const Material& material)
{
  visit(
      [&](const auto& law) {
        check(d, path, law);
        check_depths(d, path, law);
        check_water(d, path, law);
      },
      material);
  d.check(!std::isnan(density(material)), path + ".submerged_unit_weight", "cannot be combined with density: give one of them");
  d.check(density(material) != 0, path + ".density", "is missing, or submerged_unit_weight instead");
  d.check(!(inertia_density(material) < density(material)), path + ".inertia_density",
          fmt::format("is {:.4g} kg/m^3, less than the density that gives the weight, {:.4g} kg/m^3 (submerged_unit_weight / 9.81 m/s2, or "
                      "`density`): it is that of the saturated soil, 1400 to 2200 kg/m^3",
                      inertia_density(material), density(material)));
}

// What the law of a material says by itself.
#define BERM_OF_LAW(Type, query)                                                                                                           \
  Type query(const Material& material)                                                                                                     \
  {                                                                                                                                        \
    return visit([](const auto& law) { return query(law); }, material);                                                                    \
  }
BERM_OF_LAW(Elasticity, elasticity)
BERM_OF_LAW(YoungPoisson, young_poisson)
BERM_OF_LAW(bool, has_pore_pressure)
BERM_OF_LAW(std::optional<Hydraulics>, hydraulics)
BERM_OF_LAW(Real, water_stiffness)
BERM_OF_LAW(std::string, law_name)
BERM_OF_LAW(bool, yields)
BERM_OF_LAW(std::optional<Strength>, strength_at_rest)
BERM_OF_LAW(bool, is_rate_dependent)
BERM_OF_LAW(std::optional<Real>, band_width)
BERM_OF_LAW(bool, dilates)
BERM_OF_LAW(bool, varies)
BERM_OF_LAW(std::vector<Real>, local_values)
BERM_OF_LAW(std::vector<FieldInfo>, local_fields)
BERM_OF_LAW(bool, non_associated)
#undef BERM_OF_LAW

PreparedMaterial prepare(const Material& material)
{
  const auto prepared = [](const auto& law) {
    if constexpr (!total_stress_alone<std::decay_t<decltype(law)>>)
      if (has_pore_pressure(law)) return PreparedMaterial(with_water(prepare(law), water_stiffness(law), min_pore_pressure(*law.water)));
    return PreparedMaterial(prepare(law));
  };
  return visit(prepared, material);
}

Real density(const Material& material)
{
  return visit([](const auto& law) { return law.density; }, material);
}

Real inertia_density(const Material& material)
{
  return visit([](const auto& law) { return law.inertia_density.value_or(law.density); }, material);
}

Material with_inertia_density(Material material, Real density)
{
  visit([&](auto& law) { law.inertia_density = density; }, material);
  return material;
}

Material with_density_times(Material material, Real factor)
{
  visit(
      [&](auto& law) {
        law.density *= factor;
        if (law.inertia_density) *law.inertia_density *= factor;
      },
      material);
  return material;
}

Real p_wave_modulus(const Material& material)
{
  return p_wave_modulus(elasticity(material)) + water_stiffness(material);
}

Real oedometer_modulus(const Material& material, const SymTensor<3>& stress)
{
  constexpr Real strain = 1e-6;
  const Material skeleton = drained(material);
  std::vector<Real> state(static_cast<std::size_t>(state_size(skeleton)), 0.);
  initial_state(skeleton, stress, state.data());
  SymTensor<3> after = stress;
  const Increment<3, Real> increment{SymTensor<3>{{0, -strain, 0}}, 1, 0};
  std::visit([&](const auto& law) { update(law, after, increment, state.data()); }, prepare(skeleton));
  const Real modulus = (stress[1] - after[1]) / strain;
  return modulus > 0 && std::isfinite(modulus) ? modulus : p_wave_modulus(skeleton);
}

int state_size(const Material& material)
{
  return visit([](const auto& law) { return state_count(law) + (has_pore_pressure(law) ? 1 : 0); }, material);
}

std::optional<PoreWater> pore_water(const Material& material)
{
  return visit([](const auto& law) { return law.water; }, material);
}

int pore_pressure_index(const Material& material)
{
  return has_pore_pressure(material) ? state_size(material) - 1 : none;
}

Material drained(Material material)
{
  visit([](auto& law) { law.water.reset(); }, material);
  return material;
}

const char* law_word(const Material& material)
{
  return visit([](const auto& law) { return law.word; }, material);
}

bool same_law(const Material& material, const Material& other)
{
  return std::string_view(law_word(material)) == law_word(other);
}

std::vector<FieldInfo> state_fields(const Material& material)
{
  std::vector<FieldInfo> fields = visit([](const auto& law) { return state_fields(law); }, material);
  if (has_pore_pressure(material)) fields.push_back({"excess_pore_pressure", "excess pore pressure (compression positive)", "Pa"});
  return fields;
}

void initial_state(const Material& material, const SymTensor<3>& stress, Real* state)
{
  visit([&](const auto& law) { initial_state(law, stress, state); }, material);
}

std::optional<Real> shear_strength(const Material& material, Real middle, const Real* state)
{
  return visit([&](const auto& law) { return shear_strength(law, middle, state); }, material);
}

std::optional<Material> with_strength_over(const Material& material, Real factor)
{
  return visit(
      [&](const auto& law) -> std::optional<Material> {
        if (auto weaker = with_strength_over(law, factor)) return Material(*weaker);
        return {};
      },
      material);
}

Material with_rate_smoothing(const Material& material, Real time)
{
  return visit([&](const auto& law) { return Material(with_rate_smoothing(law, time)); }, material);
}

void recover(const Material& material, Real share, Real* state)
{
  visit([&](const auto& law) { recover(law, share, state); }, material);
}

Material with_grain_size(const Material& material, Real d50)
{
  return visit([&](const auto& law) { return Material(with_grain_size(law, d50)); }, material);
}

Material regularised_for(const Material& material, Real size)
{
  return visit([&](const auto& law) { return Material(regularised_for(law, size)); }, material);
}

Material without_dilation(const Material& material)
{
  return visit([](const auto& law) { return Material(without_dilation(law)); }, material);
}

Material with_local_values(const Material& material, const Real* own)
{
  return visit([&](const auto& law) { return Material(with_local_values(law, own)); }, material);
}

Material at_depth(const Material& material, Real depth, Real weight_above)
{
  return visit([&](const auto& law) { return Material(at_depth(law, depth, weight_above)); }, material);
}

const Shansep* shansep(const Material& material)
{
  return visit(
      [](const auto& law) -> const Shansep* {
        if constexpr (KnowsStressHistory<std::decay_t<decltype(law)>>) return law.shansep ? &*law.shansep : nullptr;
        return nullptr;
      },
      material);
}

Material associated(const Material& material, const SymTensor<2>& stress)
{
  return visit([&](const auto& law) { return Material(associated(law, stress)); }, material);
}

}  // namespace berm::material
