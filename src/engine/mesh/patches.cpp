// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/patches.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <tuple>
#include <utility>

namespace berm::mesh {
namespace {

using Groups = std::vector<std::vector<Index>>;

/// True for the triangles around the crossing of two straight lines, where four of them meet: the volume change of the last
/// one follows from those of the others, so they do not lock (Nagtegaal, Parks and Rice 1974), and pairs of them would leave
/// too few constraints.
std::vector<bool> crossed_cells(const Mesh<2>& mesh)
{
  std::vector<bool> crossed(mesh.cell_count(), false);
  for (Index node = 0; node < mesh.node_count(); ++node) {
    const Index first = mesh.first_entry[node], last = mesh.first_entry[node + 1];
    if (last - first != 4) continue;
    // Each neighbour of a node within the mesh lies in two of its cells; on two straight lines each has one opposite.
    std::vector<Index> around;
    for (Index e = first; e < last; ++e)
      for (Index other : mesh.nodes[mesh.entries[e] / 3])
        if (other != node && std::find(around.begin(), around.end(), other) == around.end()) around.push_back(other);
    if (around.size() != 4) continue;
    constexpr Real straight = -1 + 1e-6;  // cosine between the two halves of a line
    const bool lines = std::all_of(around.begin(), around.end(), [&](Index a) {
      const Vec<2> to_a = (mesh.position[a] - mesh.position[node]).normalized();
      return std::any_of(around.begin(), around.end(),
                         [&](Index b) { return (mesh.position[b] - mesh.position[node]).normalized().dot(to_a) < straight; });
    });
    for (Index e = first; lines && e < last; ++e) crossed[mesh.entries[e] / 3] = true;
  }
  return crossed;
}
std::vector<bool> crossed_cells(const Mesh<3>& mesh)
{
  return std::vector<bool>(mesh.cell_count(), false);
}

/// The cells joined in patches.
template <int dim>
class Grouping {
public:
  Grouping(const Mesh<dim>& mesh, Index cells)
      : mesh_(mesh),
        cells_(cells),
        crossed_(crossed_cells(mesh)),
        neighbors_(mesh.cell_count()),
        patch_(mesh.cell_count(), none),
        free_neighbors_(mesh.cell_count()),
        free_(mesh.cell_count(), true)
  {
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) neighbors_[cell] = find_neighbors(cell);
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
      if (!crossed_[cell]) queue_.push({free_neighbors_[cell] = static_cast<Index>(neighbors(cell).size()), cell});
    Groups rest;
    while (!queue_.empty()) {
      const auto [queued_count, cell] = queue_.top();
      queue_.pop();
      if (!free_[cell] || queued_count != free_neighbors_[cell]) continue;  // a cell is queued several times; its present count is valid
      const std::vector<Index> group = grown_from(cell);
      if (2 * static_cast<Index>(group.size()) > cells_)
        add(group);
      else
        rest.push_back(group);
    }
    join_neighbors(rest);
  }

  Groups patches() && { return std::move(patches_); }

private:
  using QueueEntry = std::pair<Index, Index>;                          // free neighbours and cell
  static constexpr Index no_cell = std::numeric_limits<Index>::max();  // behind all cells where they are sorted

  /// Cells of the same region beyond the cell's faces, ascending.
  std::span<const Index> neighbors(Index cell) const
  {
    const auto& list = neighbors_[cell];
    return {list.begin(), std::find(list.begin(), list.end(), no_cell)};
  }

  std::array<Index, dim + 1> find_neighbors(Index cell) const
  {
    std::array<Index, dim + 1> list;
    for (int k = 0; k <= dim; ++k) {
      const Index other = mesh_.neighbor(cell, k);
      list[k] = other != none && !crossed_[other] && mesh_.region[other] == mesh_.region[cell] ? other : no_cell;
    }
    std::sort(list.begin(), list.end());
    return list;
  }

