// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/cut_mesh_test.cpp
#include "bodies/initial_stress.hpp"
#include "bodies/rigid/rounding.hpp"
#include "fem/cut_mesh.hpp"
#include "fem/fem_problem.hpp"
#include "fem/point_law.hpp"
#include "material/laws.hpp"
#include "os/error.hpp"
#include "problem/initial_state.hpp"
#include "problem/stages.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::fem {
namespace {

/// Near its limit the soil of a trial of the factor of safety settles slowly.
constexpr Real patience_of_trial = 10;

bool flows_non_associated(const problem::Model<2>& model)
{
  return std::any_of(model.bodies.begin(), model.bodies.end(), [](const problem::Body<2>& body) {
    return std::any_of(body.soil.materials.begin(), body.soil.materials.end(),
                       [](const auto& material) { return non_associated(material); });
  });
}

/// Whether the matrix of some soil is unsymmetric.
bool is_unsymmetric(const problem::Model<2>& model)
{
  return std::any_of(model.bodies.begin(), model.bodies.end(), [](const problem::Body<2>& body) {
    return std::any_of(body.soil.materials.begin(), body.soil.materials.end(), [](const material::Material& soil) {
      return material::visit([](const auto& law) { return has_unsymmetric_tangent<decltype(prepare(law))>(); }, soil);
    });
  });
}

/// With gravity loading all soil gets its stress from it.
void refuse_without_k0(const settings::Case& c)
{
  const char* why = c.initial_state == settings::InitialState::gravity_loading ? "with initial_state = \"gravity_loading\""
                                                                               : "below ground that is not level";
  for (const auto& [name, body] : c.body)
    if (!body.has_k0()) throw KeyError(fmt::format("body.{}.k0: is missing: {} finite elements need k0 of all bodies", name, why));
}

/// Throws KeyError where a stage moves a body that does not meet the soil.
void refuse_other_drives(const FemModel& model)
{
  for (std::size_t k = 0; k < model.model.stages.size(); ++k)
    if (model.model.driven[k] != none && model.contact_of(model.model.driven[k]) == none)
      throw KeyError(fmt::format("stage[{}].rigid: finite elements move rigid bodies that a contact joins with the soil; rigid.{} has none",
                                 k, model.model.rigid_bodies[model.model.driven[k]].name));
}

/// The first stress at the points of all elements, from k0.
void set_first_stress(const settings::Case& c, const FemModel& model, FemState& state)
{
  const Real gravity = -model.model.gravity[1];
  state.points.assign(model.mesh.nodes.size());
  for (Index cell = 0; cell < model.mesh.nodes.size(); ++cell)
    for (int q = 0; q < triangle_points; ++q) {
      const Index body = model.mesh.body[cell];
      const settings::BodySoil& soil = model.soil_of(cell);
      const settings::SoilPlace& place = model.place[cell][q];
      refuse_no_strength(soil, model.region_of(cell), place.depth, model.model.bodies[body].name);
      state.points[cell][q].stress =
          bodies::stress_at_rest<2>(c.body[body].second, gravity * soil.mass_above(model.region_of(cell), place), place.depth);
    }
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

/// Width of the rigid body of a contact, m; of a half plane that of the soil it meets.
Real width_at_contact(const FemModel& model, Index contact)
{
  const Real width = width_of<2>(model.rigid_of(contact).shape);
  if (std::isfinite(width)) return width;
  Real first = infinity, last = -infinity;
  for (const FemContactPoint& point : model.contact) {
    if (point.contact != contact) continue;
    const Real along = model.mesh.position[point.node].dot(Vec<2>(-point.normal[1], point.normal[0]));
    first = std::min(first, along);
    last = std::max(last, along);
  }
  return last - first;
}

/// Finite elements are in equilibrium from their start: a stage that waits for it is one increment.
void end_at_once(std::vector<settings::StageSettings>& stages)
{
  constexpr Real one_increment = 1e-3;
  for (settings::StageSettings& stage : stages)
    if (ends_at_equilibrium(stage) && !stage.until.time) stage.until.time = one_increment;
}

/// Soil goes around a corner of the body where that is an arc, which the sides of elements there can follow, in increments that are shorter than it; and past a re-entrant one where the normal does not jump.
void round_corners(const settings::Case& c, FemModel& model)
{
  constexpr Real radius = 0.25, re_entrant = 0.5;  // of the elements at the contact
  constexpr Real part_of_arc = 0.5;                // longest travel in an increment, over the radius
  const Real size = contact_size_of(c);
  if (!(size > 0)) return;
  for (bodies::RigidBody<2>& rigid : model.model.rigid_bodies) {
    rigid.shape = bodies::rounded(rigid.shape, radius * size);
    model.fillets.push_back(bodies::fillets_of(rigid.shape, re_entrant * size));
    if (const auto* profile = std::get_if<bodies::Profile<2>>(&rigid.shape))
      model.settings.largest_step = std::min(model.settings.largest_step, part_of_arc * profile->radius / width_of<2>(rigid.shape));
  }
}

/// Puts nodes that lie in a fillet onto it: the mesh was cut along the sharp corner.
void leave_fillets(FemModel& model)
{
  if (std::ranges::all_of(model.fillets, [](const auto& of_body) { return of_body.empty(); })) return;
  const std::vector<bodies::Pose<2>> poses(model.model.rigid_bodies.size());
  for (const BoundarySide& side : model.mesh.boundary_sides)
    for (const Index node : {side.from, side.middle, side.to}) {
      Vec<2>& x = model.mesh.position[node];
      const bool on_axis = model.model.mesh.metric == mesh::Metric::axisymmetric && x[0] == 0;
      if (const NearestSurface surface = nearest_surface(model, poses, x); surface.distance < 0) x -= surface.distance * surface.normal;
      if (on_axis) x[0] = 0;
    }
}

/// Where the soil is, and what of the ground no rigid body touches.
void begin_large_deformation(FemModel& model, FemState& state)
{
  state.was_at.fill(model.mesh.position);
  state.meshed_at = poses_of(state);
  for (std::size_t k = 0; k < state.contact.size(); ++k) {
    FemContactState& point = state.contact[k];
    point.gap = nearest_surface(model, state.meshed_at, model.mesh.position[model.contact[k].node]).distance;
    if (point.gap > 1e-9 * width_of<2>(model.rigid_of(model.contact[k].contact).shape)) point.parted = 1;
  }
  place_contact(model, state);
}

}  // namespace

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
  if (c.fem.large_deformation) round_corners(c, model);
  if (c.safety) model.patience = patience_of_trial;
  model.non_associated = flows_non_associated(model.model);
  model.unsymmetric = is_unsymmetric(model.model);
  std::vector<bodies::RigidShape<2>> shapes;
  for (const bodies::RigidBody<2>& rigid : model.model.rigid_bodies) shapes.push_back(rigid.shape);
  model.mesh = make_quadratic(model.model.mesh, c, shapes);
  state.state.rigid_bodies.resize(model.model.rigid_bodies.size());
  leave_fillets(model);
  fit_to_mesh(c, model.mesh.position, poses_of(state), model);
  refuse_other_drives(model);
  if (model.contact_count() == 0)
    model.model.main_rigid = none;
  else if (model.contact_of(model.model.main_rigid) == none)
    model.model.main_rigid = model.model.contacts.front().rigid;
  for (Index k = 0; k < model.contact_count(); ++k)
    model.width = k == 0 ? width_at_contact(model, k) : std::min(model.width, width_at_contact(model, k));
  set_first_stress(c, model, state);
  if (by_gravity) load_by_gravity(c, model, state);
  set_law_state(model, state);
  for (const auto& [name, watch] : c.watch)
    model.watches.push_back(make_watch(model.mesh, name, {watch.point[0], watch.point[1]}, index_of(c.body, watch.body)));
  state.displacement.assign(model.unknowns(), 0.);
  state.contact.resize(model.contact.size());
  if (model.settings.large_deformation) begin_large_deformation(model, state);
  state.support_forces.assign(model.model.conditions.reported.size(), Vec<2>::Zero());
  state.state.tractions.resize(model.model.tractions.size());
  state.state.heads.resize(count_of<boundary::Head<2>>(model.model.conditions));
  end_at_once(model.model.stages);
  begin_stage(model.model, state.state);
  return problem;
}

}  // namespace berm::fem
