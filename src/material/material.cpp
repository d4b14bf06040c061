// SPDX-License-Identifier: BSD-3-Clause
#include "material/material.hpp"

namespace berm::material {

void describe(Describe& d, Material& material)
{
  d.one_of("law", material, {"linear_elastic", "mohr_coulomb"}, {.meaning = "how stress follows strain", .required = true});
}

void check(Describe& d, const std::string& path, const Material& material)
{
  if (const auto* law = std::get_if<MohrCoulomb>(&material))
    d.check(law->dilation_angle <= law->friction_angle, path + ".dilation_angle",
            "the dilation angle cannot be larger than the friction angle");
  d.check(inertia_density(material) >= density(material), path + ".inertia_density",
          "cannot be less than density, which the weight comes from");
}

Real density(const Material& material)
{
  return std::visit([](const auto& law) { return law.density; }, material);
}

Real inertia_density(const Material& material)
{
  return std::visit([](const auto& law) { return law.inertia_density.value_or(law.density); }, material);
}

Elasticity elasticity(const Material& material)
{
  return std::visit([](const auto& law) { return elasticity(law); }, material);
}

Real p_wave_modulus(const Material& material)
{
  return p_wave_modulus(elasticity(material));
}

int state_size(const Material& material)
{
  return std::visit([](const auto& law) { return law.state_size; }, material);
}

bool yields(const Material& material)
{
  return !std::holds_alternative<LinearElastic>(material);
}

bool dilates(const Material& material)
{
  const auto* law = std::get_if<MohrCoulomb>(&material);
  return law != nullptr && law->dilation_angle > 0;
}

Material without_dilation(Material material)
{
  if (auto* law = std::get_if<MohrCoulomb>(&material)) {
    law->max_opening = prepare(*law).max_opening;
    law->dilation_angle = 0;
  }
  return material;
}

}  // namespace berm::material
