// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/cut_mesh_test.cpp
#include "bodies/initial_stress.hpp"
#include "fem/cut_mesh.hpp"
#include "fem/fem_problem.hpp"
#include "os/error.hpp"
#include "problem/initial_state.hpp"
#include "problem/stages.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::fem {
namespace {

/// Stiffness of the contact springs, relative to a layer of soil as thick as the elements at the body.
constexpr Real contact_stiffness = 100;

/// Near its limit the soil of a trial of the factor of safety settles slowly.
constexpr Real patience_of_trial = 10;

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

bool flows_non_associated(const problem::Model<2>& model)
{
  return std::any_of(model.bodies.begin(), model.bodies.end(), [](const problem::Body<2>& body) {
    return std::any_of(body.soil.materials.begin(), body.soil.materials.end(),
                       [](const auto& material) { return non_associated(material); });
  });
}

/// P-wave modulus of the stiffest soil that the surface of the rigid body meets, Pa; where regions have their own materials, the stiffest of all at these depths.
Real stiffest_at_contact(const FemModel& model, Index body)
{
  const settings::BodySoil& soil = model.model.bodies[body].soil;
  Real stiffest = 0;
  for (const FemContactPoint& point : model.contact) {
    const Real depth = model.model.soil_depth(model.mesh.position[point.node]);
    stiffest = std::max(stiffest, p_wave_modulus(soil.at("", depth)));
    for (const auto& [region, number] : soil.of_region) stiffest = std::max(stiffest, p_wave_modulus(soil.at(region, depth)));
  }
  return stiffest;
}

/// The friction of each contact point, and its adhesion before it slides: beside soil at rest at its depth.
void set_adhesion(FemModel& model, const problem::Contact& contact)
{
  model.adhesion_law = contact.adhesion_law;
  const settings::BodySoil& soil = model.model.bodies[contact.body].soil;
  const bool by_soil = !contact.adhesion_law.by_soil.empty();
  if ((contact.adhesion_law.factor > 0 || by_soil) && !soil.of_region.empty())
    throw KeyError(
        fmt::format("contact.{}.{}: finite elements find the soil beside the interface by its depth: give the soil by soil_layer "
                    "instead of region_material, or one friction and an adhesion in Pa",
                    contact.name, by_soil ? "soil" : "adhesion_factor"));
  for (FemContactPoint& point : model.contact) {
    const Real depth = model.model.soil_depth(model.mesh.position[point.node]);
    const material::Material there = soil.at("", depth);
    const Index number = soil.material_index_at("", depth);
    const std::vector<Real> undisturbed(static_cast<std::size_t>(state_size(there)), 0);
    point.adhesion = contact.adhesion_law.at(there, undisturbed.data(), 0, number);
    point.friction = by_soil ? contact.adhesion_law.by_soil[static_cast<std::size_t>(number)].friction : contact.friction;
  }
}

void make_contact(FemModel& model)
{
  for (const problem::Contact& contact : model.model.contacts) {
    if (contact.rigid == none)
      throw KeyError(fmt::format("contact.{}.other_body: the finite element method supports contact with a rigid body only", contact.name));
    if (model.rigid != none) throw KeyError(fmt::format("contact.{}: the finite element method supports one contact only", contact.name));
    model.rigid = contact.rigid;
    const bodies::RigidBody<2>& rigid = model.model.rigid_bodies[contact.rigid];
    const auto sides = contact_sides(model.mesh, rigid.shape);
    if (sides.empty()) throw KeyError(fmt::format("contact.{}: the mesh has no side on the surface of rigid.{}", contact.name, rigid.name));
    const mesh::Metric metric = model.model.mesh.metric;
    model.contact = make_contact_points(sides, model.mesh.position, rigid.shape, metric);
    Real length = 0;
    for (const FemContactPoint& point : model.contact) length += section_of(metric, point.area, model.mesh.position[point.node]);
    model.interface = {0, 0, rules_of(contact.scheme).tied,
                       contact_stiffness * stiffest_at_contact(model, contact.body) * static_cast<Real>(sides.size()) / length,
                       contact.tension};
    set_adhesion(model, contact);
  }
}

/// With gravity loading all soil gets its stress from it.
void refuse_without_k0(const settings::Case& c)
{
  const char* why = c.initial_state == settings::InitialState::gravity_loading ? "with initial_state = \"gravity_loading\""
                                                                               : "below ground that is not level";
  for (const auto& [name, body] : c.body)
    if (!body.has_k0()) throw KeyError(fmt::format("body.{}.k0: is missing: {} finite elements need k0 of all bodies", name, why));
}

/// Throws KeyError where a stage moves another body than the one that meets the soil.
void refuse_other_drives(const FemModel& model)
{
  for (std::size_t k = 0; k < model.model.stages.size(); ++k)
    if (model.model.driven[k] != none && model.model.driven[k] != model.rigid)
      throw KeyError(
          fmt::format("stage[{}].rigid: finite elements move the rigid body that a contact joins with the soil; rigid.{} has none", k,
                      model.model.rigid_bodies[model.model.driven[k]].name));
}

/// Shape functions, depths and first stresses at the points of all elements, and the weight of the soil.
void fill_points(const settings::Case& c, FemModel& model, FemState& state)
{
  const Real gravity = -model.model.gravity[1];
  model.shape.assign(model.mesh.nodes.size());
  model.depth.assign(model.mesh.nodes.size());
  model.density.assign(model.mesh.nodes.size());
  model.cell_size.assign(model.mesh.nodes.size());
  state.points.assign(model.mesh.nodes.size());
  for (Index cell = 0; cell < model.mesh.nodes.size(); ++cell) {
    const AtSixNodes<Vec<2>> nodes = model.mesh.positions_of(cell);
    const Index body = model.mesh.body[cell];
    for (int q = 0; q < triangle_points; ++q) {
      const ShapeAtPoint& shape = model.shape[cell][q] = shape_at(nodes, q);
      model.cell_size[cell] += shape.area;
      if (!(shape.area > 0)) throw RunError(fmt::format("the curved element at ({}, {}) is inverted", nodes[0][0], nodes[0][1]));
      Vec<2> x = Vec<2>::Zero();
      for (int k = 0; k < 6; ++k) x += shape.value[k] * nodes[k];
      if (model.model.mesh.metric == mesh::Metric::axisymmetric) {
        model.shape[cell][q].per_radius = 1 / x[0];
        model.shape[cell][q].area *= x[0];
      }
      model.depth[cell][q] = model.model.soil_depth(x);
      const settings::BodySoil& soil = model.soil_of(cell);
      model.density[cell][q] = density(soil.materials[soil.material_index_at(model.region_of(cell), model.depth[cell][q])]);
      refuse_no_strength(soil, model.region_of(cell), model.depth[cell][q], model.model.bodies[body].name);
      state.points[cell][q].stress =
          soil.layers.empty()
              ? bodies::initial_stress<2>(c.body[body].second, model.density[cell][q] * gravity, model.depth[cell][q])
              : bodies::stress_at_rest<2>(c.body[body].second, soil.mass_above("", std::max(Real(0), model.depth[cell][q])) * gravity,
                                          model.depth[cell][q]);
    }
  }
  for (Real& size : model.cell_size) size = std::sqrt(size);
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    for (int q = 0; q < triangle_points; ++q)
      model.weight += model.shape[cell][q].area * model.density[cell][q] * model.model.gravity.norm();
}

/// Gives the state variables of their law to points that have their stress.
void set_law_state(const FemModel& model, FemState& state)
{
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    for (int q = 0; q < triangle_points; ++q) {
      SoilPoint& point = state.points[cell][q];
      SymTensor<3> stress;
      std::copy_n(point.stress.c, tensor_size<2>, stress.c);
      initial_state(model.soil_at(cell, q), stress, point.law_state.data());
    }
}

/// Width of the rigid body, m; of a half plane that of the soil it meets.
Real width_at_contact(const FemModel& model)
{
  const Real width = width_of<2>(model.model.rigid_bodies[model.rigid].shape);
  if (std::isfinite(width)) return width;
  Real first = infinity, last = -infinity;
  for (const FemContactPoint& point : model.contact) {
    const Real along = model.mesh.position[point.node].dot(Vec<2>(-point.normal[1], point.normal[0]));
    first = std::min(first, along);
    last = std::max(last, along);
  }
  return last - first;
}

/// Holds the nodes on the axis across it, those in the middle of sides too.
void hold_axis(FemModel& model)
{
  if (model.model.mesh.metric != mesh::Metric::axisymmetric) return;
  for (NodeField<std::uint8_t>& fixed : model.mesh.fixed)
    for (Index node = 0; node < model.mesh.node_count(); ++node)
      if (model.mesh.position[node][0] == 0) fixed[node] |= 1;
}

/// Finite elements are in equilibrium from their start: a stage that waits for it is one increment.
void end_at_once(std::vector<settings::StageSettings>& stages)
{
  constexpr Real one_increment = 1e-3;
  for (settings::StageSettings& stage : stages)
    if (ends_at_equilibrium(stage) && !stage.until.time) stage.until.time = one_increment;
}

}  // namespace

