// SPDX-License-Identifier: BSD-3-Clause
#include "fem/quadratic_mesh.hpp"

#include "bodies/fill.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::fem {
namespace {

// Makes 6-node triangles of the cells of bodies.
class Maker {
public:
  Maker(const mesh::Mesh<2>& mesh, const settings::Case& c)
      : mesh_(mesh),
        body_of_(bodies_of_elements(mesh, c)),
        node_number_(mesh.node_count(), none),
        cell_number_(mesh.cell_count(), none)
  {
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
      if (body_of(cell) != none) add_cell(cell);
  }

  /// The nodes of a boundary, those in the middle of its sides too.
  std::vector<Index> nodes_at(Index boundary) const
  {
    NodeField<char> at_boundary(made.node_count(), false);
    std::vector<Index> nodes;
    for (const Index i : mesh_.boundary_nodes[boundary])
      if (const Index node = node_number_[i]; node != none) at_boundary[node] = true, nodes.push_back(node);
    for (const BoundarySide& side : made.boundary_sides)
      if (at_boundary[side.from] && at_boundary[side.to]) nodes.push_back(side.middle);
    return nodes;
  }

  std::vector<BoundarySide> sides_at(Index boundary) const
  {
    NodeField<char> at_boundary(made.node_count(), false);
    for (const Index i : mesh_.boundary_nodes[boundary])
      if (node_number_[i] != none) at_boundary[node_number_[i]] = true;
    std::vector<BoundarySide> sides;
    for (const BoundarySide& side : made.boundary_sides)
      if (at_boundary[side.from] && at_boundary[side.to]) sides.push_back(side);
    return sides;
  }

  /// Gives sides their boundaries.
  void name_sides()
  {
    for (Index boundary = static_cast<Index>(mesh_.boundary_names.size()) - 1; boundary >= 0; --boundary) {
      NodeField<char> at_boundary(made.node_count(), false);
      for (const Index i : mesh_.boundary_nodes[boundary])
        if (node_number_[i] != none) at_boundary[node_number_[i]] = true;
      for (BoundarySide& side : made.boundary_sides)
        if (at_boundary[side.from] && at_boundary[side.to]) side.boundary = boundary;
    }
  }

  QuadraticMesh made;

private:
  Index body_of(Index cell) const { return cell == none ? none : body_of_[mesh_.region[cell]]; }

  void add_cell(Index cell)
  {
    AtSixNodes<Index> nodes;
    for (int k = 0; k < 3; ++k) nodes[k] = vertex(mesh_.nodes[cell][k]);
    for (int k = 0; k < 3; ++k) nodes[3 + k] = middle(cell, k, nodes[k], nodes[(k + 1) % 3]);
    cell_number_[cell] = made.cell_count();
    made.nodes.push_back(nodes);
    made.body.push_back(body_of(cell));
    made.region.push_back(mesh_.region[cell]);
  }

  Index add_node(const Vec<2>& x)
  {
    made.position.push_back(x);
    return made.node_count() - 1;
  }

  Index vertex(Index i)
  {
    if (node_number_[i] == none) node_number_[i] = add_node(mesh_.position[i]);
    return node_number_[i];
  }

  // The mid-side node of side k, from corner k to the next; the corner opposite to it is the one after that.
  Index middle(Index cell, int k, Index from, Index to)
  {
    const Index beyond = mesh_.neighbor(cell, (k + 2) % 3);
    if (body_of(beyond) != none && cell_number_[beyond] != none) {
      int opposite = 0;
      while (mesh_.neighbor(beyond, opposite) != cell) ++opposite;
      return made.nodes[cell_number_[beyond]][3 + (opposite + 1) % 3];
    }
    const Index middle = add_node((made.position[from] + made.position[to]) / 2);
    if (body_of(beyond) == none) made.boundary_sides.push_back({from, to, middle});
    return middle;
  }

