// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_test.cpp
#include "simulation/mpm_recorder.hpp"

#include "mpm/condition.hpp"
#include "mpm/interface.hpp"
#include "mpm/time_step.hpp"
#include "os/error.hpp"
#include "problem/archive_state.hpp"
#include "problem/heads.hpp"
#include "problem/stages.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace berm::simulation {

namespace {

/// m2/s per metre run, or m3/s.
struct Inflow {
  Real sum = 0;

  Inflow& operator+=(const Inflow& other)
  {
    sum += other.sum;
    return *this;
  }
};

/// What the stress of all particles has stored if they are elastic, J/m or J: V ((1 + nu) s : s - nu (tr s)^2) / 2 E. Of a law whose elasticity depends on the stress, by its elasticity at none.
template <int dim>
Real elastic_energy(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  std::vector<Real> own(1, 0.), of_all;
  for (std::size_t body = 0; body < state.particles.size(); ++body) {
    const bodies::Particles<dim>& particles = state.particles[body];
    particles.visit([&](Index, Index b, int l) {
      const bodies::Particle<dim> p = particles.read(b, l);
      const material::YoungPoisson elastic = young_poisson(material_of(model.bodies[body].soil, p.extra));
      const Real all = trace(p.stress),
                 energy = ((1 + elastic.poisson_ratio) * double_dot(p.stress, p.stress) - elastic.poisson_ratio * all * all) / 2;
      if (elastic.young_modulus > 0) own.front() += p.volume * energy / elastic.young_modulus;
    });
  }
  Ranks::of_run().gather(own, of_all);
  return std::accumulate(of_all.begin(), of_all.end(), Real(0));
}

}  // namespace

template <int dim>
MpmRecorder<dim>::MpmRecorder(const settings::Case& c, const problem::Model<dim>& model, const problem::State<dim>& start)
    : Recorder<dim>(model),
      last_time_(start.time),
      last_(start.ledger)
{
  row_.count_parts(model.parts);
  for (const bodies::Particles<dim>& particles : start.particles) {
    const mpm::BodySums<dim> sums = mpm::sums_over(particles);
    first_centers_.push_back(sums.center());
    first_kinetic_ += sums.kinetic;
  }
  // Of soil that nothing drives the work is what is left over of its own stress, next to nothing in a bed at rest.
  if (std::none_of(model.stages.begin(), model.stages.end(), [](const settings::StageSettings& stage) { return drives(stage.kind); }))
    first_elastic_ = elastic_energy(model, start);
  first_loaded_ = start.load_points;
  boundary::for_each_of<boundary::Head<dim>>(
      model.conditions, [&](std::size_t, const auto& row, const auto&) { head_areas_.push_back(areas_of_head(c, model, row)); });
  for (std::size_t k = 0; k < model.watches.size(); ++k)
    watch_points_.emplace_back(model, start.particles[model.watches[k].body], model.watches[k], c.watch[k].second.point);
  watch_zeros_.assign(watch_points_.size(), Vec<dim>::Zero());
}

template <int dim>
void MpmRecorder<dim>::zero_displacements(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  Recorder<dim>::zero_rigid_bodies(state);
  for (std::size_t b = 0; b < first_centers_.size(); ++b) first_centers_[b] = mpm::sums_over(state.particles[b]).center();
  first_loaded_ = state.load_points;
  for (std::size_t k = 0; k < watch_zeros_.size(); ++k)
    watch_zeros_[k] = watch_points_[k].read(model, state.particles[model.watches[k].body]).displacement;
}

