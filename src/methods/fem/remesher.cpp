// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/remesher_test.cpp
#include "fem/remesher.hpp"

#include "fem/cut_mesh.hpp"
#include "mesh/gmsh.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>

namespace berm::fem {
namespace {

constexpr Real least_determinant = 0.3;  // of the Jacobian at a node, over that when the mesh was made

/// Whether an element has lost much of its shape since the mesh was made.
bool is_folding(const FemModel& model, const FemState& state)
{
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    const AtSixNodes<Vec<2>> first = model.mesh.positions_of(cell), now = positions_now(model, state, cell);
    for (const Vec<2>& at : six_nodes)
      if (jacobian(now, at).determinant() < least_determinant * jacobian(first, at).determinant()) return true;
  }
  return false;
}

/// Whether soil that has no contact point has come into a body.
bool is_met_elsewhere(const FemModel& model, const FemState& state)
{
  NodeField<char> may_meet(model.mesh.node_count(), 0);
  for (const BoundarySide& side : model.contact_sides)
    for (const Index node : {side.from, side.middle, side.to}) may_meet[node] = 1;
  const std::vector<bodies::Pose<2>> poses = poses_of(state);
  for (const BoundarySide& side : model.mesh.boundary_sides)
    if (is_ground(model.model.mesh, side))
      for (const Index node : {side.from, side.middle, side.to})
        if (!may_meet[node] && nearest_surface(model, poses, position_now(model, state, node)).distance < 0) return true;
  return false;
}

/// Geometry for Gmsh whose outline is divided already.
void write_outline(const std::vector<OutlineLoop>& outline, const mesh::Mesh<2>& names, const std::vector<std::string>& sizes,
                   const std::filesystem::path& path)
{
  std::ofstream out(path);
  out << "// The soil at a remeshing, made by berm. Lengths in metres.\n";
  std::size_t lines = 0;
  std::vector<std::string> loops, of_boundary(names.boundary_names.size());
  for (const OutlineLoop& loop : outline) {
    const std::size_t first = lines + 1, n = loop.size();
    for (std::size_t k = 0; k < n; ++k) {
      out << fmt::format("Point({}) = {{{}, {}, 0}};\n", first + k, loop[k].corner.x[0], loop[k].corner.x[1]);
      if (const Index boundary = loop[k].boundary; boundary != none)
        of_boundary[static_cast<std::size_t>(boundary)] +=
            fmt::format("{}{}", of_boundary[static_cast<std::size_t>(boundary)].empty() ? "" : ", ", first + k);
    }
    for (std::size_t k = 0; k < n; ++k) out << fmt::format("Line({}) = {{{}, {}}};\n", first + k, first + k, first + (k + 1) % n);
    out << fmt::format("Curve Loop({}) = {{{}:{}}};\n", loops.size() + 1, first, lines + n);
    loops.push_back(std::to_string(loops.size() + 1));
    lines += n;
  }
  std::string all;
  for (const std::string& loop : loops) all += (all.empty() ? "" : ", ") + loop;
  out << fmt::format("Transfinite Curve{{1:{}}} = 2;\nPlane Surface(1) = {{{}}};\nPhysical Surface(\"soil\") = {{1}};\n", lines, all);
  for (std::size_t k = 0; k < of_boundary.size(); ++k)
    if (!of_boundary[k].empty()) out << fmt::format("Physical Curve(\"{}\") = {{{}}};\n", names.boundary_names[k], of_boundary[k]);
  mesh::end_geometry(out, sizes, path);
}

/// The boundaries in the order of the names, those without nodes, too.
void order_boundaries(mesh::Mesh<2>& mesh, const std::vector<std::string>& names)
{
  std::vector<std::vector<Index>> nodes(names.size());
  for (std::size_t k = 0; k < names.size(); ++k)
    if (const Index found = mesh.find_boundary(names[k]); found != none) nodes[k] = mesh.boundary_nodes[found];
  mesh.boundary_names = names;
  mesh.boundary_nodes = std::move(nodes);
}

/// Puts the nodes of the boundary onto the outline, and says by node which point of it they are; null inside.
std::vector<const OutlinePoint*> put_on_outline(QuadraticMesh& mesh, const std::vector<OutlineLoop>& outline)
{
  std::vector<const OutlinePoint*> of_node(static_cast<std::size_t>(mesh.node_count()), nullptr);
  std::vector<const OutlineSide*> sides;
  for (const OutlineLoop& loop : outline)
    for (const OutlineSide& side : loop) sides.push_back(&side);
  for (const BoundarySide& side : mesh.boundary_sides) {
    const Vec<2>& x = mesh.position[side.from];
    const auto& [corner, middle, boundary, free] =
        **std::min_element(sides.begin(), sides.end(), [&](const OutlineSide* a, const OutlineSide* b) {
          return (a->corner.x - x).squaredNorm() < (b->corner.x - x).squaredNorm();
        });
    of_node[static_cast<std::size_t>(side.from)] = &corner;
    of_node[static_cast<std::size_t>(side.middle)] = &middle;
    mesh.position[side.from] = corner.x;
    mesh.position[side.middle] = middle.x;
  }
  return of_node;
}

bool is_folded(const AtSixNodes<Vec<2>>& x)
{
  return std::any_of(six_nodes.begin(), six_nodes.end(), [&](const Vec<2>& at) { return jacobian(x, at).determinant() <= 0; });
}

/// Straightens the sides of elements that a curved one folds, as little as is needed, since the middle of a straight side at a round body lies in the body.
void unfold(QuadraticMesh& mesh)
{
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const AtSixNodes<Vec<2>> curved = mesh.positions_of(cell);
    AtSixNodes<Vec<2>> x = curved;
    for (Real part = 0.25; is_folded(x) && part <= 1; part += 0.25)
      for (int k = 0; k < 3; ++k) x[3 + k] = (1 - part) * curved[3 + k] + part * (curved[k] + curved[(k + 1) % 3]) / 2;
    for (int k = 3; k < 6; ++k) mesh.position[mesh.nodes[cell][k]] = x[k];
  }
}

