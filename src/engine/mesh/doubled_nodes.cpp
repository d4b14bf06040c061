// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mesh/gmsh_of_others_test.cpp
#include "mesh/doubled_nodes.hpp"

#include "os/error.hpp"
#include "os/text_of_list.hpp"

#include <fmt/format.h>
#include <unordered_map>

namespace berm::mesh {
namespace {

constexpr Real coincident = 1e-3;  // of the shortest edge

template <int dim>
Real shortest_edge(const Mesh<dim>& mesh)
{
  Real shortest = infinity;
  for (const auto& corner : mesh.nodes)
    for (int a = 0; a < dim; ++a)
      for (int b = a + 1; b <= dim; ++b)
        if (const Real length = (mesh.position[corner[a]] - mesh.position[corner[b]]).norm(); length > 0)
          shortest = std::min(shortest, length);
  return shortest;
}

/// Whether coordinates have the digits for nodes that far apart (m): else nothing is found.
template <int dim>
bool resolves(const Mesh<dim>& mesh, Real reach)
{
  constexpr Real most_boxes = 1e15;
  Real largest = 0;
  for (const auto& corner : mesh.nodes)
    for (const Index i : corner) largest = std::max(largest, mesh.position[i].cwiseAbs().maxCoeff());
  return reach > 0 && std::isfinite(reach) && largest < most_boxes * reach;
}

/// Points by the box of a grid that they lie in.
template <int dim>
class Boxes {
public:
  Boxes(const NodeField<Vec<dim>>& position, Real reach) : position_(position), reach_(reach) {}

  /// A point that was added, no farther than `reach` from a node; else the node is added, and none returned.
  Index find_or_add(Index node)
  {
    constexpr Real boxes_to_reach = 4;  // most points are farther than that from the sides of their box
    const Vec<dim>& x = position_[node];
    const Real size = boxes_to_reach * reach_;
    Index found = none;
    std::array<std::int64_t, dim> from, to, box;
    for (int d = 0; d < dim; ++d) from[d] = box_index(x[d] - reach_, size), to[d] = box_index(x[d] + reach_, size);
    box = from;
    for (bool more = true; more && found == none;) {
      const auto [begin, end] = nodes_.equal_range(key(box));
      for (auto other = begin; other != end; ++other)
        if ((position_[other->second] - x).norm() <= reach_ && (found == none || other->second < found)) found = other->second;
      more = false;
      for (int d = 0; d < dim && !more; ++d) {
        more = box[d] < to[d];
        box[d] = more ? box[d] + 1 : from[d];
      }
    }
    if (found != none) return found;
    for (int d = 0; d < dim; ++d) box[d] = box_index(x[d], size);
    nodes_.emplace(key(box), node);
    return none;
  }

private:
  static std::int64_t box_index(Real x, Real size) { return static_cast<std::int64_t>(std::floor(x / size)); }
  static std::uint64_t key(const std::array<std::int64_t, dim>& box)
  {
    std::uint64_t key = 0;
    for (const std::int64_t k : box) key = (key ^ static_cast<std::uint64_t>(k)) * 0x9E3779B97F4A7C15u;
    return key;
  }

  const NodeField<Vec<dim>>& position_;
  Real reach_;
  std::unordered_multimap<std::uint64_t, Index> nodes_;
};

template <int dim>
std::vector<char> used_by_cells(const Mesh<dim>& mesh)
{
  std::vector<char> used(static_cast<std::size_t>(mesh.node_count()), 0);
  for (const auto& corner : mesh.nodes)
    for (const Index i : corner) used[static_cast<std::size_t>(i)] = 1;
  return used;
}

template <int dim>
Index join(Mesh<dim>& mesh, Real tolerance, const std::string& file)
{
  Boxes<dim> boxes(mesh.position, tolerance);
  NodeField<Index> becomes(mesh.node_count(), none);
  const std::vector<char> used = used_by_cells(mesh);
  Index joined = 0;
  for (Index i = 0; i < mesh.node_count(); ++i) {
    if (!used[static_cast<std::size_t>(i)]) continue;
    const Index same = boxes.find_or_add(i);
    becomes[i] = same == none ? i : same;
    joined += same != none;
  }
  for (auto& corner : mesh.nodes) {
    for (Index& i : corner) i = becomes[i];
    for (int a = 0; a < dim; ++a)
      for (int b = a + 1; b <= dim; ++b)
        if (corner[a] == corner[b])
          throw InputError(fmt::format("{}: mesh.merge_tolerance = {:.3g} m is as long as the edge of a cell at ({}) m: take less", file,
                                       tolerance, text_of_list(mesh.position[corner[a]], ", ", "{:.6g}")));
  }
  for (auto& list : mesh.boundary_nodes)
    for (Index& i : list)
      if (becomes[i] != none) i = becomes[i];
  return joined;
}

}  // namespace

template <int dim>
void join_doubled_nodes(Mesh<dim>& mesh, const std::optional<Real>& tolerance, const std::string& file)
{
  if (tolerance && resolves(mesh, *tolerance))
    if (const Index joined = join(mesh, *tolerance, file); joined > 0)
      mesh.remarks.push_back(fmt::format("has {} nodes within mesh.merge_tolerance of another: they are one with it", joined));
  const Real shortest = shortest_edge(mesh), reach = coincident * shortest;
  if (!resolves(mesh, reach)) return;  // cells without a size are refused where they are looked at
  Boxes<dim> boxes(mesh.position, reach);
  const std::vector<char> used = used_by_cells(mesh);
  for (Index i = 0; i < mesh.node_count(); ++i) {
    if (!used[static_cast<std::size_t>(i)] || boxes.find_or_add(i) == none) continue;
    throw InputError(fmt::format(
        "{}: two nodes lie at ({}) m: parts of the mesh that share no nodes are not connected; let them share these (Gmsh: "
        "Coherence or BooleanFragments before meshing, Coherence Mesh after), or join them by mesh.merge_tolerance = \"{:.1g} m\"",
        file, text_of_list(mesh.position[i], ", ", "{:.6g}"), shortest / 10));
  }
}

template void join_doubled_nodes(Mesh<2>&, const std::optional<Real>&, const std::string&);
template void join_doubled_nodes(Mesh<3>&, const std::optional<Real>&, const std::string&);

}  // namespace berm::mesh