template <int dim>
void MpmRecorder<dim>::archive(Archive& k)
{
  Recorder<dim>::archive(k);
  k("last_time", last_time_);
  k.table("ledger", [&] { problem::archive(k, last_); });
  k("out_of_balance", out_of_balance_);
  k("shaking", shaking_);
  k("shaken_rows", shaken_rows_);
  if (!Recorder<dim>::counts_from_stages()) return;
  Recorder<dim>::archive_zero(k, "zero_of_centers", first_centers_);
  Recorder<dim>::archive_zero(k, "zero_of_watches", watch_zeros_);
  std::vector<Vec<dim>> loaded;
  for (const problem::LoadPointState<dim>& point : first_loaded_) loaded.push_back(point.x);
  Recorder<dim>::archive_zero(k, "zero_of_load_points", loaded);
  for (std::size_t l = 0; l < loaded.size(); ++l) first_loaded_[l].x = loaded[l];
}

template <int dim>
void MpmRecorder<dim>::observe_step(const problem::Model<dim>& model, const mpm::Workspace<dim>& workspace)
{
  for (std::size_t k = 0; k < model.contacts.size(); ++k)
    if (const Index rigid = model.contacts[k].rigid; rigid != none && rigid == model.main_rigid)
      Recorder<dim>::note_overlap(-workspace.contact_points[k].nearest_particle);
}

template <int dim>
void MpmRecorder<dim>::observe_rigid(const problem::Model<dim>& model, const problem::State<dim>& state, Index rigid)
{
  const Real time = state.time - last_time_;
  const Vec<dim>& impulse = since_.contact_sums[rigid].impulse;
  const Vec<dim> reaction = time > 0 ? Vec<dim>(-impulse / time) : Vec<dim>(Vec<dim>::Zero());
  Recorder<dim>::observe_rigid(model, state, rigid, reaction);
  if constexpr (dim == 3) {
    row_("F", Vec<dim>(reaction + Vec<dim>::Zero()), run_folder::newtons<dim>, "force of the soil on the body");
    row_("d", state.rigid_bodies[rigid].displacement, run_folder::metres, "displacement of its centre");
  }
}

template <int dim>
void MpmRecorder<dim>::observe_rotation_of(const problem::State<dim>& state, Index rigid)
{
  const Real time = state.time - last_time_;
  const bodies::Angular<dim>& impulse = since_.contact_sums[rigid].torque_impulse;
  const auto moment_of = [&](Real component) { return time > 0 ? -component / time + 0. : 0; };
  bodies::Angular<dim> moment;
  if constexpr (dim == 2)
    moment = moment_of(impulse);
  else
    moment = impulse.unaryExpr(moment_of);
  observe_rotation<dim>(row_, moment, rotation_of(state.rigid_bodies[rigid].orientation));
}

template <int dim>
void MpmRecorder<dim>::observe_energies(const problem::Model<dim>& model, const problem::State<dim>& state, Real kinetic)
{
  for (std::size_t r = 0; r < model.rigid_bodies.size(); ++r)
    if (model.rigid_bodies[r].motion == bodies::Motion::free) kinetic += kinetic_energy(model.rigid_bodies[r], state.rigid_bodies[r]);
  const problem::Totals<dim>& t = state.ledger.totals;
  Real error = kinetic + taken_out(state).kinetic - first_kinetic_;
  for_each_row(problem::rows_of_run<dim>, [&](const auto& row) {
    const auto& sum = t.*row.member;
    if constexpr (std::is_same_v<decltype(sum), const Real&>) {
      if (row.balance == problem::Balance::energy) error += sum;
      if (row.balance == problem::Balance::energy_given) error -= sum;
    }
  });
  if (!std::isfinite(error))
    throw RunError(
        fmt::format("energies are not finite at t = {} s (step {}); try {}", state.time, state.step, mpm::smaller_step(model.mpm)));
  Recorder<dim>::observe_energies({kinetic, t.damping, t.filter, t.internal, t.friction, t.external, error},
                                  std::max(first_kinetic_, first_elastic_));
}