/// Formulas of Gmsh whose least is the size of an element.
std::vector<std::string> size_formulas(const FemModel& model, const FemState& state, const ElementSizes& sizes)
{
  if (model.contact_count() == 0) return {fmt::format("{}", sizes.contact)};
  std::vector<std::string> formulas;
  for (const bodies::RigidShape<2>& shape : shapes_in_contact(model, state)) {
    for (const std::string& distance : distances_from(shape))
      formulas.push_back(
          fmt::format("Min({}, {} + {} * Max(0, {} - {}))", sizes.largest, sizes.contact, ElementSizes::growth, distance, sizes.fine));
    if (const auto* profile = std::get_if<bodies::Profile<2>>(&shape))
      for (const Vec<2>& corner : corners_of(profile->core))
        formulas.push_back(fmt::format("{} + {} * Sqrt((x - ({}))^2 + (y - ({}))^2)", ElementSizes::at_corner * sizes.contact,
                                       ElementSizes::from_there, corner[0], corner[1]));
  }
  return formulas;
}

}  // namespace

Remesher::Remesher(const settings::Case& c, std::filesystem::path folder)
    : case_(c),
      folder_(std::move(folder)),
      gmsh_(std::make_unique<WaitingGmsh>(folder_))
{
  for (const auto& [name, rigid] : c.rigid)
    if (std::holds_alternative<bodies::HalfPlaneSettings>(rigid.shape))
      throw KeyError(fmt::format("rigid.{}.shape: fem.large_deformation needs a body of finite width", name));
  for (const auto& [name, contact] : c.contact)
    if (rules_of(contact.scheme).tied)
      throw KeyError(fmt::format(
          "contact.{}.scheme: fem.large_deformation needs a surface that can open: take adhesion_factor = 1 for a rough one", name));
  if (c.safety) throw KeyError("safety: the factor of safety is a small-strain analysis: remove fem.large_deformation");
  if (c.body.size() != 1) throw KeyError("body: fem.large_deformation needs all soil in one [body]; define layers by soil_layer");
  const auto& [name, body] = c.body.front();
  if (!body.region_material.empty())
    throw KeyError(
        fmt::format("body.{}.region_material: with fem.large_deformation soil leaves its region: define layers by soil_layer", name));
  if (!std::holds_alternative<mesh::SeabedMesh>(c.mesh) && !c.contact.empty())
    throw KeyError("mesh.kind: fem.large_deformation with a rigid body needs kind = \"seabed\", which is cut along the body");
  if (std::holds_alternative<mesh::GmshFile>(c.mesh) && !c.fem.contact_size)
    throw KeyError(
        "fem.contact_size: is missing: with fem.large_deformation a mesh of kind \"gmsh\" is remeshed with elements of this size");
}

