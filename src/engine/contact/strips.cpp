// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/contact/strips_test.cpp
#include "contact/strips.hpp"

namespace berm::contact {
namespace {

constexpr Index cells_of_strip = 32, nodes_of_strip = 16;

/// The colour of each strip of near_cells, and the number of colours.
template <int dim>
Index color_strips(const mesh::Mesh<dim>& mesh, const ContactPoints<dim>& found, std::vector<Index>& color)
{
  const auto strip_of = [&](Index cell) { return found.near_index[cell] == 0 ? none : (found.near_index[cell] - 1) / cells_of_strip; };
  Index colors = 0;
  std::vector<char> taken;
  for (Index s = 0; s < static_cast<Index>(color.size()); ++s) {
    taken.assign(static_cast<std::size_t>(colors) + 1, 0);
    const Index end = std::min((s + 1) * cells_of_strip, static_cast<Index>(found.near_cells.size()));
    for (Index k = s * cells_of_strip; k < end; ++k)
      for (Index node : mesh.nodes[found.near_cells[k]])
        for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e)
          if (const Index other = strip_of(mesh.entries[e] / (dim + 1)); other != none && other < s) taken[color[other]] = 1;
    color[s] = static_cast<Index>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
    colors = std::max(colors, color[s] + 1);
  }
  return colors;
}

}  // namespace

template <int dim>
void order_by_strips(const mesh::Mesh<dim>& mesh, ContactPoints<dim>& found)
{
  const Index cells = static_cast<Index>(found.near_cells.size());
  std::vector<Index> color(static_cast<std::size_t>((cells + cells_of_strip - 1) / cells_of_strip));
  const Index colors = color_strips(mesh, found, color);
  const std::vector<Index> ascending = found.near_cells;
  found.near_cells.clear();
  found.color_begin.assign(1, 0);
  found.first_near_cell.assign(1, 0);
  for (Index c = 0; c < colors; ++c) {
    for (Index s = 0; s < static_cast<Index>(color.size()); ++s) {
      if (color[s] != c) continue;
      const auto begin = ascending.begin() + s * cells_of_strip;
      found.near_cells.insert(found.near_cells.end(), begin, begin + std::min(cells_of_strip, cells - s * cells_of_strip));
      found.first_near_cell.push_back(static_cast<Index>(found.near_cells.size()));
    }
    found.color_begin.push_back(static_cast<Index>(found.first_near_cell.size()) - 1);
  }
}

template <int dim>
void reserve(ContactPoints<dim>& found, Index points)
{
  const std::size_t strips = std::max<std::size_t>(static_cast<std::size_t>(points / nodes_of_strip) + 2, found.first_near_cell.size());
  found.list.reserve(static_cast<std::size_t>(points));
  found.closed.reserve(static_cast<std::size_t>(points));
  found.strip_begin.reserve(strips);
  found.sweep_sums.reserve(strips);
}

template <int dim>
void set_strips_of_nodes(ContactPoints<dim>& found)
{
  const Index points = static_cast<Index>(found.list.size());
  found.strip_begin.assign(1, 0);
  while (found.strip_begin.back() < points) found.strip_begin.push_back(std::min(points, found.strip_begin.back() + nodes_of_strip));
  found.color_begin = {0, static_cast<Index>(found.strip_begin.size()) - 1};
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void order_by_strips(const mesh::Mesh<dim>&, ContactPoints<dim>&);                                                              \
  template void reserve(ContactPoints<dim>&, Index);                                                                                       \
  template void set_strips_of_nodes(ContactPoints<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::contact
