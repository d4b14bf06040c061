// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/cut_mesh_test.cpp
#include "fem/fem_problem.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::fem {
namespace {

/// Stiffness of the contact springs, relative to a layer of soil as thick as the elements at the body.
constexpr Real contact_stiffness = 100;
constexpr Real soft_contact = 0.4;  // of that, in large deformations

/// The unknowns of an element, and the entries of the matrix that they couple.
class PatternMaker {
public:
  explicit PatternMaker(Index unknowns) : rows_(unknowns) {}

  void couple(std::span<const Index> unknowns)
  {
    for (const Index row : unknowns)
      for (const Index column : unknowns)
        if (column <= row) rows_[row].push_back(column);
  }
  SparsePattern pattern()
  {
    SparsePattern made;
    made.first.push_back(0);
    for (std::vector<Index>& row : rows_) {
      std::sort(row.begin(), row.end());
      row.erase(std::unique(row.begin(), row.end()), row.end());
      made.column.insert(made.column.end(), row.begin(), row.end());
      made.first.push_back(static_cast<Index>(made.column.size()));
    }
    return made;
  }

private:
  std::vector<std::vector<Index>> rows_;
};

std::array<Index, 12> unknowns_of(const AtSixNodes<Index>& nodes)
{
  std::array<Index, 12> unknowns;
  for (int k = 0; k < 12; ++k) unknowns[k] = 2 * nodes[k / 2] + k % 2;
  return unknowns;
}

std::array<Index, 15> unknowns_with_pressures(const FemModel& model, Index cell)
{
  const AtSixNodes<Index>& nodes = model.mesh.nodes[cell];
  std::array<Index, 15> unknowns;
  for (int k = 0; k < 12; ++k) unknowns[k] = 2 * nodes[k / 2] + k % 2;
  for (int k = 0; k < 3; ++k) unknowns[12 + k] = model.flow.unknown[nodes[k]];
  return unknowns;
}

void number_unknowns(FemModel& model)
{
  PatternMaker maker(model.unknowns());
  for (const auto& nodes : model.mesh.nodes) maker.couple(unknowns_of(nodes));
  for (Index cell = 0; cell < model.flow.water.size(); ++cell)
    if (model.flow.in(cell)) maker.couple(unknowns_with_pressures(model, cell));
  for (Index unknown = model.rigid_unknown(); unknown < model.unknowns(); ++unknown) maker.couple(std::array{unknown});
  model.pattern = maker.pattern();
  model.cell_entries.assign(model.mesh.nodes.size());
  for (Index cell = 0; cell < model.mesh.nodes.size(); ++cell) {
    const std::array<Index, 12> unknowns = unknowns_of(model.mesh.nodes[cell]);
    int k = 0;
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j <= i; ++j)
        model.cell_entries[cell][k++] = model.pattern.index_of(std::max(unknowns[i], unknowns[j]), std::min(unknowns[i], unknowns[j]));
  }
  model.flow.entries.assign(model.flow.water.size());
  for (Index cell = 0; cell < model.flow.water.size(); ++cell) {
    if (!model.flow.in(cell)) continue;
    const std::array<Index, 15> unknowns = unknowns_with_pressures(model, cell);
    int k = 0;
    for (int i = 12; i < 15; ++i)
      for (int j = 0; j <= i; ++j)
        model.flow.entries[cell][k++] = model.pattern.index_of(std::max(unknowns[i], unknowns[j]), std::min(unknowns[i], unknowns[j]));
  }
}

/// Modulus of the stiffest soil that the surface of the rigid body of a contact meets, Pa: of its P-waves, in large deformations of shear, since stiff springs on a surface that turns need short increments; where regions have their own materials, the stiffest of all at these depths.
Real stiffest_at_contact(const FemModel& model, const NodeField<Vec<2>>& was_at, Index contact)
{
  const settings::BodySoil& soil = model.model.bodies[model.model.contacts[contact].body].soil;
  const auto modulus = [&](const material::Material& there) {
    return model.settings.large_deformation ? soft_contact * elasticity(there).shear : p_wave_modulus(there);
  };
  // What comes from the mudline has hardly a stiffness, and lies on stiffer soil.
  const Real least = model.settings.large_deformation ? width_of<2>(model.rigid_of(contact).shape) / 4 : -infinity;
  Real stiffest = 0;
  for (const FemContactPoint& point : model.contact) {
    if (point.contact != contact) continue;
    settings::SoilPlace place = model.model.soil_place(was_at[point.node]);
    place.depth = std::max(place.depth, least);
    stiffest = std::max(stiffest, modulus(soil.at("", place)));
    for (const auto& [region, number] : soil.of_region) stiffest = std::max(stiffest, modulus(soil.at(region, place)));
  }
  return stiffest;
}

