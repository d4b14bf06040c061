// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mesh/gmsh_of_others_test.cpp
#include "mesh/unconnected_faces.hpp"

#include "os/error.hpp"
#include "os/text_of_list.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <unsupported/Eigen/BVH>

namespace berm::mesh {
namespace {

/// A point behind a face that belongs to one cell alone.
template <int dim>
struct PointBehindFace {
  Vec<dim> on_face, point;  ///< m
  Index cell;
};

/// Behind the middle of each such face, and near each of its corners: parts may lie at each other along a part of their faces.
template <int dim>
std::vector<PointBehindFace<dim>> points_behind_faces(const Mesh<dim>& mesh)
{
  constexpr Real depth = 0.01;        // of the height of the cell, or of the shortest side of the face
  constexpr Real near_corner = 0.15;  // of the way to the middle
  std::vector<PointBehindFace<dim>> points;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int k = 0; k <= dim; ++k) {
      if (mesh.neighbor(c, k) != none) continue;
      const auto corner = [&](int n) -> const Vec<dim>& { return mesh.position[mesh.nodes[c][(k + 1 + n) % (dim + 1)]]; };
      const Vec<dim> middle = (mesh.centroid(c) * (dim + 1) - mesh.position[mesh.nodes[c][k]]) / dim;
      const Vec<dim> inwards = mesh.shape(c).gradient(k);  // 1/m, of a length that is one over the height
      Real length = 1 / inwards.norm();
      for (int n = 0; n < dim; ++n) length = std::min(length, (corner(n) - corner((n + 1) % dim)).norm());
      const Vec<dim> away = -depth * length * inwards.normalized();
      points.push_back({middle, middle + away, c});
      for (int n = 0; n < dim; ++n) {
        const Vec<dim> x = corner(n) + near_corner * (middle - corner(n));
        points.push_back({x, x + away, c});
      }
    }
  return points;
}

}  // namespace

template <int dim>
void refuse_unconnected_faces(const Mesh<dim>& mesh, const std::string& file)
{
  using Box = Eigen::AlignedBox<Real, dim>;
  const std::vector<PointBehindFace<dim>> points = points_behind_faces(mesh);
  std::vector<char> at_border(static_cast<std::size_t>(mesh.node_count()), 0);
  for (const PointBehindFace<dim>& behind : points)
    for (const Index i : mesh.nodes[behind.cell]) at_border[static_cast<std::size_t>(i)] = 1;
  std::vector<Index> cells;
  std::vector<Box> boxes;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    Box box;
    bool counts = false;
    for (const Index i : mesh.nodes[c]) box.extend(mesh.position[i]), counts = counts || at_border[static_cast<std::size_t>(i)] != 0;
    if (counts) cells.push_back(c), boxes.push_back(box);
  }
  const Eigen::KdBVH<Real, dim, Index> tree(cells.begin(), cells.end(), boxes.begin(), boxes.end());
  struct Search {
    const Mesh<dim>& mesh;
    const Vec<dim>& x;
    bool found = false;

    bool intersectVolume(const Box& box) const { return box.contains(x); }
    bool intersectObject(Index cell)
    {
      const Shape<dim> shape = mesh.shape(cell);
      found = true;
      for (int k = 0; k <= dim; ++k) found = found && shape.value(k, x) > 0;
      return found;
    }
  };
  for (const PointBehindFace<dim>& behind : points) {
    Search search{mesh, behind.point};
    Eigen::BVIntersect(tree, search);
    if (search.found)
      throw InputError(fmt::format(
          "{}: parts of the mesh touch at ({}) m and share no nodes there: they are not connected; let them share "
          "these (Gmsh: Coherence or BooleanFragments before meshing), or, where there is a gap between nodes that should be one, join "
          "them by "
          "mesh.merge_tolerance",
          file, text_of_list(behind.on_face, ", ", "{:.6g}")));
  }
}

template void refuse_unconnected_faces(const Mesh<2>&, const std::string&);
template void refuse_unconnected_faces(const Mesh<3>&, const std::string&);

}  // namespace berm::mesh
