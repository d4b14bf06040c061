// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/ranks/run
#include "mpm/exchange.hpp"

#include "core/bytes.hpp"
#include "os/error.hpp"

#include <fmt/format.h>
#include <numeric>

namespace berm::mpm {

template <int dim>
void exchange_moments(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, BodyGrid<dim>& grid)
{
  if (!grid.halo.divided()) return;
  const Timer timer("ranks");
  bool other_cells = false;
  std::vector<Index> before;
  grid.halo.exchange(
      [&](Halo::Side& side, std::vector<std::byte>& out) {
        side.sent.clear();
        for (const Index cell : side.inner)
          if (particles.count_in(cell) > 0) side.sent.push_back(cell);
        const std::size_t count = side.sent.size();
        put_bytes(out, &count);
        put_bytes(out, side.sent.data(), count);
        for (const Index cell : side.sent) put_bytes(out, &grid.moments[cell]), put_bytes(out, &grid.corners[cell]);
        for (const Index cell : side.sent)
          if (!grid.hoop.empty()) put_bytes(out, &grid.hoop[cell]);
        for (const Index cell : side.sent)
          if (grid.water.flows()) put_bytes(out, &grid.water.cells[cell]);
      },
      [&](Halo::Side& side, const std::vector<std::byte>& in) {
        for (const Index cell : side.got) {
          grid.moments[cell] = {};
          grid.corners[cell] = {};
          grid.volume_change[cell] = {};
          if (!grid.hoop.empty()) grid.hoop[cell] = {};
          if (grid.water.flows()) grid.water.cells[cell] = {}, grid.water.corners[cell] = {}, grid.water.outflow[cell] = {};
        }
        std::size_t count = 0;
        const std::byte* at = get_bytes(in.data(), &count);
        before.swap(side.got);
        side.got.resize(count);
        at = get_bytes(at, side.got.data(), count);
        for (const Index cell : side.got) at = get_bytes(get_bytes(at, &grid.moments[cell]), &grid.corners[cell]);
        for (const Index cell : side.got)
          if (!grid.hoop.empty()) at = get_bytes(at, &grid.hoop[cell]);
        for (const Index cell : side.got)
          if (grid.water.flows()) at = get_bytes(at, &grid.water.cells[cell]);
        other_cells = other_cells || side.got != before;
      });
  if (other_cells) find_nodes(mesh, particles, grid);
}

template <int dim>
void exchange_corner_sums(BodyGrid<dim>& grid)
{
  if (!grid.halo.divided()) return;
  const Timer timer("ranks");
  grid.halo.exchange(
      [&](const Halo::Side& side, std::vector<std::byte>& out) {
        for (const Index cell : side.sent)
          for (const CornerSums<dim>& corner : grid.corners[cell]) put_bytes(out, corner.sum, dim);
      },
      [&](const Halo::Side& side, const std::vector<std::byte>& in) {
        const std::byte* at = in.data();
        for (const Index cell : side.got)
          for (CornerSums<dim>& corner : grid.corners[cell]) at = get_bytes(at, corner.sum, dim);
      });
}

template <int dim>
void exchange_water_forces(BodyGrid<dim>& grid)
{
  if (!grid.halo.divided() || !grid.water.flows()) return;
  const Timer timer("ranks");
  grid.halo.exchange(
      [&](const Halo::Side& side, std::vector<std::byte>& out) {
        for (const Index cell : side.sent) put_bytes(out, &grid.water.corners[cell]), put_bytes(out, &grid.water.pressure[cell]);
      },
      [&](const Halo::Side& side, const std::vector<std::byte>& in) {
        const std::byte* at = in.data();
        for (const Index cell : side.got) at = get_bytes(get_bytes(at, &grid.water.corners[cell]), &grid.water.pressure[cell]);
      });
}

template <int dim>
void exchange_movers(BodyGrid<dim>& grid, std::vector<bodies::CellChange>& changes, bodies::Transit<dim>& transit)
{
  if (!grid.halo.divided()) return;
  const Timer timer("ranks");
  const Ranks& ranks = Ranks::of_run();
  Halo& halo = grid.halo;
  for (const bodies::CellChange& change : changes) {
    const int owner = ranks.owner_of_cell(change.to);
    const auto is_owner = [&](const Messenger::Letter& letter) { return letter.rank == owner; };
    if (owner != ranks.rank() && std::none_of(halo.letters.begin(), halo.letters.end(), is_owner))
      throw RunError(fmt::format("a particle went from cell {} to cell {} in one step, past all cells around it; try a smaller mpm.courant",
                                 change.from, change.to));
  }
  std::vector<bodies::CellChange> all;
  std::vector<bodies::Particle<dim>> particles;
  const auto add = [&](const bodies::CellChange& change, const bodies::Particle<dim>& particle) {
    all.push_back(change);
    particles.push_back(particle);
  };
  for (std::size_t m = 0; m < changes.size(); ++m)
    if (ranks.owns_cell(changes[m].to)) add(changes[m], transit.particle[m]);
  std::size_t side_number = 0;
  halo.exchange(
      [&](const Halo::Side&, std::vector<std::byte>& out) {
        const int to = halo.letters[side_number++].rank;
        for (std::size_t m = 0; m < changes.size(); ++m)
          if (ranks.owner_of_cell(changes[m].to) == to) put_bytes(out, &changes[m]), put_bytes(out, &transit.particle[m]);
      },
      [&](const Halo::Side&, const std::vector<std::byte>& in) {
        bodies::CellChange change{};
        bodies::Particle<dim> particle;
        for (const std::byte* at = in.data(); at != in.data() + in.size();) {
          at = get_bytes(get_bytes(at, &change), &particle);
          add(change, particle);
        }
      });
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return std::pair(all[a].from, all[a].index) < std::pair(all[b].from, all[b].index); });
  changes.clear();
  transit.particle.clear();
  for (const std::size_t k : order) {
    changes.push_back(all[k]);
    transit.particle.push_back(particles[k]);
  }
}