template <int dim>
void MpmRecorder<dim>::observe_contact_of_main(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  const contact::ContactSums<dim>& since = since_.contact_sums[model.main_rigid];
  const Real time = state.time - last_time_;
  row_.of_main(model.rigid_bodies[model.main_rigid].name);
  if (model.mesh.metric == mesh::Metric::axisymmetric && has_corners<dim>(model.rigid_bodies[model.main_rigid].shape))
    row_("V_shaft", time > 0 ? -since.shaft_impulse / time : 0, run_folder::newtons<dim>,
         "vertical reaction of sides parallel to the axis");
  row_("gap", since.impulse_sum > 0 ? since.impulse_times_gap / since.impulse_sum : nan, run_folder::metres, "gap");
  Recorder<dim>::observe_overlap();
  row_("second_impulse", time > 0 ? since.second_impulse.norm() / time : 0, run_folder::newtons<dim>, "second contact correction");
  observe_rotation_of(state, model.main_rigid);
}

template <int dim>
void MpmRecorder<dim>::observe_body(const mpm::BodySums<dim>& sums, const Vec<dim>& first_center)
{
  constexpr const char *lower[3] = {"xmin", "ymin", "zmin"}, *upper[3] = {"xmax", "ymax", "zmax"};
  row_("u", Vec<dim>(sums.center() - first_center), run_folder::metres, Recorder<dim>::counted("displacement of its centre of mass"));
  row_("v", Vec<dim>(sums.momentum / sums.mass), run_folder::metres_per_second, "velocity of its centre of mass");
  for (int d = 0; d < dim; ++d) {
    row_(lower[d], sums.lower[d], run_folder::metres, "lower end of its particles");
    row_(upper[d], sums.upper[d], run_folder::metres, "upper end of its particles");
  }
  if (row_.parts() != 1) return;  // that of a part is not that of the whole
  const Vec<3> angular_momentum = sums.angular_momentum();
  for (int d = dim == 2 ? 2 : 0; d < 3; ++d)
    row_.component("L", d, angular_momentum[d], run_folder::newton_metre_seconds<dim>, "angular momentum about its centre of mass");
}

template <int dim>
void MpmRecorder<dim>::observe_contacts(const problem::Model<dim>& model, const problem::State<dim>& state,
                                        const mpm::Workspace<dim>& workspace)
{
  const Real time = state.time - last_time_;
  for (std::size_t k = 0; k < model.contacts.size(); ++k) {
    const bool bonds = model.contacts[k].tension > 0, differs = model.contacts[k].adhesion_law.differs();
    if (bonds || differs) {
      const mpm::SurfaceInContact surface = mpm::surface_in_contact(model.contacts[k], workspace.contact_points[k]);
      row_.of(model.contacts[k].name);
      if (bonds) {
        row_("contact", surface.area, run_folder::surface<dim>, "surface in contact");
        row_("in_tension", surface.in_tension, run_folder::bare, "fraction of the contact surface in tension");
      }
      if (differs) row_("adhesion", surface.adhesion, run_folder::pascals, "mean adhesion of the surface in contact");
    }
    if (model.contacts[k].other_body == none) continue;
    row_.of(model.contacts[k].name);
    const Vec<dim>& impulse = since_.pair_impulses[k];
    row_("F", time > 0 ? Vec<dim>(impulse / time) : Vec<dim>(Vec<dim>::Zero()), run_folder::newtons<dim>,
         "force of the other body on the body");
  }
  for (std::size_t k = 0; k < model.rigid_contacts.size(); ++k) {
    row_.of(model.rigid_contacts[k].name);
    const Vec<dim>& impulse = since_.rigid_impulses[k];
    row_("F", time > 0 ? Vec<dim>(impulse / time) : Vec<dim>(Vec<dim>::Zero()), run_folder::newtons<dim>,
         "force of the other rigid body on the rigid body");
  }
}

template <int dim>
void MpmRecorder<dim>::observe_tractions(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  for (Index t = 0; t < static_cast<Index>(model.tractions.size()); ++t) {
    LoadedArea<dim> area;
    for (std::size_t l = 0; l < model.load_points.size(); ++l) {
      const problem::LoadPoint<dim>& point = model.load_points[l];
      if (point.traction == t) area.add(point.force, state.load_points[l].x - first_loaded_[l].x, point.area);
    }
    row_.of(model.tractions[t].name);
    area.observe(row_, acting_fraction(model.tractions[t], state.tractions[t], state.time), Recorder<dim>::counted("mean displacement"));
  }
}