/// Throws KeyError where the soil beside an interface cannot be told by its depth.
void refuse_regions_beside(const FemModel& model, const problem::Contact& contact)
{
  const settings::BodySoil& soil = model.model.bodies[contact.body].soil;
  const bool by_soil = !contact.adhesion_law.by_soil.empty();
  if ((contact.adhesion_law.factor > 0 || by_soil) && !soil.of_region.empty())
    throw KeyError(
        fmt::format("contact.{}.{}: finite elements find the soil beside the interface by its depth: give the soil by soil_layer "
                    "instead of region_material, or one friction and an adhesion in Pa",
                    contact.name, by_soil ? "soil" : "adhesion_factor"));
}

/// The friction of each contact point, and its adhesion before it slides: beside soil at rest at its depth.
void set_adhesion(FemModel& model, const NodeField<Vec<2>>& was_at)
{
  for (FemContactPoint& point : model.contact) {
    const problem::Contact& contact = model.model.contacts[point.contact];
    const settings::BodySoil& soil = model.model.bodies[contact.body].soil;
    const settings::SoilPlace place = model.model.soil_place(was_at[point.node]);
    const material::Material there = soil.at("", place);
    const Index number = soil.material_index_at("", place);
    const std::vector<Real> undisturbed(static_cast<std::size_t>(state_size(there)), 0);
    point.adhesion = contact.adhesion_law.at(there, undisturbed.data(), 0, number);
    point.friction =
        !contact.adhesion_law.by_soil.empty() ? contact.adhesion_law.by_soil[static_cast<std::size_t>(number)].friction : contact.friction;
  }
}

/// Throws KeyError where a contact is not with a rigid body of its own.
void refuse_contacts(const FemModel& model)
{
  for (Index k = 0; k < model.contact_count(); ++k) {
    const problem::Contact& contact = model.model.contacts[k];
    if (contact.rigid == none)
      throw KeyError(fmt::format("contact.{}.other_body: the finite element method supports contact with a rigid body only", contact.name));
    if (model.contact_of(contact.rigid) != k)
      throw KeyError(fmt::format("contact.{}.rigid: the finite element method supports one contact with each rigid body", contact.name));
    refuse_regions_beside(model, contact);
  }
}

/// The sides of the ground that a body may reach before the next remeshing.
std::vector<BoundarySide> sides_within_reach(const FemModel& model, const std::vector<bodies::Pose<2>>& poses)
{
  constexpr Real remeshings = 2;
  const Real reach = remeshings * model.settings.remeshing_travel;
  const auto is_near = [&](Index node) {
    const NearestSurface nearest = nearest_surface(model, poses, model.mesh.position[node]);
    return nearest.distance < reach * width_of<2>(model.rigid_of(nearest.contact).shape);
  };
  std::vector<BoundarySide> sides;
  for (const BoundarySide& side : model.mesh.boundary_sides)
    if (is_ground(model.model.mesh, side) && (is_near(side.from) || is_near(side.middle) || is_near(side.to))) sides.push_back(side);
  return sides;
}

/// The sides on the surfaces of the rigid bodies. Throws KeyError where one has none.
std::vector<BoundarySide> sides_on_surfaces(const FemModel& model)
{
  std::vector<BoundarySide> all;
  for (Index k = 0; k < model.contact_count(); ++k) {
    const std::vector<BoundarySide> sides = contact_sides(model.mesh, model.rigid_of(k).shape);
    if (sides.empty())
      throw KeyError(
          fmt::format("contact.{}: the mesh has no side on the surface of rigid.{}", model.model.contacts[k].name, model.rigid_of(k).name));
    all.insert(all.end(), sides.begin(), sides.end());
  }
  return all;
}

