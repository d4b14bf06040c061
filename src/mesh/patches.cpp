// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/patches.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <span>

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

/// For each group those that share a face with it and lie in its region, ascending: neighbors of g are list[first[g]] ... list[first[g + 1] - 1].
struct Neighbors {
  std::vector<Index> first = {0}, list;

  template <int dim>
  Neighbors(const Mesh<dim>& mesh, const Groups& groups)
  {
    std::vector<Index> group_of(mesh.cell_count(), none);  // none: a cell that is joined with no other
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (Index cell : groups[g]) group_of[cell] = static_cast<Index>(g);
    first.reserve(groups.size() + 1);
    list.reserve(groups.size() * Mesh<dim>::corners);
    std::vector<Index> found;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      found.clear();
      for (Index cell : groups[g])
        for (int k = 0; k <= dim; ++k) {
          const Index other = mesh.neighbor(cell, k);
          if (other != none && group_of[other] != none && group_of[other] != static_cast<Index>(g) &&
              mesh.region[other] == mesh.region[cell])
            found.push_back(group_of[other]);
        }
      std::sort(found.begin(), found.end());
      list.insert(list.end(), found.begin(), std::unique(found.begin(), found.end()));
      first.push_back(static_cast<Index>(list.size()));
    }
  }
  std::span<const Index> of(Index g) const { return {list.data() + first[g], list.data() + first[g + 1]}; }
};

template <int dim>
Groups joined(const Mesh<dim>& mesh, const Groups& groups)
{
  const Index count = static_cast<Index>(groups.size());
  const Neighbors neighbors(mesh, groups);

  // Groups with few free neighbours are joined first, so that few stay single. A group is queued several times; only the
  // entry with its present count is valid.
  std::vector<Index> free_neighbors(count), partner(count, none);
  std::vector<bool> free(count, true);
  using QueueEntry = std::pair<Index, Index>;  // free neighbours and group
  std::priority_queue<QueueEntry, std::vector<QueueEntry>, std::greater<>> queue;
  for (Index g = 0; g < count; ++g) queue.push({free_neighbors[g] = static_cast<Index>(neighbors.of(g).size()), g});
  const auto settle = [&](Index g) {
    free[g] = false;
    for (Index other : neighbors.of(g))
      if (free[other]) queue.push({--free_neighbors[other], other});
  };
  std::vector<Index> alone;
  while (!queue.empty()) {
    const auto [queued_count, g] = queue.top();
    queue.pop();
    if (!free[g] || queued_count != free_neighbors[g]) continue;
    Index best = none;
    for (Index other : neighbors.of(g))
      if (free[other] && (best == none || free_neighbors[other] < free_neighbors[best])) best = other;
    settle(g);
    if (best == none) {
      alone.push_back(g);
      continue;
    }
    settle(best);
    partner[g] = best;
    partner[best] = g;
  }

  Groups result;
  std::vector<Index> index(count, none);
  for (Index g = 0; g < count; ++g)
    if (partner[g] > g) {
      index[g] = index[partner[g]] = static_cast<Index>(result.size());
      result.push_back(groups[g]);
      result.back().insert(result.back().end(), groups[partner[g]].begin(), groups[partner[g]].end());
    }
  for (Index g : alone) {
    Index smallest = none;
    for (Index other : neighbors.of(g))
      if (index[other] != none && (smallest == none || result[index[other]].size() < result[smallest].size())) smallest = index[other];
    if (smallest == none || result[smallest].size() + groups[g].size() > max_patch_cells) {
      result.push_back(groups[g]);
    } else {
      result[smallest].insert(result[smallest].end(), groups[g].begin(), groups[g].end());
    }
  }
  return result;
}

}  // namespace

template <int dim>
Patches make_patches(const Mesh<dim>& mesh, int rounds)
{
  Groups groups;
  const std::vector<bool> crossed = crossed_cells(mesh);
  Patches patches(mesh.cell_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    patches[cell] = cell;
    if (!crossed[cell]) groups.push_back({cell});
  }
  for (int round = 0; round < rounds; ++round) groups = joined(mesh, groups);
  for (std::vector<Index>& group : groups) {
    std::sort(group.begin(), group.end());
    for (std::size_t k = 0; k < group.size(); ++k) patches[group[k]] = group[(k + 1) % group.size()];
  }
  return patches;
}

template Patches make_patches(const Mesh<2>&, int);
template Patches make_patches(const Mesh<3>&, int);

}  // namespace berm::mesh