template <int dim>
void MpmRecorder<dim>::observe_earthworks(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  for (std::size_t k = 0; k < model.earthworks.size(); ++k) {
    row_.of(model.earthworks[k].name);
    const problem::Earthwork<dim>& work = model.earthworks[k];
    row_("mass", state.earthworks[k].mass, run_folder::kilograms<dim>, work.fills ? "mass placed so far" : "mass removed so far");
    if (work.fills)
      row_("expected_mass", mass_of_room(model, work, state.earthworks[k]), run_folder::kilograms<dim>,
           "mass that its area would hold so far");
  }
}

template <int dim>
void MpmRecorder<dim>::observe_watches(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  for (std::size_t k = 0; k < model.watches.size(); ++k) {
    const Watched<dim> watched = watch_points_[k].read(model, state.particles[model.watches[k].body]);
    row_.of(model.watches[k].name);
    row_("u", Vec<dim>(watched.displacement - watch_zeros_[k]), run_folder::metres, Recorder<dim>::counted("displacement"));
    row_("v", watched.velocity, run_folder::metres_per_second, "velocity");
    row_("s", watched.stress, run_folder::pascals, "stress");
    observe_water(row_, model.bodies[model.watches[k].body].soil, watched.stress, watched.pore_pressure);
  }
}

template <int dim>
void MpmRecorder<dim>::observe_effective_normals(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  const Real time = state.time - last_time_;
  for (Index r = 0; r < static_cast<Index>(model.rigid_bodies.size()); ++r) {
    if (!rubs_in_water(model, r)) continue;
    if (r == model.main_rigid)
      row_.of_main(model.rigid_bodies[r].name);
    else
      row_.of(model.rigid_bodies[r].name);
    const Real impulse = since_.contact_sums[r].effective_impulse;
    observe_effective_normal<dim>(row_, time > 0 ? std::max(Real(0), impulse / time) : 0);
  }
}

template <int dim>
void MpmRecorder<dim>::observe_supports(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  const Real time = state.time - last_time_;
  for (std::size_t s = 0; s < model.conditions.reported.size(); ++s) {
    const Vec<dim>& impulse = since_.support_impulses[s];
    row_.of(model.conditions.reported[s]);
    observe_reaction<dim>(row_, time > 0 ? Vec<dim>(impulse / time) : Vec<dim>(Vec<dim>::Zero()));
  }
}

template <int dim>
void MpmRecorder<dim>::observe_motions(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  boundary::for_each_of<boundary::Motion>(model.conditions, [&](std::size_t, const auto& row, const auto&) {
    const Vec<dim> velocity = velocity_of(row, state.stage, state.time - state.stage.begin_time);
    row_.of(row.name);
    for (int d = 0; d < dim; ++d)
      if (row.directions >> d & 1)
        row_.component("v", d, velocity[d], run_folder::metres_per_second, "prescribed velocity of the boundary, or of the incoming wave");
  });
}

template <int dim>
void MpmRecorder<dim>::observe_heads(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  boundary::for_each_of<boundary::Head<dim>>(model.conditions, [&](std::size_t h, const auto& row, const auto& head) {
    Inflow inflow;
    for (const NodeField<Vec<dim>>& flux : state.flux)
      if (flux.size() > 0)
        inflow +=
            sum_of<Inflow>("inflow at a head", row.chunks, [&](Index k) { return Inflow{head_areas_[h][k].dot(flux[row.nodes[k]])}; });
    row_.of(row.name);
    observe_head<dim>(row_, acting_fraction(row, state.heads[h], state.time) * head.pressure, inflow.sum);
  });
}

