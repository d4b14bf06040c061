// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/patches.hpp"

#include <algorithm>
#include <set>

namespace berm {
namespace {

using Groups = std::vector<std::vector<Index>>;

/// The groups that share a face with group g and lie in its region.
template <int dim>
std::set<Index> neighbors_of(const Mesh<dim>& mesh, const Groups& groups, const std::vector<Index>& group_of, Index g)
{
  std::set<Index> found;
  for (Index cell : groups[g])
    for (Index other : mesh.neighbor[cell])
      if (other != none && group_of[other] != g && mesh.region[other] == mesh.region[cell]) found.insert(group_of[other]);
  return found;
}

template <int dim>
Groups joined(const Mesh<dim>& mesh, const Groups& groups)
{
  const Index count = static_cast<Index>(groups.size());
  std::vector<Index> group_of(mesh.cell_count());
  for (Index g = 0; g < count; ++g)
    for (Index cell : groups[g]) group_of[cell] = g;
  std::vector<std::set<Index>> neighbors;
  for (Index g = 0; g < count; ++g) neighbors.push_back(neighbors_of(mesh, groups, group_of, g));

  // Those with few free neighbours choose first, so that few are left alone.
  std::vector<Index> free_neighbors(count), partner(count, none);
  std::set<std::pair<Index, Index>> waiting;
  for (Index g = 0; g < count; ++g) waiting.insert({free_neighbors[g] = static_cast<Index>(neighbors[g].size()), g});
  const auto settle = [&](Index g) {
    waiting.erase({free_neighbors[g], g});
    for (Index other : neighbors[g])
      if (waiting.erase({free_neighbors[other], other}) == 1) waiting.insert({--free_neighbors[other], other});
  };
  std::vector<Index> alone;
  while (!waiting.empty()) {
    const Index g = waiting.begin()->second;
    Index best = none;
    for (Index other : neighbors[g])
      if (waiting.contains({free_neighbors[other], other}) && (best == none || free_neighbors[other] < free_neighbors[best])) best = other;
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
  std::vector<Index> place(count, none);
  for (Index g = 0; g < count; ++g)
    if (partner[g] > g) {
      place[g] = place[partner[g]] = static_cast<Index>(result.size());
      result.push_back(groups[g]);
      result.back().insert(result.back().end(), groups[partner[g]].begin(), groups[partner[g]].end());
    }
  for (Index g : alone) {
    Index smallest = none;
    for (Index other : neighbors[g])
      if (place[other] != none && (smallest == none || result[place[other]].size() < result[smallest].size())) smallest = place[other];
    if (smallest == none || result[smallest].size() + groups[g].size() > most_patch_cells) {
      result.push_back(groups[g]);
    } else {
      result[smallest].insert(result[smallest].end(), groups[g].begin(), groups[g].end());
    }
  }
  return result;
}

}  // namespace

template <int dim>
CellField<Patch> make_patches(const Mesh<dim>& mesh, int rounds)
{
  Groups groups;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) groups.push_back({cell});
  for (int round = 0; round < rounds; ++round) groups = joined(mesh, groups);
  CellField<Patch> patches(mesh.cell_count());
  for (std::vector<Index>& group : groups) {
    std::sort(group.begin(), group.end());
    Patch patch;
    patch.fill(none);
    std::copy(group.begin(), group.end(), patch.begin());
    for (Index cell : group) patches[cell] = patch;
  }
  return patches;
}

template CellField<Patch> make_patches(const Mesh<2>&, int);
template CellField<Patch> make_patches(const Mesh<3>&, int);

}  // namespace berm
