// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid.hpp"

namespace berm::mpm {

// What ranks tell each other within a step; nothing happens where one process has all cells. Bits are those of one process.

/// Gets moments and corner sums of the cells in the halo, and lists the nodes anew where other cells of it have particles than before.
template <int dim>
void exchange_moments(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid);

/// Gets CornerSums::sum of the cells in the halo.
template <int dim>
void exchange_corner_sums(BodyGrid<dim>& grid);

/// Gets what the cells in the halo give the water at their corners.
template <int dim>
void exchange_water_forces(BodyGrid<dim>& grid);

/// Sends particles that go to cells of other ranks, and gets those that come. `changes` and transit.particle become those of the particles that go to cells of
/// this rank, in the order of one process.
template <int dim>
void exchange_movers(BodyGrid<dim>& grid, std::vector<bodies::CellChange>& changes, bodies::Transit<dim>& transit);

/// Position and volume of the particles in the halo around nodes where both bodies have mass, while this lives, as particles of their bodies.
template <int dim>
class BorrowedParticles {
public:
  BorrowedParticles(const mesh::Mesh<dim>& mesh, std::vector<bodies::Particles<dim>>& particles, std::vector<BodyGrid<dim>>& grids,
                    Index body, Index other);
  ~BorrowedParticles();
  BorrowedParticles(const BorrowedParticles&) = delete;
  BorrowedParticles& operator=(const BorrowedParticles&) = delete;

private:
  std::vector<std::pair<bodies::Particles<dim>*, Index>> cells_;
};

/// The nodes that the points of the contacts of each body move.
template <int dim>
void list_contact_nodes(const problem::Model<dim>& model, Workspace<dim>& workspace);

/// Gives all ranks a nodal field at those nodes.
template <int dim, class Field>
void exchange_at_contacts(Workspace<dim>& workspace, Field BodyGrid<dim>::*field)
{
  Ranks& ranks = Ranks::of_run();
  if (!ranks.divided()) return;
  for (BodyGrid<dim>& grid : workspace.grids) {
    const auto& nodes = grid.contact_nodes;
    Field& values = grid.*field;
    using Value = std::decay_t<decltype(values[0])>;
    ranks.share<Value>(
        static_cast<Index>(nodes.size()), [&](Index k) { return ranks.owner_of_node(nodes[k]); },
        [&](Index k, Value& value) { value = values[nodes[k]]; }, [&](Index k, const Value& value) { values[nodes[k]] = value; });
  }
}

}  // namespace berm::mpm
