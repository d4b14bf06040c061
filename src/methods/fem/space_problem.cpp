// SPDX-License-Identifier: BSD-3-Clause
#include "fem/space_problem.hpp"

#include "bodies/initial_stress.hpp"
#include "material/laws.hpp"
#include "os/error.hpp"
#include "problem/archive_state.hpp"
#include "problem/initial_state.hpp"
#include "problem/stages.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::fem {
namespace {

/// Throws KeyError where the case asks for what the plane method has and this one has not.
void refuse_in_space(const settings::Case& c, const problem::Model<3>& model)
{
  const auto refuse = [](const std::string& key, const std::string& what) {
    throw KeyError(fmt::format("{}: finite elements in space have no {}: take method = \"mpm\", or the plane", key, what));
  };
  if (c.fem.large_deformation) refuse("fem.large_deformation", "remeshing");
  if (c.safety) refuse("safety", "trials of the factor of safety");
  if (c.output.support_reactions) refuse("output.support_reactions", "reactions of supports");
  if (!c.watch.empty()) refuse("watch." + c.watch.front().first, "watched points");
  if (!c.traction.empty()) refuse("traction." + c.traction.front().first, "tractions");
  if (loads_by_gravity(c, model.ground)) refuse("initial_state", "gravity loading, which ground that is not level needs");
  for (const auto& [name, contact] : c.contact) {
    if (!rules_of(contact.scheme).tied) refuse(fmt::format("contact.{}.scheme", name), "gap, friction or suction, only scheme = \"tied\"");
    if (contact.rigid.empty()) refuse(fmt::format("contact.{}.other_body", name), "contact with another body, only with a rigid one");
  }
  for (const auto& [name, rigid] : c.rigid) {
    if (std::holds_alternative<bodies::TriangulatedSettings>(rigid.shape))
      refuse(fmt::format("rigid.{}.shape", name), "bodies of triangles");
    if (rigid.motion == bodies::Motion::free) refuse(fmt::format("rigid.{}.motion", name), "free bodies, which no stage moves");
  }
  for (const boundary::NodalCondition<3>& row : model.conditions.rows)
    if (!std::holds_alternative<boundary::Hold>(row.kind)) refuse("support." + row.name, "motions, absorbing boundaries or heads");
  for (const problem::Body<3>& body : model.bodies) {
    if (body.flows()) refuse(fmt::format("body.{}.material", body.name), "water that flows through soil");
    for (const material::Material& soil : body.soil.materials)
      if (non_associated(soil)) refuse(fmt::format("body.{}.material", body.name), "soil whose plastic flow is not associated");
  }
}

/// The nodes on the surfaces of the rigid bodies in contact. Throws KeyError where a contact has none.
NodeField<Index> tie_nodes(const SpaceModel& model)
{
  constexpr Real on_surface = 1e-6;  // of a side
  NodeField<Index> tied(model.mesh.node_count(), none);
  for (Index k = 0; k < model.contact_count(); ++k) {
    const auto is_on = [&](Index node, Real side) {
      return std::abs(surface_at<3>(model.rigid_of(k).shape, model.mesh.position[node]).distance) < on_surface * side;
    };
    bool found = false;
    for (const SpaceMesh::Face& face : model.mesh.boundary_faces) {
      const Real side = (model.mesh.position[face[1]] - model.mesh.position[face[0]]).norm();
      if (!std::all_of(face.begin(), face.end(), [&](Index node) { return is_on(node, side); })) continue;
      found = true;
      for (const Index node : face)
        if (tied[node] == none) tied[node] = k;
    }
    if (!found)
      throw KeyError(fmt::format("contact.{}: the mesh has no face on the surface of rigid.{}: its soil must end there",
                                 model.model.contacts[k].name, model.rigid_of(k).name));
  }
  return tied;
}

void fill_shapes(SpaceModel& model)
{
  const Index cells = model.mesh.cell_count();
  model.shape.assign(cells);
  model.mean_gradient.assign(cells);
  model.place.assign(cells);
  model.density.assign(cells);
  for (Index cell = 0; cell < cells; ++cell) {
    const AtElementNodes<3, Vec<3>> nodes = model.mesh.positions_of(cell);
    AtElementNodes<3, Vec<3>>& mean = model.mean_gradient[cell];
    mean.fill(Vec<3>::Zero());
    Real volume = 0;
    for (int q = 0; q < element_points<3>; ++q) {
      ElementPoint<3>& shape = model.shape[cell][q] = shape_at<3>(nodes, q);
      if (!(shape.area > 0)) throw RunError(fmt::format("the element at ({}, {}, {}) is inverted", nodes[0][0], nodes[0][1], nodes[0][2]));
      volume += shape.area;
      for (int k = 0; k < element_nodes<3>; ++k) mean[k] += shape.area * shape.gradient[k];
      const settings::SoilPlace& place = model.place[cell][q] = model.model.soil_place(position_of<3>(shape, nodes));
      const settings::BodySoil& soil = model.soil_of(cell);
      model.density[cell][q] = density(soil.materials[soil.material_index_at(model.region_of(cell), place)]);
      model.weight += shape.area * model.density[cell][q] * model.model.gravity.norm();
    }
    for (Vec<3>& gradient : mean) gradient /= volume;
  }
}

/// All unknowns that an element's displacements are sums of, ascending.
std::vector<Index> unknowns_of(const SpaceModel& model, Index cell)
{
  std::vector<Index> unknowns;
  for (const Index node : model.mesh.nodes[cell])
    for (int d = 0; d < 3; ++d) model.for_parts(node, d, [&](const UnknownPart& part) { unknowns.push_back(part.unknown); });
  std::sort(unknowns.begin(), unknowns.end());
  unknowns.erase(std::unique(unknowns.begin(), unknowns.end()), unknowns.end());
  return unknowns;
}

SparsePattern pattern_of(const SpaceModel& model)
{
  std::vector<std::vector<Index>> rows(static_cast<std::size_t>(model.unknowns()));
  for (Index unknown = 0; unknown < model.unknowns(); ++unknown) rows[unknown].push_back(unknown);
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    const std::vector<Index> unknowns = unknowns_of(model, cell);
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      rows[unknowns[i]].insert(rows[unknowns[i]].end(), unknowns.begin(), unknowns.begin() + static_cast<std::ptrdiff_t>(i));
  }
  SparsePattern pattern;
  pattern.first.push_back(0);
  for (std::vector<Index>& row : rows) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    pattern.column.insert(pattern.column.end(), row.begin(), row.end());
    pattern.first.push_back(static_cast<Index>(pattern.column.size()));
    row = {};
  }
  return pattern;
}

