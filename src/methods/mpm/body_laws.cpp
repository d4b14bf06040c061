// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/move_local_strength_test.cpp
#include "mpm/body_laws.hpp"

#include <algorithm>
#include <map>

namespace berm::mpm {
namespace {

constexpr Real class_width = 0.01;  // of the logarithm of the size of a cell: friction differs by less than 0.1 % in a class

/// The sizes, m, of the classes of cells, one of no meaning where no material depends on it; and the class of each cell, empty where there is one.
struct CellClasses {
  std::vector<Real> sizes;
  CellField<Index> of_cell;
};

template <int dim>
CellClasses classes_of(const settings::BodySoil& soil, const mesh::Mesh<dim>& mesh)
{
  const auto depends = [](const material::Material& material) { return band_width(material).has_value(); };
  CellClasses classes;
  if (std::none_of(soil.materials.begin(), soil.materials.end(), depends)) {
    classes.sizes = {1};
    return classes;
  }
  const auto number_of = [&](Index cell) { return static_cast<int>(std::lround(std::log(mesh.size(cell)) / class_width)); };
  std::map<int, Index> found;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) found[number_of(cell)] = 0;
  for (auto& [number, index] : found) {
    index = static_cast<Index>(classes.sizes.size());
    classes.sizes.push_back(std::exp(class_width * number));
  }
  classes.of_cell = CellField<Index>::zeros(mesh.cell_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) classes.of_cell[cell] = found[number_of(cell)];
  return classes;
}

const void* address_of(const material::PreparedMaterial& law)
{
  return std::visit([](const auto& own) -> const void* { return &own; }, law);
}

}  // namespace

template <int dim>
std::shared_ptr<const BodyLaws> laws_of(const settings::BodySoil& soil, const settings::MpmSettings& settings, const mesh::Mesh<dim>& mesh)
{
  auto all = std::make_shared<BodyLaws>();
  all->dilates = dilates(soil.materials.front());
  all->local_strength = varies(soil);
  all->material_index_offset = settings::material_index_offset(soil);
  for (const material::Material& material : soil.materials) {
    const Real per_density = 1 / inertia_density(material);
    all->volume_rules.push_back({settings.min_volume_ratio * per_density, settings.max_volume_ratio * per_density, dilates(material)});
  }
  CellClasses classes = classes_of(soil, mesh);
  for (const Real size : classes.sizes)
    for (const material::Material& material : soil.materials) {
      const material::Material here = regularised_for(material, size);
      all->prepared.push_back(prepare(here));
      all->prepared.push_back(prepare(without_dilation(here)));
    }
  for (std::size_t k = 0; k < all->prepared.size(); k += 2) {
    all->laws.push_back(address_of(all->prepared[k]));
    all->laws_without_dilation.push_back(address_of(all->prepared[k + 1]));
  }
  for (Index& first : classes.of_cell) first *= static_cast<Index>(soil.materials.size());
  all->first_of_cell = std::move(classes.of_cell);
  return all;
}

template std::shared_ptr<const BodyLaws> laws_of(const settings::BodySoil&, const settings::MpmSettings&, const mesh::Mesh<2>&);
template std::shared_ptr<const BodyLaws> laws_of(const settings::BodySoil&, const settings::MpmSettings&, const mesh::Mesh<3>&);

}  // namespace berm::mpm
