// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/fill.hpp"
#include "core/names.hpp"
#include "mesh/critical_length.hpp"
#include "os/error.hpp"
#include "problem/absorbing.hpp"
#include "problem/equilibrium.hpp"
#include "problem/heads.hpp"
#include "problem/initial_state.hpp"
#include "problem/motions.hpp"
#include "problem/stages.hpp"
#include "problem/supports.hpp"
#include "problem/symmetry.hpp"
#include "settings/interface.hpp"
#include "settings/symmetry.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::problem {
namespace {

/// A node takes the largest damping of the regions that its cells belong to, so that a damping layer acts up to its border.
template <int dim>
NodeField<Real> nodal_damping(const mesh::Mesh<dim>& mesh, const std::string& name, const bodies::BodySettings& body)
{
  std::vector<Real> of_region(mesh.region_names.size(), body.damping);
  for (const auto& [region, damping] : body.region_damping) of_region[bodies::filled_region(mesh, name, region)] = damping;
  auto damping = NodeField<Real>::zeros(mesh.node_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (Index node : mesh.nodes[cell])
      if (const Real here = of_region[mesh.region[cell]]; here > damping[node]) damping[node] = here;
  return damping;
}

/// Load points of all tractions, where they lie at the start.
template <int dim>
void place_loads(const settings::Case& c, Problem<dim>& problem)
{
  Model<dim>& model = problem.model;
  const std::vector<Index> body_of = bodies_of_regions(model.mesh, c);
  for (Index t = 0; t < static_cast<Index>(c.traction.size()); ++t)
    for (const boundary::LoadedPoint<dim>& point : loaded_points(model.mesh, c.traction[t].first, c.traction[t].second, body_of)) {
      model.load_points.push_back({t, body_of[model.mesh.region[point.cell]], point.force, point.area});
      problem.state.load_points.push_back({point.x, point.cell});
    }
}

/// What a particle at x gets of a soil that varies.
template <int dim>
bodies::SoilAtPoint soil_at(const Model<dim>& model, const Body<dim>& body, Index cell, const Vec<dim>& x)
{
  const std::string& region = model.mesh.region_names[model.mesh.region[cell]];
  const settings::SoilPlace place = model.soil_place(x);
  const Real depth = place.depth, gravity = -model.axes.sign * model.gravity[model.axes.up];
  refuse_no_strength(body.soil, region, depth, body.name);
  return {inertia_density(body.soil.at(region, place)), gravity * body.soil.mass_above(region, place), depth,
          local_values(body.soil, region, place)};
}

/// Draws the random fields of a body over the whole mesh.
template <int dim>
void draw_random_fields(const Model<dim>& model, settings::BodySoil& soil)
{
  if (soil.fields.empty()) return;
  settings::SoilPlace lower{infinity, 0, infinity}, upper{-infinity, 0, -infinity};
  for (const Vec<dim>& x : model.mesh.position) {
    const settings::SoilPlace place = model.soil_place(x);
    lower = {std::min(lower.x, place.x), 0, std::min(lower.z, place.z)};
    upper = {std::max(upper.x, place.x), std::max(upper.depth, place.depth), std::max(upper.z, place.z)};
  }
  make_random_fields(soil, lower, upper);
}

/// Over the particles where they are at the start, means by their volume.
template <int dim>
settings::SoilWaves waves_in(const Model<dim>& model, const Body<dim>& body, const bodies::Particles<dim>& particles)
{
  settings::SoilWaves all;
  const auto widen = [&all](const settings::SoilWaves& soil) {
    all.fastest = std::max(all.fastest, soil.fastest);
    all.slowest = std::min(all.slowest, soil.slowest);
    all.min_density = std::min(all.min_density, soil.min_density);
    all.bulk = std::max(all.bulk, soil.bulk);
    all.shear = std::max(all.shear, soil.shear);
  };
  Real volume = 0;
  particles.visit([&](Index cell, Index b, int l) {
    const bodies::Particle<dim> p = particles.read(b, l);
    const settings::SoilWaves here =
        settings::waves_of(body.soil.at(model.mesh.region_names[model.mesh.region[cell]], model.soil_place(p.x)));
    widen(here);
    all.mean_speed += p.volume * here.mean_speed;
    all.mean_density += p.volume * here.mean_density;
    all.mean_impedance += p.volume * here.mean_impedance;
    volume += p.volume;
  });
  constexpr int depths = 20;  // of a fill that is looked at from its top to its base
  for (const Earthwork<dim>& work : model.earthworks)
    for (int k = 0; work.fills && &model.bodies[work.body] == &body && k <= depths; ++k) {
      widen(settings::waves_of(body.soil.in_fill(work.material, (work.top - work.bottom) * k / depths)));
    }
  for (Real* mean : {&all.mean_speed, &all.mean_density, &all.mean_impedance}) *mean /= volume;
  return all;
}

/// Gives the state variables of their law to particles that have their stress.
template <int dim>
void set_law_state(const Model<dim>& model, const settings::BodySoil& soil, bodies::Particles<dim>& particles)
{
  const int size = state_size(soil.materials.front());
  if (size == 0) return;
  const bool own = varies(soil);
  particles.visit([&](Index cell, Index b, int l) {
    const bodies::Particle<dim> p = particles.read(b, l);
    SymTensor<3> stress;
    std::copy_n(p.stress.c, tensor_size<dim>, stress.c);
    std::array<Real, material::max_state> state{};
    if (own)
      initial_state(soil.at(model.mesh.region_names[model.mesh.region[cell]], model.soil_place(p.x)), stress, state.data());
    else
      initial_state(soil.materials.front(), stress, state.data());
    for (int k = 0; k < size; ++k) particles.state(b)[k][l] = state[k];
  });
}

template <int dim>
std::int32_t nearest_particle(const bodies::Particles<dim>& particles, const std::vector<Real>& point)
{
  std::int32_t nearest = none;
  Real min = infinity;
  particles.visit([&](Index, Index b, int l) {
    Real square = 0;
    for (int d = 0; d < dim; ++d) square += std::pow(particles.block(b).x[d][l] - point[d], 2);
    if (square < min) min = square, nearest = particles.block(b).id[l];
  });
  return nearest;
}

/// The time over which laws average the strain rate, s: that of a travel of a hundredth of the driven body's width at the fastest of its drives, so that
/// vibration is no rate. 0 where nothing of a width moves by a velocity.
template <int dim>
Real rate_smoothing(const Model<dim>& model)
{
  constexpr Real fraction_of_width = 0.01;
  Real time = infinity;
  for (std::size_t k = 0; k < model.stages.size(); ++k) {
    const Real speed = speed_of(model.stages[k]);
    if (model.driven[k] == none || !(speed > 0)) continue;
    if (const Real width = width_of(model.rigid_bodies[model.driven[k]].shape); width > 0 && width < infinity)
      time = std::min(time, fraction_of_width * width / speed);
  }
  return time < infinity ? time : 0;
}

/// Of a rigid body with so many. Throws KeyError where it is not in the soil.
template <int dim>
DepthSlices depth_slices_of(int count, const Model<dim>& model, const bodies::RigidBody<dim>& rigid)
{
  if (count == 0) return {};
  const Vec<dim> center = center_of<dim>(rigid.shape);
  const Real bed = model.axes.sign * model.surface_at(center), depth = bed - bodies::lowest_level<dim>(rigid.shape, model.axes.up_vector());
  if (!(depth > 0 && std::isfinite(depth)))
    throw KeyError(
        fmt::format("rigid.{}.depth_slices: the body is not in the soil at the start, so there is no height to be sliced", rigid.name));
  return {count, bed - model.axes.height(center), depth / count};
}

/// A sum of zero for each owner.
template <int dim>
void open_ledger(const Model<dim>& model, Ledger<dim>& ledger)
{
  ledger.contact_sums.resize(model.rigid_bodies.size());
  for_each_row(rows_of_others<dim>, [&](const auto& row) {
    auto& sums = ledger.*row.member;
    if constexpr (std::is_same_v<decltype(sums), std::vector<std::vector<Real>>&>)
      for (const DepthSlices& slices : model.depth_slices) sums.emplace_back(slices.count, 0);
    else
      sums.assign(row.owner == Owner::contact         ? model.contacts.size()
                  : row.owner == Owner::rigid_contact ? model.rigid_contacts.size()
                                                      : model.conditions.reported.size(),
                  Vec<dim>::Zero());
  });
}

}  // namespace

template <int dim>
Model<dim> make_model(const settings::Case& of_whole, mesh::Mesh<dim> mesh)
{
  const settings::Case c = part_of_whole(of_whole);
  Model<dim> model;
  model.mesh = std::move(mesh);
  measure_around_axis(c, model.mesh);
  model.gravity = Vec<dim>::Zero();
  for (int d = 0; d < dim && !c.gravity.empty(); ++d) model.gravity[d] = c.gravity[d];
  model.axes = axes_of<dim>(model.gravity);
  model.gravity_ramp = c.gravity_ramp;
  model.surface = c.surface;
  model.ground = ground_of(c);
  model.mpm = c.mpm;
  const settings::SupportSets sets = support_sets(c);
  model.stages = c.stage;
  add_supports(c, sets, model);
  hold_axis(model);
  model.parts = parts_of(c);
  hold_symmetry_planes(c, model);
  add_motions(c, model);

  for (const auto& [name, settings] : c.rigid) {
    const bodies::RigidShape<dim> shape = make_shape<dim>(settings.shape);
    const Vec<3> own = settings.mass * inertia_over_mass<dim>(shape);
    bodies::Angular<dim> inertia;
    if constexpr (dim == 2)
      inertia = settings.moment_of_inertia.value_or(own[2]);
    else
      inertia = settings.moment_of_inertia ? Vec<3>(Vec<3>::Constant(*settings.moment_of_inertia)) : own;
    model.rigid_bodies.push_back({name, shape, settings.mass, settings.motion, settings.rotation, inertia, axes_of<dim>(shape)});
    if (!settings.velocity.empty()) model.rigid_bodies.back().first_velocity = bodies::to_vec<dim>(settings.velocity);
  }
  add_rigid_contacts(c, model);
  refuse_off_symmetry_planes(model);
  if constexpr (dim == 2) {
    std::vector<bodies::RigidShape<2>> shapes;
    for (const bodies::RigidBody<2>& rigid : model.rigid_bodies) shapes.push_back(rigid.shape);
    model.ground = ground_in(c, model.mesh, shapes);
  }
  for (std::size_t r = 0; r < model.rigid_bodies.size(); ++r)
    model.depth_slices.push_back(depth_slices_of(c.rigid[r].second.depth_slices, model, model.rigid_bodies[r]));
  for (const auto& [name, settings] : c.body) {
    settings::BodySoil soil = soil_of(c, settings);
    draw_random_fields(model, soil);
    const material::Material& first = soil.materials.front();
    model.bodies.push_back({name, soil, nodal_damping(model.mesh, name, settings), density(first) / inertia_density(first)});
  }
  add_heads(c, model);
  add_dashpots(c, sets, model);
  make_tables(model.mesh.node_count(), std::max<std::size_t>(1, c.stage.size()), model.water_flows(), model.conditions);
  for (const auto& [name, s] : c.contact) {
    const Index body = index_of(c.body, s.body);
    const contact::Detection best = s.rigid.empty() ? contact::Detection::gap : contact::Detection::particle;
    Real friction = s.friction_angle;
    for (const contact::SoilInterfaceSettings& beside : s.soil) friction = std::max(friction, beside.friction_angle);
    model.contacts.push_back({name, body, index_of(c.rigid, s.rigid), index_of(c.body, s.other_body), std::tan(friction), s.adhesion,
                              s.scheme, s.detection == contact::Detection::automatic ? best : s.detection, s.gap_closing_steps, s.tension,
                              adhesion_law(s, model.bodies[body].soil), memory_of(c, static_cast<Index>(model.contacts.size())),
                              friction > 0 && !s.drained ? pore_pressure_index(model.bodies[body].soil.materials.front()) : none, s.drained,
                              s.particle_rim});
  }
  for (const auto& [name, s] : c.traction) {
    model.tractions.push_back({name, s.ramp, {}});
    for (const settings::StageSettings& stage : c.stage) model.tractions.back().acts.push_back(acts_in(s.stages, stage.name));
  }
  model.update_stress_first = !c.contact.empty() && rules_of(c.contact.front().second.scheme).stress_first;
  model.main_rigid = main_rigid(c);
  for (const settings::StageSettings& stage : c.stage) {
    model.driven.push_back(!drives(stage.kind) ? none : stage.rigid.empty() ? 0 : index_of(c.rigid, stage.rigid));
  }
  if (c.method == settings::Method::mpm)
    for (Body<dim>& body : model.bodies)
      for (material::Material& material : body.soil.materials) material = with_rate_smoothing(material, rate_smoothing(model));
  return model;
}

/// Where the time step without mpm.courant is by the whole mesh: of soil that can yield, with the filter that takes out what the nodes cannot carry. Elastic bodies have no filter and
/// shake before the mesh does, and so does soil whose stress is updated first; water that flows has waves of its own. A line feels its soil one step late.
template <int dim>
void set_critical_lengths(const settings::Case& c, Model<dim>& model)
{
  if (c.pipeline || model.update_stress_first || model.mpm.velocity_filter == 0) return;
  for (Body<dim>& body : model.bodies) {
    const std::vector<material::Material>& materials = body.soil.materials;
    if (body.flows() || !std::all_of(materials.begin(), materials.end(), [](const material::Material& m) { return yields(m); })) continue;
    Real shear_ratio = 0;
    for (const material::Material& material : materials)
      shear_ratio = std::max(shear_ratio, elasticity(material).shear / p_wave_modulus(material));
    body.critical_length = critical_length(model.mesh, model.patches, shear_ratio);
  }
}

template <int dim>
Problem<dim> build(const settings::Case& c, const std::string& case_folder, const std::string& work_folder)
{
  return build(c, make_mesh<dim>(c.mesh, case_folder, work_folder));
}

template <int dim>
Problem<dim> build(const settings::Case& c, mesh::Mesh<dim> mesh)
{
  Problem<dim> problem;
  Model<dim>& model = problem.model;
  State<dim>& state = problem.state;
  model = make_model(c, std::move(mesh));
  model.patches = make_patches(model.mesh, model.mpm.volumetric_projection ? mesh::patch_cells<dim> : 1);
  set_critical_lengths(c, model);
  set_fading(model);
  state.rigid_bodies.resize(model.rigid_bodies.size());
  open_ledger(model, state.ledger);
  state.listed_poses.assign(model.rigid_bodies.size(), bodies::Pose<dim>::nowhere());
  const bool by_gravity = loads_by_gravity(c, model.ground);
  if (!by_gravity) refuse_k0_below_uneven_ground(c, model);
  for (const auto& [name, settings] : c.body) {
    Body<dim>& body = model.bodies[state.particles.size()];
    const material::Material& material = body.soil.materials.front();
    const Real inertia = inertia_density(material);
    bodies::StartState<dim> start{inertia, -model.axes.sign * model.gravity[model.axes.up] * density(material) / inertia, c.surface,
                                  particle_extra(body.soil)};
    start.first_local = state_size(material);
    for (const FieldInfo& field : memory_fields(c, name)) start.extra.push_back(field);
    const auto number = static_cast<Index>(state.particles.size());
    add_earthworks(settings, number, model);
    start.room = room_for_fills(model, number);
    if (varies(body.soil)) start.soil_at = [&](Index cell, const Vec<dim>& x) { return soil_at(model, body, cell, x); };
    for (const auto& entry : c.contact)
      if (entry.second.body == name && !entry.second.rigid.empty())
        start.holes.push_back(model.rigid_bodies[index_of(c.rigid, entry.second.rigid)].shape);
    state.particles.push_back(fill(model.mesh, name, settings, start));
    state.flux.push_back(NodeField<Vec<dim>>::zeros(body.flows() ? model.mesh.node_count() : 0));
    state.pressure_sums.push_back(CellField<Real>::zeros(body.flows() ? model.mesh.cell_count() : 0));
    for (const Contact& contact : model.contacts)
      if (contact.memory.bond != none && model.bodies[contact.body].name == name)
        bond_at_start(model.mesh.metric, state.particles.back(), model.rigid_bodies[contact.rigid].shape, contact.memory.bond);
    if (varies(body.soil)) body.waves = waves_in(model, body, state.particles.back());
    state.held_forces.push_back(NodeField<Vec<dim>>::zeros(model.conditions.absorbs(number) ? model.mesh.node_count() : 0));
    state.numbered.push_back(state.particles.back().size());
    if (state.particles.back().size() == 0)
      throw KeyError(
          fmt::format("body.{}: has no particles: all cells of its regions lie within the rigid bodies; check their position and size, "
                      "or fill other regions",
                      name));
    state.particles.back().visit([&](Index, Index b, int l) {
      const bodies::Block<dim>& p = state.particles.back().block(b);
      for (int d = 0; d < dim; ++d) state.ledger.totals.first_momentum[d] += p.mass[l] * p.v[d][l];
    });
  }
  if (by_gravity) load_by_gravity(c, model, state.particles);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) set_law_state(model, model.bodies[b].soil, state.particles[b]);
  limit_equilibrium(c, model, state.particles);
  model.pressure_window = 2 * longest_pressure_period(model, state.particles);
  state.earthworks.resize(model.earthworks.size());
  state.tractions.resize(model.tractions.size());
  state.heads.resize(count_of<boundary::Head<dim>>(model.conditions));
  place_loads(c, problem);
  for (const auto& [name, watch] : c.watch) {
    const Index body = index_of(c.body, watch.body);
    model.watches.push_back({name, body, nearest_particle(state.particles[body], watch.point)});
  }
  begin_stage(model, state);
  return problem;
}

template Model<2> make_model(const settings::Case&, mesh::Mesh<2>);
template Model<3> make_model(const settings::Case&, mesh::Mesh<3>);
template Problem<2> build(const settings::Case&, mesh::Mesh<2>);
template Problem<3> build(const settings::Case&, mesh::Mesh<3>);
template Problem<2> build(const settings::Case&, const std::string&, const std::string&);
template Problem<3> build(const settings::Case&, const std::string&, const std::string&);

}  // namespace berm::problem