template <int dim>
void MpmRecorder<dim>::observe_depth_slices(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  const Real time = state.time - last_time_;
  for (Index r = 0; r < static_cast<Index>(model.rigid_bodies.size()); ++r) {
    const problem::DepthSlices& slices = model.depth_slices[r];
    if (slices.count == 0) continue;
    if (r == model.main_rigid)
      row_.of_main(model.rigid_bodies[r].name);
    else
      row_.of(model.rigid_bodies[r].name);
    Real of_shaft = 0;
    for (Index k = 0; k < slices.count; ++k) {
      const auto of_slice = [&](const char* symbol, Real impulse, const char* what) {
        row_(fmt::format("{}{}", symbol, k + 1), time > 0 ? impulse / time + 0. : 0, run_folder::newtons<dim>,
             fmt::format("{} from {:.4g} to {:.4g} m below the seabed", what, k * slices.thickness, (k + 1) * slices.thickness));
      };
      if (model.mesh.metric != mesh::Metric::axisymmetric) of_slice("H", since_.slice_impulses[r][k], "horizontal force on the soil");
      of_slice("V_shaft", -since_.slice_shaft_impulses[r][k], "upward force on vertical sides");
      of_shaft -= since_.slice_shaft_impulses[r][k];
    }
    const Real in_all = -model.axes.height(since_.contact_sums[r].impulse);
    row_("V_base", time > 0 ? (in_all - of_shaft) / time + 0. : 0, run_folder::newtons<dim>,
         "upward force on all other sides: a base or a tip");
  }
}

template <int dim>
void MpmRecorder<dim>::add_row(const problem::Model<dim>& model, const problem::State<dim>& state, const mpm::Workspace<dim>& workspace,
                               run_folder::HistoryFile& file, const std::function<void(run_folder::Row&)>& more)
{
  Real kinetic = 0;
  std::vector<mpm::BodySums<dim>> sums;
  for (const bodies::Particles<dim>& particles : state.particles) {
    sums.push_back(mpm::sums_over(particles));
    kinetic += sums.back().kinetic;
  }
  since_ = difference<dim>(last_, state.ledger);
  row_.begin(state.time, model.stages[state.stage.index].name);
  if (model.main_rigid != none) {
    row_.of_main(model.rigid_bodies[model.main_rigid].name);
    observe_rigid(model, state, model.main_rigid);
  }
  row_.of_main("run");
  observe_energies(model, state, kinetic);
  // Of a run that was resumed the soil may sleep: then the last number is still that of its last step.
  if (!std::isnan(workspace.weight)) out_of_balance_ = workspace.weight > 0 ? workspace.unbalanced / workspace.weight : nan;
  observe_out_of_balance(row_, out_of_balance_);
  if (model.water_flows()) observe_consolidation(row_, state.stage);
  if (model.main_rigid != none) observe_contact_of_main(model, state);
  for (Index r = 0; r < static_cast<Index>(model.rigid_bodies.size()); ++r) {
    if (r == model.main_rigid) continue;
    row_.of(model.rigid_bodies[r].name);
    observe_rigid(model, state, r);
    observe_rotation_of(state, r);
  }
  for (std::size_t b = 0; b < sums.size(); ++b) {
    row_.of(model.bodies[b].name);
    observe_body(sums[b], first_centers_[b]);
  }
  observe_contacts(model, state, workspace);
  observe_tractions(model, state);
  observe_earthworks(model, state);
  observe_watches(model, state);
  observe_effective_normals(model, state);
  observe_depth_slices(model, state);
  observe_supports(model, state);
  observe_motions(model, state);
  observe_heads(model, state);
  Recorder<dim>::observe_movement();
  if (more) more(row_);
  file.add(row_);
  if (model.main_rigid != none && model.driven[state.stage.index] == model.main_rigid)
    if (const Real now = mpm::shaking(model, state, workspace); std::isfinite(now)) shaking_ += now, shaken_rows_ += 1;
  last_time_ = state.time;
  last_ = state.ledger;
}

template class MpmRecorder<2>;
template class MpmRecorder<3>;

}  // namespace berm::simulation