  int shared_corners(Index a, Index b) const
  {
    int shared = 0;
    for (const Index node : mesh_.nodes[a]) shared += std::count(mesh_.nodes[b].begin(), mesh_.nodes[b].end(), node) != 0;
    return shared;
  }

  void take(Index cell)
  {
    free_[cell] = false;
    for (const Index other : neighbors(cell))
      if (free_[other]) queue_.push({--free_neighbors_[other], other});
  }

  std::vector<Index> grown_from(Index first)
  {
    std::vector<Index> group = {first};
    take(first);
    while (static_cast<Index>(group.size()) < cells_) {
      std::tuple<int, Index, Index> best(1, 0, none);  // fewer is better: minus the shared corners, free neighbours, cell
      for (const Index member : group)
        for (const Index other : neighbors(member)) {
          if (!free_[other]) continue;
          int shared = 0;
          for (const Index corner_owner : group) shared += shared_corners(corner_owner, other);
          best = std::min(best, {-shared, free_neighbors_[other], other});
        }
      if (std::get<2>(best) == none) break;
      group.push_back(std::get<2>(best));
      take(group.back());
    }
    return group;
  }

  void add(const std::vector<Index>& group)
  {
    for (const Index cell : group) patch_[cell] = static_cast<Index>(patches_.size());
    patches_.push_back(group);
  }

  /// Groups that did not grow join patches around them, cell by cell; those with none around are patches of their own.
  void join_neighbors(const Groups& rest)
  {
    for (bool joins = true; joins;) {
      joins = false;
      for (const std::vector<Index>& group : rest)
        for (const Index cell : group)
          if (patch_[cell] == none) joins |= join_smallest(cell);
    }
    for (const std::vector<Index>& group : rest)
      if (std::all_of(group.begin(), group.end(), [&](Index cell) { return patch_[cell] == none; }))
        add(group);
      else  // what is left where all patches around are full need not be connected
        for (const Index cell : group)
          if (patch_[cell] == none) add({cell});
  }

  bool join_smallest(Index cell)
  {
    Index smallest = none;
    for (const Index other : neighbors(cell)) {
      const Index patch = patch_[other];
      if (patch != none && (smallest == none || patches_[patch].size() < patches_[smallest].size())) smallest = patch;
    }
    if (smallest == none || patches_[smallest].size() >= max_patch_cells) return false;
    patches_[smallest].push_back(cell);
    patch_[cell] = smallest;
    return true;
  }

  const Mesh<dim>& mesh_;
  Index cells_;
  std::vector<bool> crossed_;
  CellField<std::array<Index, dim + 1>> neighbors_;  ///< then no_cell
  CellField<Index> patch_;                           ///< of each cell, or none
  CellField<Index> free_neighbors_;
  std::vector<bool> free_;
  Groups patches_;
  std::priority_queue<QueueEntry, std::vector<QueueEntry>, std::greater<>> queue_;
};

/// Those that the mesh names.
template <int dim>
Groups named_patches(const Mesh<dim>& mesh)
{
  Groups groups(mesh.cell_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) groups[mesh.patch[cell]].push_back(cell);
  std::erase_if(groups, [](const std::vector<Index>& group) { return group.empty(); });
  return groups;
}

}  // namespace

template <int dim>
Patches make_patches(const Mesh<dim>& mesh, int cells)
{
  Patches patches(mesh.cell_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) patches[cell] = cell;
  const bool named = mesh.patch.size() > 0 && cells == patch_cells<dim>;
  Groups groups = named ? named_patches(mesh) : Grouping<dim>(mesh, cells).patches();
  for (std::vector<Index>& group : groups) {
    std::sort(group.begin(), group.end());
    for (std::size_t k = 0; k < group.size(); ++k) patches[group[k]] = group[(k + 1) % group.size()];
  }
  return patches;
}

template Patches make_patches(const Mesh<2>&, int);
template Patches make_patches(const Mesh<3>&, int);

}  // namespace berm::mesh
