// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/quality/quality_section_test.cpp
#include "structures/base/near_mesh.hpp"

#include "structures/base/driven_body.hpp"

namespace berm::base {

Real near_cell_size(const problem::Case& c)
{
  if (c.method == problem::Method::fem && c.fem.contact_size) return *c.fem.contact_size;
  if (const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) return bed->near_size;
  const auto* box = std::get_if<mesh::BoxMesh>(&c.mesh);
  if (box == nullptr) return nan;
  Real size = 0;
  for (std::size_t d = 0; d < box->size.size(); ++d) size = std::max(size, box->size[d] / box->cells[d]);
  return size;
}

NearCells near_cells(const record::RunRecord& run)
{
  const Real named = near_cell_size(run.settings), found = run.check("cells_at_body_first_m"),
             largest = run.check("cells_at_body_largest_m");
  const Real first = std::isnan(named) ? found : named;
  return {first, first * largest / found};
}

Real near_particles(const problem::Case& c)
{
  if (c.method == problem::Method::fem || c.body.empty()) return nan;
  const contact::ContactSettings* contact = contact_of_body(c);
  const Index body = contact == nullptr ? 0 : problem::index_of(c.body, contact->body);
  const bodies::BodySettings& settings = c.body[body].second;
  const Real spacing = settings.block ? settings.block->spacing : settings.disk ? settings.disk->spacing : 0;
  if (spacing > 0) return std::pow(std::round(near_cell_size(c) / spacing), c.dimension());
  const auto near = settings.region_particles_per_cell.find("near");
  if (near != settings.region_particles_per_cell.end()) return near->second;
  // The default of the bodies' filling.
  return settings.particles_per_cell > 0 ? settings.particles_per_cell : c.dimension() == 2 ? 9 : 8;
}

}  // namespace berm::base
