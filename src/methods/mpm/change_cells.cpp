// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/move_test.cpp
#include "mpm/change_cells.hpp"

#include "core/for_each_run.hpp"
#include "mpm/diagnose.hpp"
#include "mpm/exchange.hpp"
#include "mpm/moments.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::mpm {
namespace {

/// `left` is a particle of this rank that has left the mesh, or null where it is one of another.
template <int dim>
[[noreturn]] void refuse(const problem::Model<dim>& model, const problem::State<dim>& state, const bodies::CellChange* left, Index body)
{
  std::string words;
  if (left != nullptr) {
    const bodies::Particle<dim> p = state.particles[body].read_at(left->from, left->index);
    words = fmt::format("particle {} of body \"{}\" left the mesh at ({}) m at t = {:.6g} s (step {}), moving at ({}) m/s; {}", p.id,
                        model.bodies[body].name, text_of_list(p.x, ", ", "{:.9g}"), state.time, state.step,
                        text_of_list(p.v, ", ", "{:.3g}"), advice_for_leaving(model, state, body, p.x, left->from));
  }
  throw RunError(Ranks::of_run().text_of_largest(left != nullptr ? 1 : 0, words));
}

/// Each of the cells may be there several times, and without particles.
template <int dim>
void sum_changed_moments(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, std::vector<Index>& cells,
                         BodyGrid<dim>& grid)
{
  const Timer timer("change cells: moments");
  std::sort(cells.begin(), cells.end());
  for_each_run(
      static_cast<Index>(cells.size()), [&](Index a, Index b) { return cells[a] == cells[b]; },
      [&](Index first, Index) {
        if (particles.count_in(cells[first]) > 0) sum_moments_of(mesh, particles, cells[first], grid);
      });
}

}  // namespace

template <int dim>
void change_cells(const problem::Model<dim>& model, problem::State<dim>& state, Workspace<dim>& workspace, Index body)
{
  const Timer timer("change cells");
  bodies::Particles<dim>& particles = state.particles[body];
  BodyGrid<dim>& grid = workspace.grids[body];
  std::vector<bodies::CellChange>& cell_changes = workspace.cell_changes.front();
  for (std::size_t t = 1; t < workspace.cell_changes.size(); ++t)
    cell_changes.insert(cell_changes.end(), workspace.cell_changes[t].begin(), workspace.cell_changes[t].end());
  if (cell_changes.empty() && !grid.halo.divided()) return;
  // At the nodes of inactive cells nothing moves: a particle that comes so far was put there by round-off, and keeps its cell.
  if (particles.some_inactive())
    std::erase_if(cell_changes, [&](const auto& change) { return change.to != none && particles.is_inactive(change.to); });
  // Threads share a large body's cells in several rounds, so their lists laid end to end are not in the order of the cells yet.
  std::sort(cell_changes.begin(), cell_changes.end(), [](const bodies::CellChange& a, const bodies::CellChange& b) {
    return a.from != b.from ? a.from < b.from : a.index < b.index;
  });

  const auto left = std::find_if(cell_changes.begin(), cell_changes.end(), [](const auto& change) { return change.to == none; });
  const bool has_left = left != cell_changes.end();
  if (Ranks::of_run().any(has_left)) refuse(model, state, has_left ? &*left : nullptr, body);
  particles.take_out(cell_changes, workspace.transit);
  workspace.changed_cells.clear();
  for (const bodies::CellChange& change : cell_changes) {
    workspace.changed_cells.push_back(change.from);
    if (particles.count_in(change.from) == 0) grid.leave(change.from);
  }
  exchange_movers(grid, cell_changes, workspace.transit);
  particles.put_in(cell_changes, workspace.transit);
  for (std::size_t m = 0; m < cell_changes.size(); ++m) {
    workspace.changed_cells.push_back(cell_changes[m].to);
    if (workspace.transit.index[m] == 0) grid.enter(model.mesh, cell_changes[m].to);
  }
  sum_changed_moments(model.mesh, particles, workspace.changed_cells, grid);
  if (particles.sort_occupied()) find_nodes(model.mesh, particles, grid);
}

template void change_cells(const problem::Model<2>&, problem::State<2>&, Workspace<2>&, Index);
template void change_cells(const problem::Model<3>&, problem::State<3>&, Workspace<3>&, Index);

}  // namespace berm::mpm