  const mesh::Mesh<2>& mesh_;
  std::vector<Index> body_of_;  // by region
  NodeField<Index> node_number_;
  CellField<Index> cell_number_;  // of the cells that exist already
};

// Whether nodes lie on the surface of the shape, to a millionth of the side.
bool on_surface(const QuadraticMesh& mesh, const bodies::RigidShape<2>& shape, const BoundarySide& side, std::initializer_list<Index> nodes)
{
  const Real tolerance = 1e-6 * (mesh.position[side.to] - mesh.position[side.from]).norm();
  return std::all_of(nodes.begin(), nodes.end(),
                     [&](Index node) { return std::abs(surface_at<2>(shape, mesh.position[node]).distance) < tolerance; });
}

// The ends of sides, each once.
std::vector<Index> ends_of(const std::vector<BoundarySide>& sides)
{
  std::vector<Index> nodes;
  for (const BoundarySide& side : sides) nodes.insert(nodes.end(), {side.from, side.to});
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void bend_onto(QuadraticMesh& mesh, const bodies::RigidShape<2>& shape)
{
  for (const BoundarySide& side : mesh.boundary_sides) {
    if (!on_surface(mesh, shape, side, {side.from, side.to})) continue;
    Vec<2>& x = mesh.position[side.middle];
    const bodies::SurfacePoint<2> nearest = surface_at<2>(shape, x);
    x -= nearest.distance * nearest.normal;
  }
}

}  // namespace

template <int dim>
std::vector<Index> bodies_of_elements(const mesh::Mesh<dim>& mesh, const settings::Case& c)
{
  std::vector<Index> body_of(mesh.region_names.size(), none);
  for (Index b = 0; b < static_cast<Index>(c.body.size()); ++b) {
    const auto& [name, body] = c.body[b];
    if (body.block || body.disk)
      throw KeyError(fmt::format("body.{}.{}: for finite elements a body must fill regions of the mesh: regions = [...]", name,
                                 body.block ? "block" : "disk"));
    for (const std::string& region : body.regions) {
      Index& holder = body_of[bodies::filled_region(mesh, name, region)];
      if (holder != none && holder != b)
        throw KeyError(fmt::format("body.{}.regions: the region \"{}\" is filled by [body.{}] already; for finite elements a region has "
                                   "one body",
                                   name, region, c.body[holder].first));
      holder = b;
    }
  }
  return body_of;
}

template <int dim>
void refuse_folds(const QuadraticElements<dim>& mesh)
{
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const AtElementNodes<dim, Vec<dim>> x = mesh.positions_of(cell);
    for (const Vec<dim>& at : element_node_places<dim>())
      if (jacobian<dim>(x, shape_derivatives<dim>(at)).determinant() <= 0)
        throw KeyError(fmt::format("fem.contact_size: an element near ({:.6g}, {:.6g}) m is folded, because its side is too long for the "
                                   "rigid body's curve: the mesh must be finer there",
                                   x[0][0], x[0][1]));
  }
}

template std::vector<Index> bodies_of_elements<2>(const mesh::Mesh<2>&, const settings::Case&);
template std::vector<Index> bodies_of_elements<3>(const mesh::Mesh<3>&, const settings::Case&);
template void refuse_folds<3>(const QuadraticElements<3>&);

QuadraticMesh make_quadratic(const mesh::Mesh<2>& mesh, const settings::Case& c, const std::vector<bodies::RigidShape<2>>& shapes)
{
  Maker maker(mesh, c);
  maker.name_sides();
  for (const std::vector<settings::SupportRole>& roles : support_sets(c).roles) {
    NodeField<std::uint8_t> fixed(maker.made.node_count(), 0), closed = fixed;
    NodeField<boundary::Holders<2>> holders(c.output.support_reactions ? maker.made.node_count() : 0, {none, none});
    for (std::size_t k = 0; k < c.support.size(); ++k) {
      const auto& [name, support] = c.support[k];
      const Index boundary = fixed_boundary(mesh, name, support);
      if (roles[k] == settings::SupportRole::none) continue;
      const std::uint8_t directions = fixed_directions(support);
      for (const Index node : maker.nodes_at(boundary)) {
        fixed[node] |= directions;
        if (!support.drained) closed[node] |= directions;
        if (c.output.support_reactions) boundary::add_holder<2>(holders[node], static_cast<Index>(k), directions);
      }
    }
    maker.made.fixed.push_back(std::move(fixed));
    maker.made.impermeable.push_back(std::move(closed));
    if (c.output.support_reactions) maker.made.holders.push_back(std::move(holders));
  }
  // Where two boundaries meet at a corner it has the head of the first.
  std::vector<std::pair<std::string, std::vector<Index>>> with_head;
  for (const auto& [name, support] : c.support) {
    if (!support.head || *support.head == 0) continue;
    std::vector<Index> nodes = ends_of(maker.sides_at(fixed_boundary(mesh, name, support)));
    with_head.emplace_back(support.boundary, nodes);
    for (const auto& [boundary, taken] : with_head)
      if (boundary != support.boundary)
        std::erase_if(nodes, [&, &taken = taken](Index node) { return std::binary_search(taken.begin(), taken.end(), node); });
    maker.made.head_nodes.push_back(nodes);
  }
  for (const auto& [name, traction] : c.traction) maker.made.loaded_sides.push_back(maker.sides_at(loaded_boundary(mesh, name, traction)));
  for (const bodies::RigidShape<2>& shape : shapes) bend_onto(maker.made, shape);
  refuse_folds<2>(maker.made);
  return std::move(maker.made);
}

bool is_ground(const mesh::Mesh<2>& mesh, const BoundarySide& side)
{
  return side.boundary == none || mesh.boundary_names[side.boundary] == "surface";
}

std::vector<BoundarySide> contact_sides(const QuadraticMesh& mesh, const bodies::RigidShape<2>& shape)
{
  std::vector<BoundarySide> sides;
  for (const BoundarySide& side : mesh.boundary_sides)
    if (on_surface(mesh, shape, side, {side.from, side.to, side.middle})) sides.push_back(side);
  return sides;
}

}  // namespace berm::fem