template <int dim>
BorrowedParticles<dim>::BorrowedParticles(const mesh::Mesh<dim>& mesh, std::vector<bodies::Particles<dim>>& particles,
                                          std::vector<BodyGrid<dim>>& grids, Index body, Index other)
{
  if (!grids[body].halo.divided()) return;
  const Timer timer("ranks");
  struct Borrowed {
    Index cell;
    Vec<dim> x;
    Real volume;
  };
  const auto is_shared = [&](Index node) { return grids[body].mass[node] > 0 && grids[other].mass[node] > 0; };
  for (const Index b : {body, other})
    grids[b].halo.exchange(
        [&](const Halo::Side& side, std::vector<std::byte>& out) {
          for (const Index cell : side.inner) {
            if (std::none_of(mesh.nodes[cell].begin(), mesh.nodes[cell].end(), is_shared)) continue;
            for (Index k = 0; k < particles[b].count_in(cell); ++k) {
              const bodies::Particle<dim> p = particles[b].read_at(cell, k);
              const Borrowed borrowed{cell, p.x, p.volume};
              put_bytes(out, &borrowed);
            }
          }
        },
        [&](const Halo::Side&, const std::vector<std::byte>& in) {
          Borrowed borrowed{};
          bodies::Particle<dim> p;
          for (const std::byte* at = in.data(); at != in.data() + in.size();) {
            at = get_bytes(at, &borrowed);
            p.x = borrowed.x;
            p.volume = borrowed.volume;
            particles[b].insert(borrowed.cell, p);
            cells_.emplace_back(&particles[b], borrowed.cell);
          }
        });
}

template <int dim>
BorrowedParticles<dim>::~BorrowedParticles()
{
  for (const auto& [particles, cell] : cells_) particles->take(cell, particles->count_in(cell) - 1);
}

template <int dim>
void list_contact_nodes(const problem::Model<dim>& model, Workspace<dim>& workspace)
{
  if (!Ranks::of_run().divided()) return;
  for (BodyGrid<dim>& grid : workspace.grids) grid.contact_nodes.clear();
  for (std::size_t k = 0; k < model.contacts.size(); ++k)
    for (const contact::ContactPoint<dim>& point : workspace.contact_points[k].list)
      for (const Index b : {model.contacts[k].body, model.contacts[k].other_body})
        if (b != none)
          workspace.grids[b].contact_nodes.insert(workspace.grids[b].contact_nodes.end(), point.nodes.begin(),
                                                  point.nodes.begin() + point.node_count);
  for (BodyGrid<dim>& grid : workspace.grids) {
    std::sort(grid.contact_nodes.begin(), grid.contact_nodes.end());
    grid.contact_nodes.erase(std::unique(grid.contact_nodes.begin(), grid.contact_nodes.end()), grid.contact_nodes.end());
  }
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void exchange_moments(const mesh::Mesh<dim>&, const bodies::Particles<dim>&, BodyGrid<dim>&);                                   \
  template void exchange_corner_sums(BodyGrid<dim>&);                                                                                      \
  template void exchange_water_forces(BodyGrid<dim>&);                                                                                     \
  template void exchange_movers(BodyGrid<dim>&, std::vector<bodies::CellChange>&, bodies::Transit<dim>&);                                  \
  template class BorrowedParticles<dim>;                                                                                                   \
  template void list_contact_nodes(const problem::Model<dim>&, Workspace<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
