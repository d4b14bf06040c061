// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/space_problem_test.cpp
#include "fem/space_problem.hpp"

#include <algorithm>
#include <map>

namespace berm::fem {
namespace {

/// Corners of the face opposite each corner of a tetrahedron.
constexpr int face_corners[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};

int edge_between(int a, int b)
{
  int e = 0;
  for (const auto [j, k] : element_edges<3>) {
    if ((j == a && k == b) || (j == b && k == a)) return e;
    ++e;
  }
  return none;
}

class TetrahedraMaker {
public:
  TetrahedraMaker(const mesh::Mesh<3>& mesh, const settings::Case& c)
      : number_of_corner(mesh.node_count(), none),
        mesh_(mesh),
        body_of_(bodies_of_elements(mesh, c))
  {
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
      if (body_of_[mesh.region[cell]] != none) add_cell(cell);
    for (Index cell = 0, here = 0; cell < mesh.cell_count(); ++cell)
      if (body_of_[mesh.region[cell]] != none) add_faces(cell, here++);
  }

  SpaceMesh made;
  NodeField<Index> number_of_corner;  ///< by node of the mesh, or none

private:
  void add_cell(Index cell)
  {
    AtElementNodes<3, Index> nodes;
    for (int k = 0; k < 4; ++k) {
      Index& number = number_of_corner[mesh_.nodes[cell][k]];
      if (number == none) number = add_node(mesh_.position[mesh_.nodes[cell][k]]);
      nodes[k] = number;
    }
    for (int e = 0; const auto [j, k] : element_edges<3>) nodes[4 + e++] = middle(nodes[j], nodes[k]);
    made.nodes.push_back(nodes);
    made.body.push_back(body_of_[mesh_.region[cell]]);
    made.region.push_back(mesh_.region[cell]);
  }

  Index add_node(const Vec<3>& x)
  {
    made.position.push_back(x);
    return made.node_count() - 1;
  }

  /// Many tetrahedra share an edge: its node is found by its ends.
  Index middle(Index a, Index b)
  {
    const auto [at, is_new] = middle_of_.try_emplace(std::minmax(a, b), none);
    if (is_new) at->second = add_node((made.position[a] + made.position[b]) / 2);
    return at->second;
  }

  void add_faces(Index cell, Index here)
  {
    for (int k = 0; k < 4; ++k) {
      const Index beyond = mesh_.neighbor(cell, k);
      if (beyond != none && body_of_[mesh_.region[beyond]] != none) continue;
      const auto [a, b, c] = face_corners[k];
      const AtElementNodes<3, Index>& nodes = made.nodes[here];
      made.boundary_faces.push_back(
          {nodes[a], nodes[b], nodes[c], nodes[4 + edge_between(a, b)], nodes[4 + edge_between(b, c)], nodes[4 + edge_between(c, a)]});
    }
  }

  const mesh::Mesh<3>& mesh_;
  std::vector<Index> body_of_;  // by region
  std::map<std::pair<Index, Index>, Index> middle_of_;
};

/// What holds the corners of a face of the boundary holds the middles of its sides.
NodeField<std::uint8_t> held_nodes(const boundary::NodalConditions<3>& conditions, std::size_t stage, const TetrahedraMaker& maker)
{
  NodeField<std::uint8_t> held(maker.made.node_count(), 0);
  for (const boundary::NodalCondition<3>& row : conditions.rows) {
    if (!std::holds_alternative<boundary::Hold>(row.kind) || !row.acts[stage]) continue;
    NodeField<char> here(maker.made.node_count(), 0);
    for (const Index corner : row.nodes)
      if (const Index node = maker.number_of_corner[corner]; node != none) here[node] = 1, held[node] |= row.directions;
    for (const SpaceMesh::Face& face : maker.made.boundary_faces)
      if (here[face[0]] && here[face[1]] && here[face[2]])
        for (int k = 3; k < 6; ++k) held[face[k]] |= row.directions;
  }
  return held;
}

/// Moves the middle of a side whose ends lie on the round surface of a cylinder outwards onto it.
void bend_onto(const bodies::Cylinder<3>& cylinder, SpaceMesh& mesh)
{
  const Real radius = cylinder.core_radius + cylinder.edge;
  const auto across = [&](Index node) {
    Vec<3> local = cylinder.axes.transpose() * (mesh.position[node] - cylinder.center);
    local[1] = 0;
    return Vec<3>(cylinder.axes * local);
  };
  const auto is_round = [&](Index node) {
    const Real level = cylinder.axes.col(1).dot(mesh.position[node] - cylinder.center);
    return std::abs(across(node).norm() - radius) < 1e-6 * radius && std::abs(level) < (1 + 1e-6) * (cylinder.core_half + cylinder.edge);
  };
  for (const SpaceMesh::Face& face : mesh.boundary_faces)
    for (int k = 0; k < 3; ++k) {
      const Index middle = face[3 + k];
      if (!is_round(face[k]) || !is_round(face[(k + 1) % 3]) || is_round(middle)) continue;
      const Vec<3> out = across(middle);
      mesh.position[middle] += (radius / out.norm() - 1) * out;
    }
}

}  // namespace

SpaceMesh make_tetrahedra(const problem::Model<3>& model, const settings::Case& c)
{
  TetrahedraMaker maker(model.mesh, c);
  const boundary::NodalConditions<3>& conditions = model.conditions;
  for (Index table = 0; table < static_cast<Index>(conditions.tables.size()); ++table) {
    const auto stage = std::find(conditions.table_of_stage.begin(), conditions.table_of_stage.end(), table);
    maker.made.fixed.push_back(held_nodes(conditions, static_cast<std::size_t>(stage - conditions.table_of_stage.begin()), maker));
  }
  for (const bodies::RigidBody<3>& rigid : model.rigid_bodies)
    if (const auto* cylinder = std::get_if<bodies::Cylinder<3>>(&rigid.shape)) bend_onto(*cylinder, maker.made);
  refuse_folds<3>(maker.made);
  return std::move(maker.made);
}

}  // namespace berm::fem
