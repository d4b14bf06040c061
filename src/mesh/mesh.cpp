// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/mesh.hpp"

#include "core/error.hpp"
#include "mesh/curve.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace berm {
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

Index place_of(const std::vector<std::string>& names, const std::string& name)
{
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? none : static_cast<Index>(found - names.begin());
}

template <int dim>
void check_numbers(const Mesh<dim>& mesh)
{
  constexpr BigIndex most = std::numeric_limits<Index>::max() / (dim + 1);
  if (mesh.cell_count() == 0) throw RunError("the mesh has no cells");
  if (mesh.cell_count() > most) throw RunError(fmt::format("the mesh has {} cells; at most {} can be numbered", mesh.cell_count(), most));
  if (mesh.region.size() != mesh.cell_count())
    throw RunError(fmt::format("the mesh has {} cells but regions for {}", mesh.cell_count(), mesh.region.size()));
  const auto node_exists = [&](Index i) { return i >= 0 && i < mesh.node_count(); };
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    for (const Index i : mesh.nodes[c]) {
      if (!node_exists(i)) throw RunError(fmt::format("cell {} has node {}, but the mesh has {} nodes", c, i, mesh.node_count()));
      if (!mesh.position[i].allFinite()) throw RunError(fmt::format("node {} of cell {} is nowhere: its position is not finite", i, c));
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

// dim! times the signed volume.
template <int dim>
Real determinant(const Mesh<dim>& mesh, Index cell)
{
  const auto& corner = mesh.nodes[cell];
  Matrix<dim> edges;
  for (int k = 0; k < dim; ++k) edges.col(k) = mesh.position[corner[k + 1]] - mesh.position[corner[0]];
  return edges.determinant();
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
    order[c] = {hilbert_place<dim>(point), c};
  }
  std::sort(order.begin(), order.end());

  const auto nodes = mesh.nodes;
  const auto region = mesh.region;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    mesh.nodes[c] = nodes[order[c].second];
    mesh.region[c] = region[order[c].second];
  }
}

// By first use. Nodes of no cell are left out.
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

// From lambda = inverse(edges) (x - x_0) for the corners 1 ... dim, and N_0 = 1 - sum of the others. height_k = 1 / |grad N_k|.
template <int dim>
void derive_shapes(Mesh<dim>& mesh)
{
  mesh.shape.assign(mesh.cell_count());
  mesh.volume.assign(mesh.cell_count());
  mesh.height.assign(mesh.cell_count());
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& corner = mesh.nodes[c];
    const Vec<dim> origin = mesh.position[corner[0]];
    Matrix<dim> edges;
    for (int k = 0; k < dim; ++k) edges.col(k) = mesh.position[corner[k + 1]] - origin;
    Real longest = 0;
    for (int k = 0; k < dim; ++k)
      for (int l = k + 1; l <= dim; ++l) longest = std::max(longest, (mesh.position[corner[k]] - mesh.position[corner[l]]).norm());
    const Real det = edges.determinant();
    if (!(det > flat * std::pow(longest, dim)))
      throw RunError(fmt::format("a cell near {} has no volume: {:.3g} for a longest edge of {:.3g} m", words<dim>(mesh.centroid(c)),
                                 det / (dim == 2 ? 2 : 6), longest));
    mesh.volume[c] = det / (dim == 2 ? 2 : 6);

    const Matrix<dim> inverse = edges.inverse();
    Shape<dim>& shape = mesh.shape[c];
    for (int d = 0; d < dim; ++d) {
      shape.b[d][0] = 0;
      for (int k = 0; k < dim; ++k) {
        shape.b[d][k + 1] = inverse(k, d);
        shape.b[d][0] -= inverse(k, d);
      }
    }
    Real steepest = 0;
    for (int k = 0; k <= dim; ++k) {
      shape.a[k] = (k == 0 ? 1 : 0) - shape.gradient(k).dot(origin);
      steepest = std::max(steepest, shape.gradient(k).norm());
    }
    mesh.height[c] = 1 / steepest;
  }
}

template <int dim>
void find_neighbors(Mesh<dim>& mesh)
{
  struct Face {
    std::array<Index, dim> nodes;  // ascending
    CornerEntry opposite;
  };
  constexpr int corners = dim + 1;
  std::vector<Face> faces;
  faces.reserve(static_cast<std::size_t>(mesh.cell_count()) * corners);
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int k = 0; k < corners; ++k) {
      Face face;
      for (int l = 0, f = 0; l < corners; ++l)
        if (l != k) face.nodes[f++] = mesh.nodes[c][l];
      std::sort(face.nodes.begin(), face.nodes.end());
      face.opposite = corners * c + k;
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return a.nodes != b.nodes ? a.nodes < b.nodes : a.opposite < b.opposite; });

  typename Mesh<dim>::Corners alone;
  alone.fill(none);
  mesh.neighbor.assign(mesh.cell_count(), alone);
  for (std::size_t first = 0, end = 0; first < faces.size(); first = end) {
    while (end < faces.size() && faces[end].nodes == faces[first].nodes) ++end;
    if (end - first == 1) continue;
    const Index c = faces[first].opposite / corners, other = faces[first + 1].opposite / corners;
    const int k = faces[first].opposite % corners, l = faces[first + 1].opposite % corners;
    if (end - first > 2)
      throw RunError(fmt::format("a face near {} belongs to {} cells; cells may share a face only two by two",
                                 words<dim>(mesh.position[faces[first].nodes[0]]), end - first));
    if (mesh.shape[c].value(k, mesh.position[mesh.nodes[other][l]]) > 0)
      throw RunError(
          fmt::format("two cells near {} lie on the same side of the face they share: they overlap", words<dim>(mesh.centroid(c))));
    mesh.neighbor[c][k] = other;
    mesh.neighbor[other][l] = c;
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
  auto place = mesh.first_entry;
  mesh.entries.resize(static_cast<std::size_t>(mesh.cell_count()) * corners);
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int k = 0; k < corners; ++k) mesh.entries[place[mesh.nodes[c][k]]++] = corners * c + k;
}

}  // namespace

template <int dim>
Index Mesh<dim>::find_region(const std::string& name) const
{
  return place_of(region_names, name);
}

template <int dim>
Index Mesh<dim>::find_boundary(const std::string& name) const
{
  return place_of(boundary_names, name);
}

template <int dim>
Vec<dim> Mesh<dim>::centroid(Index cell) const
{
  Vec<dim> sum = Vec<dim>::Zero();
  for (const Index i : nodes[cell]) sum += position[i];
  return sum / corners;
}

template <int dim>
void Mesh<dim>::complete()
{
  check_numbers(*this);
  orient_cells(*this);
  number_cells_along_curve(*this);
  number_nodes(*this);
  derive_shapes(*this);
  find_neighbors(*this);
  collect_entries(*this);
  lower = upper = position[0];
  for (const Vec<dim>& x : position) {
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
}

template struct Mesh<2>;
template struct Mesh<3>;

}  // namespace berm
