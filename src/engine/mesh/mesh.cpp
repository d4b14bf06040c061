// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/mesh.hpp"

#include "core/chunks.hpp"
#include "mesh/hilbert_curve.hpp"
#include "os/error.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace berm::mesh {
namespace {

// A cell this thin, as a share of its longest edge, has no volume.
constexpr Real flat = 1e-10;

template <int dim>
std::string words(const Vec<dim>& x)
{
  std::string text = fmt::format("({:.6g}", x[0]);
  for (int d = 1; d < dim; ++d) text += fmt::format(", {:.6g}", x[d]);
  return text + ") m";
}

Index index_of(const std::vector<std::string>& names, const std::string& name)
{
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? none : static_cast<Index>(found - names.begin());
}

template <int dim>
void check_numbers(const Mesh<dim>& mesh)
{
  constexpr BigIndex max = std::numeric_limits<Index>::max() / (dim + 1);
  if (mesh.cell_count() == 0) throw RunError("the mesh has no cells");
  if (mesh.cell_count() > max) throw RunError(fmt::format("the mesh has {} cells; at most {} can be numbered", mesh.cell_count(), max));
  if (mesh.region.size() != mesh.cell_count())
    throw RunError(fmt::format("the mesh has {} cells but regions for {}", mesh.cell_count(), mesh.region.size()));
  const auto node_exists = [&](Index i) { return i >= 0 && i < mesh.node_count(); };
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    for (const Index i : mesh.nodes[c]) {
      if (!node_exists(i)) throw RunError(fmt::format("cell {} has node {}, but the mesh has {} nodes", c, i, mesh.node_count()));
      if (!mesh.position[i].allFinite()) throw RunError(fmt::format("node {} of cell {} has a position that is not finite", i, c));
    }
    if (mesh.region[c] < 0 || mesh.region[c] >= static_cast<Index>(mesh.region_names.size()))
      throw RunError(fmt::format("cell {} is in region {}, but the mesh has {} regions", c, mesh.region[c], mesh.region_names.size()));
  }
  if (mesh.boundary_nodes.size() != mesh.boundary_names.size())
    throw RunError(fmt::format("the mesh has {} boundaries but {} names for them", mesh.boundary_nodes.size(), mesh.boundary_names.size()));
  for (std::size_t s = 0; s < mesh.boundary_nodes.size(); ++s)
    for (const Index i : mesh.boundary_nodes[s])
      if (!node_exists(i))
        throw RunError(fmt::format("boundary \"{}\" has node {}, but the mesh has {} nodes", mesh.boundary_names[s], i, mesh.node_count()));
}

// From corner 0 to the others, one in each column.
template <int dim>
Matrix<dim> edges_of(const Mesh<dim>& mesh, Index cell)
{
  const auto& corner = mesh.nodes[cell];
  Matrix<dim> edges;
  for (int k = 0; k < dim; ++k) edges.col(k) = mesh.position[corner[k + 1]] - mesh.position[corner[0]];
  return edges;
}

// dim! times the signed volume.
template <int dim>
Real determinant(const Mesh<dim>& mesh, Index cell)
{
  return edges_of(mesh, cell).determinant();
}

template <int dim>
void orient_cells(Mesh<dim>& mesh)
{
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    auto& corner = mesh.nodes[c];
    if (determinant(mesh, c) < 0) std::swap(corner[dim - 1], corner[dim]);
  }
}

template <int dim>
void number_cells_along_curve(Mesh<dim>& mesh)
{
  Vec<dim> lower = mesh.centroid(0), upper = lower;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    lower = lower.cwiseMin(mesh.centroid(c));
    upper = upper.cwiseMax(mesh.centroid(c));
  }
  constexpr Real last = (1u << curve_bits) - 1;
  const Real extent = (upper - lower).maxCoeff();
  const Real scale = extent > 0 ? last / extent : 0;

  std::vector<std::pair<std::uint64_t, Index>> order(mesh.cell_count());
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const Vec<dim> centroid = mesh.centroid(c);
    std::array<std::uint32_t, dim> point;
    for (int d = 0; d < dim; ++d) point[d] = static_cast<std::uint32_t>(std::clamp((centroid[d] - lower[d]) * scale, 0., last));
    order[c] = {hilbert_index<dim>(point), c};
  }
  std::sort(order.begin(), order.end());

  const auto nodes = mesh.nodes;
  auto region = CellField<Index>::zeros(mesh.cell_count());
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    mesh.nodes[c] = nodes[order[c].second];
    if (const Index here = mesh.region[order[c].second]; here != 0) region[c] = here;  // a mesh of one region needs no memory for it
  }
  mesh.region = std::move(region);
  if (mesh.patch.size() > 0) {
    const auto patch = mesh.patch;
    for (Index c = 0; c < mesh.cell_count(); ++c) mesh.patch[c] = patch[order[c].second];
  }
}

// Numbers nodes by first use. Nodes of no cell are left out.
template <int dim>
void number_nodes(Mesh<dim>& mesh)
{
  NodeField<Index> number(mesh.node_count(), none);
  NodeField<Vec<dim>> position;
  for (auto& corner : mesh.nodes)
    for (Index& i : corner) {
      if (number[i] == none) {
        number[i] = position.size();
        position.push_back(mesh.position[i]);
      }
      i = number[i];
    }
  mesh.position = std::move(position);
  for (auto& list : mesh.boundary_nodes) {
    for (Index& i : list) i = number[i];
    std::erase(list, none);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
}

template <int dim>
void check_volumes(const Mesh<dim>& mesh)
{
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& corner = mesh.nodes[c];
    Real longest = 0;
    for (int k = 0; k < dim; ++k)
      for (int l = k + 1; l <= dim; ++l) longest = std::max(longest, (mesh.position[corner[k]] - mesh.position[corner[l]]).norm());
    if (!(determinant(mesh, c) > flat * std::pow(longest, dim)))
      throw RunError(fmt::format("a cell near {} has no volume: {:.3g} for a longest edge of {:.3g} m", words<dim>(mesh.centroid(c)),
                                 mesh.volume(c), longest));
  }
}