/// The contact points of these sides, each at the body that is nearest to it.
std::vector<FemContactPoint> contact_points_at(const FemModel& model, const std::vector<BoundarySide>& sides,
                                               const NodeField<Vec<2>>& position, const std::vector<bodies::Pose<2>>& poses)
{
  std::vector<FemContactPoint> points;
  for (Index k = 0; k < model.contact_count(); ++k)
    for (FemContactPoint& point :
         make_contact_points(sides, position, placed(model.rigid_of(k), poses[model.model.contacts[k].rigid]), model.model.mesh.metric)) {
      point.contact = k;
      if (nearest_surface(model, poses, position[point.node]).contact == k) points.push_back(point);
    }
  return points;
}

void make_contact(FemModel& model, const NodeField<Vec<2>>& was_at, const std::vector<bodies::Pose<2>>& poses)
{
  refuse_contacts(model);
  if (model.contact_count() == 0) return;
  const bool large = model.settings.large_deformation;
  model.contact_sides = large ? sides_within_reach(model, poses) : sides_on_surfaces(model);
  model.contact = contact_points_at(model, model.contact_sides, model.mesh.position, poses);
  model.interfaces.clear();
  for (Index k = 0; k < model.contact_count(); ++k) {
    const problem::Contact& contact = model.model.contacts[k];
    NodeField<char> is_here(model.mesh.node_count(), 0);
    Real length = 0;
    for (const FemContactPoint& point : model.contact) {
      if (point.contact != k) continue;
      is_here[point.node] = 1;
      length += section_of(model.model.mesh.metric, point.area, model.mesh.position[point.node]);
    }
    const auto sides = std::ranges::count_if(model.contact_sides, [&](const BoundarySide& side) { return is_here[side.middle] != 0; });
    const Real stiffness = contact_stiffness * stiffest_at_contact(model, was_at, k) * static_cast<Real>(sides);
    model.interfaces.push_back({0, 0, rules_of(contact.scheme).tied, length > 0 ? stiffness / length : 0, contact.tension});
  }
  set_adhesion(model, was_at);
}

/// Shape functions and depths of the points of all elements, and the weight of the soil.
void fill_shapes(const NodeField<Vec<2>>& was_at, FemModel& model)
{
  model.shape.assign(model.mesh.nodes.size());
  model.place.assign(model.mesh.nodes.size());
  model.density.assign(model.mesh.nodes.size());
  model.cell_size.assign(model.mesh.nodes.size(), 0);
  model.weight = 0;
  for (Index cell = 0; cell < model.mesh.nodes.size(); ++cell) {
    const AtSixNodes<Vec<2>> nodes = model.mesh.positions_of(cell);
    AtSixNodes<Vec<2>> first;
    for (int k = 0; k < 6; ++k) first[k] = was_at[model.mesh.nodes[cell][k]];
    for (int q = 0; q < triangle_points; ++q) {
      ShapeAtPoint& shape = model.shape[cell][q] = shape_at(nodes, q);
      model.cell_size[cell] += shape.area;
      if (!(shape.area > 0)) throw RunError(fmt::format("the curved element at ({}, {}) is inverted", nodes[0][0], nodes[0][1]));
      if (model.model.mesh.metric == mesh::Metric::axisymmetric) turn_around_axis(shape, position_of(shape, nodes));
      model.place[cell][q] = model.model.soil_place(position_of(shape, first));
      const settings::BodySoil& soil = model.soil_of(cell);
      model.density[cell][q] = density(soil.materials[soil.material_index_at(model.region_of(cell), model.place[cell][q])]);
    }
  }
  for (Real& size : model.cell_size) size = std::sqrt(size);
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    for (int q = 0; q < triangle_points; ++q)
      model.weight += model.shape[cell][q].area * model.density[cell][q] * model.model.gravity.norm();
}

/// Holds the nodes on the axis across it, those in the middle of sides too.
void hold_axis(FemModel& model)
{
  if (model.model.mesh.metric != mesh::Metric::axisymmetric) return;
  for (NodeField<std::uint8_t>& fixed : model.mesh.fixed)
    for (Index node = 0; node < model.mesh.node_count(); ++node)
      if (model.mesh.position[node][0] == 0) fixed[node] |= 1;
}

}  // namespace

