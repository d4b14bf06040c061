// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/ranks/run
#include "mpm/halo.hpp"

namespace berm::mpm {
namespace {

void make_ascending(std::vector<Index>& list)
{
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

template <int dim>
Halo make_halo(const mesh::Mesh<dim>& mesh, const mesh::Patches& patches)
{
  Halo halo;
  Ranks& ranks = Ranks::of_run();
  if (!ranks.divided()) return halo;
  halo.is_complete = NodeField<std::uint8_t>::zeros(mesh.node_count());
  const auto surround = [&](Index cell) {
    for (const Index node : mesh.nodes[cell]) {
      if (halo.is_complete[node] != 0) continue;
      halo.is_complete[node] = 1;
      for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e)
        if (const Index other = mesh.entries[e] / (dim + 1); !ranks.owns_cell(other)) halo.outer.push_back(other);
    }
  };
  for (Index cell = ranks.first_cell()[ranks.rank()]; cell < ranks.first_cell()[ranks.rank() + 1]; ++cell) {
    surround(cell);
    mesh::for_each_in_patch(patches, cell, [&](Index member) {
      if (!ranks.owns_cell(member)) halo.partners.push_back(member);
    });
  }
  make_ascending(halo.partners);
  for (const Index cell : halo.partners) surround(cell);
  make_ascending(halo.outer);

  std::vector<std::pair<Index, Index>> needed, all;  // the rank that needs a cell, and the cell
  for (const Index cell : halo.outer) needed.emplace_back(ranks.rank(), cell);
  ranks.gather(needed, all);
  std::vector<Halo::Side> side_of(static_cast<std::size_t>(ranks.count()));
  std::vector<char> needs(static_cast<std::size_t>(ranks.count()), 0);
  for (const auto& [rank, cell] : all)
    if (ranks.owns_cell(cell)) side_of[rank].inner.push_back(cell);
  for (const Index cell : halo.outer) needs[ranks.owner_of_cell(cell)] = 1;
  for (int other = 0; other < ranks.count(); ++other) {
    if (side_of[other].inner.empty() && needs[other] == 0) continue;
    halo.sides.push_back(std::move(side_of[other]));
    halo.letters.push_back({other, {}, {}});
  }
  return halo;
}

template Halo make_halo(const mesh::Mesh<2>&, const mesh::Patches&);
template Halo make_halo(const mesh::Mesh<3>&, const mesh::Patches&);

}  // namespace berm::mpm