FemInterface interface_at(const FemModel& model, std::size_t point, const FemState& begin)
{
  FemInterface interface = model.interface;
  interface.friction = model.contact[point].friction;
  interface.adhesion = model.contact[point].adhesion * model.adhesion_law.part_left(begin.contact[point].slip);
  if (model.flow.count > 0)
    for (const Index unknown : model.flow.at_contact[point])
      if (unknown != none) interface.pore_pressure += begin.displacement[unknown] / 2;
  return interface;
}

FemProblem build_fem(const settings::Case& c, const std::string& case_folder, const std::string& work_folder)
{
  FemProblem problem;
  FemModel& model = problem.model;
  FemState& state = problem.state;
  for (const auto& [name, rigid] : c.rigid)
    if (rigid.motion == bodies::Motion::free)
      throw KeyError(fmt::format("rigid.{}.motion: in the finite element method stages move a rigid body; it cannot be \"free\"", name));
  model.model = problem::make_model(c, make_cut_mesh(c, case_folder, work_folder));
  const bool by_gravity = loads_by_gravity(c, model.model.ground);
  if (!by_gravity) refuse_k0_below_uneven_ground(c, model.model);
  if (by_gravity) refuse_without_k0(c);
  model.settings = c.fem;
  if (c.safety) model.patience = patience_of_trial;
  model.non_associated = flows_non_associated(model.model);
  std::vector<bodies::RigidShape<2>> shapes;
  for (const bodies::RigidBody<2>& rigid : model.model.rigid_bodies) shapes.push_back(rigid.shape);
  model.mesh = make_quadratic(model.model.mesh, c, shapes);
  hold_axis(model);
  make_contact(model);
  model.model.main_rigid = model.rigid;
  for (std::size_t t = 0; t < c.traction.size(); ++t)
    model.loads.push_back(
        side_loads(model.mesh, model.mesh.loaded_sides[t], c.traction[t].first, c.traction[t].second, model.model.mesh.metric));
  refuse_other_drives(model);
  fill_points(c, model, state);
  if (model.rigid != none) model.width = width_at_contact(model);
  make_flow(model);
  number_unknowns(model);
  if (by_gravity) load_by_gravity(c, model, state);
  set_law_state(model, state);
  for (const auto& [name, watch] : c.watch)
    model.watches.push_back(make_watch(model.mesh, name, {watch.point[0], watch.point[1]}, index_of(c.body, watch.body)));
  state.displacement.assign(model.unknowns(), 0.);
  state.contact.resize(model.contact.size());
  state.support_forces.assign(model.model.conditions.reported.size(), Vec<2>::Zero());
  state.state.tractions.resize(model.model.tractions.size());
  state.state.heads.resize(count_of<boundary::Head<2>>(model.model.conditions));
  state.state.rigid_bodies.resize(model.model.rigid_bodies.size());
  end_at_once(model.model.stages);
  begin_stage(model.model, state.state);
  return problem;
}

}  // namespace berm::fem