ElementSizes Remesher::sizes_for(const FemModel& model) const
{
  const Real contact = contact_size_of(case_);
  if (model.contact_count() == 0) return {contact, contact, 0};
  const Real far = std::get<mesh::SeabedMesh>(case_.mesh).far_size.value_or(model.width);
  return {contact, std::max(far, contact), model.width / 4};
}

Real Remesher::travel_since_mesh(const FemModel& model, const FemState& state)
{
  Real travel = 0;
  for (const problem::Contact& contact : model.model.contacts)
    travel = std::max(travel, distance_between(model.model.rigid_bodies[contact.rigid], state.meshed_at[contact.rigid],
                                               state.state.rigid_bodies[contact.rigid]));
  return travel;
}

bool Remesher::is_due(const FemModel& model, const FemState& state) const
{
  if (model.contact_count() == 0) return is_folding(model, state) || is_beyond_wall(model, state);
  constexpr Real rounding = 1e-9;
  const Real travel = travel_since_mesh(model, state);
  if (travel >= (1 - rounding) * model.settings.remeshing_travel * model.width) return true;
  return travel > 0 && (is_met_elsewhere(model, state) || is_beyond_wall(model, state) || is_folding(model, state));
}

void Remesher::refuse_bodies_that_meet(const FemModel& model, const FemState& state) const
{
  constexpr Real least_gap = 0.25;  // of the elements at the bodies
  const Real reach = least_gap * contact_size_of(case_);
  const auto& bodies = model.model.rigid_bodies;
  for (const auto& [first, second, proximity] : model.model.apart) {
    if (model.contact_of(first) == none || model.contact_of(second) == none) continue;
    const auto near = proximity_points(proximity, bodies[first], state.state.rigid_bodies[first], bodies[second],
                                       state.state.rigid_bodies[second], reach);
    if (near.count > 0)
      throw RunError(fmt::format("t = {:.6g} s: rigid.{} and rigid.{} meet: {:.2g} m are left between them, less than a quarter of an "
                                 "element; finite elements have no contact of two rigid bodies, and end here",
                                 state.state.time, bodies[first].name, bodies[second].name, near.points[0].gap));
  }
}

mesh::Mesh<2> Remesher::make_mesh(const FemModel& model, const FemState& state, const std::vector<OutlineLoop>& outline) const
{
  const ElementSizes sizes = sizes_for(model);
  const std::string geo = "remesh.geo", msh = "remesh.msh";
  write_outline(outline, model.model.mesh, size_formulas(model, state, sizes), folder_ / geo);
  try {
    gmsh_->mesh(geo, msh);
  } catch (const RunError& error) {
    throw RunError(fmt::format(
        "t = {:.6g} s: the soil could not be remeshed: {}. Where Gmsh cannot recover an edge, smaller elements (fem.contact_size) or a "
        "smaller fem.remeshing_travel may help",
        state.state.time, error.what()));
  }
  mesh::Mesh<2> mesh = mesh::read_msh<2>(folder_ / msh);
  mesh.metric = model.model.mesh.metric;
  mesh.region_names = model.model.mesh.region_names;
  mesh.region.assign(mesh.cell_count(), model.mesh.region[0]);
  order_boundaries(mesh, model.model.mesh.boundary_names);
  return mesh;
}

int Remesher::remesh(FemModel& model, FemState& state) const
{
  int folds = 0;
  const std::vector<OutlineLoop> outline = divide_outline(model, state, sizes_for(model), folds);
  FemModel next = model;
  next.model.mesh = make_mesh(model, state, outline);
  next.mesh = make_quadratic(next.model.mesh, case_, {});
  const std::vector<const OutlinePoint*> of_node = put_on_outline(next.mesh, outline);
  unfold(next.mesh);
  FemState mapped = state;
  map_state(model, state, of_node, case_, next, mapped);
  mapped.meshed_at = poses_of(mapped);
  model = std::move(next);
  state = std::move(mapped);
  return folds;
}

}  // namespace berm::fem