FemInterface interface_at(const FemModel& model, std::size_t point, const FemState& begin)
{
  const FemContactPoint& at = model.contact[point];
  FemInterface interface = model.interfaces[at.contact];
  interface.friction = at.friction;
  interface.adhesion = at.adhesion * model.model.contacts[at.contact].adhesion_law.part_left(begin.contact[point].slip);
  if (model.flow.count > 0)
    for (const Index unknown : model.flow.at_contact[point])
      if (unknown != none) interface.pore_pressure += begin.displacement[unknown] / 2;
  return interface;
}

bodies::SurfacePoint<2> surface_now(const FemModel& model, Index contact, const bodies::Pose<2>& pose, const Vec<2>& x)
{
  const Index number = model.model.contacts[contact].rigid;
  const bodies::RigidBody<2>& rigid = model.model.rigid_bodies[number];
  const Matrix<2> turned = pose.orientation.matrix();
  const Vec<2> at_first = center_of<2>(rigid.shape) + turned.transpose() * (x - center_now(rigid, pose));
  bodies::SurfacePoint<2> surface = surface_at<2>(rigid.shape, at_first);
  if (!model.fillets.empty()) surface = with_fillets(model.fillets[static_cast<std::size_t>(number)], surface, at_first);
  surface.normal = turned * surface.normal;
  return surface;
}

NearestSurface nearest_surface(const FemModel& model, const std::vector<bodies::Pose<2>>& poses, const Vec<2>& x)
{
  NearestSurface nearest{{infinity, Vec<2>::Zero()}, none};
  for (Index k = 0; k < model.contact_count(); ++k)
    if (const bodies::SurfacePoint<2> surface = surface_now(model, k, poses[model.model.contacts[k].rigid], x);
        surface.distance < nearest.distance)
      nearest = {surface, k};
  return nearest;
}

std::vector<bodies::RigidShape<2>> shapes_in_contact(const FemModel& model, const FemState& state)
{
  std::vector<bodies::RigidShape<2>> shapes;
  for (Index k = 0; k < model.contact_count(); ++k)
    shapes.push_back(placed(model.rigid_of(k), state.state.rigid_bodies[model.model.contacts[k].rigid]));
  return shapes;
}

NodeField<Vec<2>> positions_with(const FemModel& model, const std::vector<Real>& displacement)
{
  NodeField<Vec<2>> positions = model.mesh.position;
  for (Index node = 0; node < positions.size(); ++node) positions[node] += Vec<2>(displacement[2 * node], displacement[2 * node + 1]);
  return positions;
}

void note_places(const FemModel& model, Moment moment, const std::vector<Real>& displacement, FemState& state)
{
  if (model.settings.large_deformation) state.place_at(moment) = positions_with(model, displacement);
}

void place_contact(FemModel& model, const FemState& state)
{
  const NodeField<Vec<2>> position = positions_with(model, state.displacement);
  NodeField<Real> area(model.mesh.node_count(), 0);
  for (const FemContactPoint& point : contact_points_at(model, model.contact_sides, position, poses_of(state)))
    area[point.node] = point.area;
  for (FemContactPoint& point : model.contact) {
    const bodies::RigidBody<2>& rigid = model.rigid_of(point.contact);
    const bodies::Pose<2>& pose = state.state.rigid_bodies[model.model.contacts[point.contact].rigid];
    point.area = area[point.node];
    point.arm = position[point.node] - center_now(rigid, pose);
    point.normal = surface_now(model, point.contact, pose, position[point.node]).normal;
  }
}

void fit_to_mesh(const settings::Case& c, const NodeField<Vec<2>>& was_at, const std::vector<bodies::Pose<2>>& poses, FemModel& model)
{
  hold_axis(model);
  make_contact(model, was_at, poses);
  model.loads.clear();
  for (std::size_t t = 0; t < c.traction.size(); ++t)
    model.loads.push_back(
        side_loads(model.mesh, model.mesh.loaded_sides[t], c.traction[t].first, c.traction[t].second, model.model.mesh.metric));
  fill_shapes(was_at, model);
  model.flow = {};
  make_flow(was_at, poses, model);
  number_unknowns(model);
}

}  // namespace berm::fem