/// Stress at rest and state variables of the laws at all points.
void set_first_stress(const settings::Case& c, const SpaceModel& model, SpaceState& state)
{
  const Real gravity = -model.model.axes.sign * model.model.gravity[model.model.axes.up];
  state.points.assign(model.mesh.cell_count());
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    for (int q = 0; q < element_points<3>; ++q) {
      const Index body = model.mesh.body[cell];
      const settings::BodySoil& soil = model.soil_of(cell);
      const settings::SoilPlace& place = model.place[cell][q];
      ElementSoil<3>& point = state.points[cell][q];
      refuse_no_strength(soil, model.region_of(cell), place.depth, model.model.bodies[body].name);
      point.stress = bodies::stress_at_rest<3>(c.body[body].second, gravity * soil.mass_above(model.region_of(cell), place), place.depth);
      initial_state(model.soil_at(cell, q), point.stress, point.law_state.data());
    }
}

/// The force of the element's pressures as their points have them, less that by the mean gradients: with it soil at rest has no residual but where stresses do not balance.
NodeField<Vec<3>> rest_force_of(const SpaceModel& model, const SpaceState& state)
{
  NodeField<Vec<3>> force(model.mesh.node_count(), Vec<3>::Zero());
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    for (int q = 0; q < element_points<3>; ++q) {
      const ElementPoint<3>& shape = model.shape[cell][q];
      const Real p = trace(state.points[cell][q].stress) / 3;
      for (int k = 0; k < element_nodes<3>; ++k)
        force[model.mesh.nodes[cell][k]] += shape.area * p * (shape.gradient[k] - model.mean_gradient[cell][k]);
    }
  return force;
}

}  // namespace

SpaceProblem build_in_space(const settings::Case& c, mesh::Mesh<3> mesh)
{
  SpaceProblem problem;
  SpaceModel& model = problem.model;
  SpaceState& state = problem.state;
  model.model = problem::make_model(c, std::move(mesh));
  refuse_in_space(c, model.model);
  refuse_k0_below_uneven_ground(c, model.model);
  model.settings = c.fem;
  model.mesh = make_tetrahedra(model.model, c);
  model.tied = tie_nodes(model);
  for (Index k = 0; k < model.contact_count(); ++k) {
    const Real width = width_of<3>(model.rigid_of(k).shape);
    model.width = k == 0 ? width : std::min(model.width, width);
  }
  fill_shapes(model);
  model.pattern = pattern_of(model);
  for (std::size_t k = 0; k < model.model.stages.size(); ++k)
    if (model.model.driven[k] != none && model.contact_of(model.model.driven[k]) == none)
      throw KeyError(fmt::format("stage[{}].rigid: finite elements move rigid bodies that a contact joins with the soil; rigid.{} has none",
                                 k, model.model.rigid_bodies[model.model.driven[k]].name));
  set_first_stress(c, model, state);
  model.rest_force = rest_force_of(model, state);
  state.displacement.assign(static_cast<std::size_t>(model.unknowns()), 0.);
  state.state.rigid_bodies.resize(model.model.rigid_bodies.size());
  begin_stage(model.model, state.state);
  return problem;
}

// The sizes reveal a member that is not archived yet.
void archive(Archive& k, const SpaceModel& model, SpaceState& state)
{
  static_assert(sizeof(ElementSoil<3>) == (tensor_size<3> + material::max_state + 2) * sizeof(Real));
  static_assert(sizeof(SpaceState) == sizeof(problem::State<3>) + 2 * sizeof(std::vector<Real>) + sizeof(Vec<3>) + 3 * sizeof(Real));
  k.table("state", [&] { problem::archive(k, model.model, state.state); });
  k.fixed("displacement", state.displacement);
  std::vector<Real> numbers;
  const auto visit = [&](const auto& number) {
    for (auto& of_cell : state.points)
      for (ElementSoil<3>& point : of_cell) {
        for (Real& component : point.stress.c) number(component);
        for (Real& of_law : point.law_state) number(of_law);
        number(point.deviatoric_strain);
        number(point.overstress);
      }
  };
  visit([&](const Real& number) { numbers.push_back(number); });
  k.fixed("points", numbers);
  auto next = numbers.begin();
  visit([&](Real& number) { number = *next++; });
  k("gravity", state.gravity);
  k("initial_imbalance_factor", state.initial_imbalance_factor);
  k("unbalanced", state.unbalanced);
  k("overstress", state.overstress);
}

}  // namespace berm::fem