template <int dim>
void collect_entries(Mesh<dim>& mesh)
{
  constexpr int corners = dim + 1;
  mesh.first_entry.assign(mesh.node_count() + 1, 0);
  for (const auto& corner : mesh.nodes)
    for (const Index i : corner) ++mesh.first_entry[i + 1];
  std::partial_sum(mesh.first_entry.begin(), mesh.first_entry.end(), mesh.first_entry.begin());
  auto next = mesh.first_entry;
  mesh.entries.resize(static_cast<std::size_t>(mesh.cell_count()) * corners);
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int k = 0; k < corners; ++k) mesh.entries[next[mesh.nodes[c][k]]++] = corners * c + k;
}

// Nodes are numbered by first use, so their first cells ascend.
template <int dim>
std::vector<Index> find_node_chunks(const Mesh<dim>& mesh)
{
  const auto first_cell = [&](Index node) { return mesh.entries[mesh.first_entry[node]] / (dim + 1); };
  std::vector<Index> bounds;
  Index node = 0;
  for (const Index bound : mesh.cell_chunks) {
    while (node < mesh.node_count() && first_cell(node) < bound) ++node;
    bounds.push_back(node);
  }
  return bounds;
}

/// Calls visit(other) for each other cell that has all nodes of the face of a cell opposite a corner: they are among those of one of its nodes.
template <int dim, class Visit>
void for_each_across(const Mesh<dim>& mesh, Index cell, int corner, const Visit& visit)
{
  const auto& here = mesh.nodes[cell];
  const Index node = here[corner == 0 ? 1 : 0];
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
    const Index other = mesh.entries[e] / (dim + 1);
    const auto& there = mesh.nodes[other];
    int shared = 0;
    for (int k = 0; k <= dim; ++k) shared += k != corner && std::find(there.begin(), there.end(), here[k]) != there.end();
    if (shared == dim && other != cell) visit(other);
  }
}

template <int dim>
void check_faces(const Mesh<dim>& mesh)
{
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const Shape<dim> shape = mesh.shape(c);
    for (int k = 0; k <= dim; ++k) {
      Index others = 0;
      bool overlap = false;
      for_each_across(mesh, c, k, [&](Index other) {
        ++others;
        overlap = overlap || shape.value(k, mesh.centroid(other)) > 0;
      });
      if (others > 1)
        throw RunError(fmt::format("a face near {} belongs to {} cells; a face belongs to two cells at most",
                                   words<dim>(mesh.position[mesh.nodes[c][k == 0 ? 1 : 0]]), others + 1));
      if (overlap)
        throw RunError(
            fmt::format("two cells near {} lie on the same side of the face they share: they overlap", words<dim>(mesh.centroid(c))));
    }
  }
}

}  // namespace

template <int dim>
Index Mesh<dim>::find_region(const std::string& name) const
{
  return index_of(region_names, name);
}

template <int dim>
Index Mesh<dim>::find_boundary(const std::string& name) const
{
  return index_of(boundary_names, name);
}

template <int dim>
Vec<dim> Mesh<dim>::centroid(Index cell) const
{
  Vec<dim> sum = Vec<dim>::Zero();
  for (const Index i : nodes[cell]) sum += position[i];
  return sum / corners;
}

// From lambda = inverse(edges) (x - x_0) for the corners 1 ... dim.
template <int dim>
Shape<dim> Mesh<dim>::shape(Index cell) const
{
  const Matrix<dim> inverse = edges_of(*this, cell).inverse();
  Shape<dim> shape;
  shape.origin = position[nodes[cell][0]];
  for (int k = 0; k < dim; ++k)
    for (int d = 0; d < dim; ++d) shape.gradients[k][d] = inverse(k, d);
  return shape;
}

template <int dim>
Real Mesh<dim>::section(Index cell) const
{
  return determinant(*this, cell) / (dim == 2 ? 2 : 6);
}

template <int dim>
Real Mesh<dim>::size(Index cell) const
{
  return dim == 2 ? std::sqrt(2 * section(cell)) : std::cbrt(6 * section(cell));
}

template <int dim>
Real Mesh<dim>::volume(Index cell) const
{
  return metric == Metric::axisymmetric ? section(cell) * centroid(cell)[0] : section(cell);
}

template <int dim>
Real Mesh<dim>::height(Index cell) const
{
  return 1 / std::sqrt(shape(cell).steepest_square());
}

template <int dim>
Index Mesh<dim>::neighbor(Index cell, int corner) const
{
  Index found = none;
  for_each_across(*this, cell, corner, [&](Index other) { found = other; });
  return found;
}

template <int dim>
void Mesh<dim>::complete()
{
  check_numbers(*this);
  orient_cells(*this);
  number_cells_along_curve(*this);
  number_nodes(*this);
  check_volumes(*this);
  collect_entries(*this);
  check_faces(*this);
  cell_chunks = chunk_bounds(cell_count());
  node_chunks = find_node_chunks(*this);
  lower = upper = position[0];
  for (const Vec<dim>& x : position) {
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
}

template struct Mesh<2>;
template struct Mesh<3>;

}  // namespace berm::mesh
