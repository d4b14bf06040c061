// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/move_local_strength_test.cpp
#include "mpm/body_laws.hpp"

namespace berm::mpm {

std::shared_ptr<const BodyLaws> laws_of(const problem::BodySoil& soil, const problem::MpmSettings& settings)
{
  BodyLaws all{.laws = {},
               .laws_without_dilation = {},
               .volume_rules = {},
               .dilates = dilates(soil.materials.front()),
               .local_strength = varies(soil),
               .material_index_offset = problem::material_index_offset(soil)};
  for (const material::Material& material : soil.materials) {
    all.laws.push_back(prepare(material));
    all.laws_without_dilation.push_back(prepare(without_dilation(material)));
    const Real per_density = 1 / inertia_density(material);
    all.volume_rules.push_back({settings.min_volume_ratio * per_density, settings.max_volume_ratio * per_density, dilates(material)});
  }
  return std::make_shared<const BodyLaws>(std::move(all));
}

}  // namespace berm::mpm
