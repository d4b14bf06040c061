// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/time_step.hpp"

#include "core/for_each.hpp"
#include "mpm/diagnose.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "settings/drives.hpp"

#include <fmt/format.h>

namespace berm::mpm {

namespace {

/// Speed at which a drive by velocity moves the body's surface, m/s.
template <int dim>
Real speed_of_drive(const problem::Model<dim>& model, const problem::State<dim>& state, int freedom)
{
  const settings::StageSettings& stage = model.stages[state.stage.index];
  const int column = settings::load_column_of(stage, model.axes, freedom);
  const Real speed =
      std::abs(state.stage.drive[freedom].to) * (column == none ? 1 : settings::max_load(stage, static_cast<std::size_t>(column)));
  const Index driven = model.driven[state.stage.index];
  return freedom < dim || driven == none ? speed : speed * reach_of<dim>(model.rigid_bodies[driven].shape);
}

/// Speed and description of what moves fastest: rigid body, drive, node, or particle at the start.
template <int dim>
std::pair<Real, std::string> fastest_of(const problem::Model<dim>& model, const problem::State<dim>& state, const Workspace<dim>& workspace)
{
  std::pair<Real, std::string> fastest{0, "the stiffness of the bodies"};
  const auto take = [&](Real speed, const auto& words) {
    if (speed > fastest.first) fastest = {speed, words()};
  };
  for (std::size_t r = 0; r < state.rigid_bodies.size(); ++r)
    take(state.rigid_bodies[r].velocity.norm() +
             bodies::size_of_angular(state.rigid_bodies[r].angular_velocity) * reach_of<dim>(model.rigid_bodies[r].shape),
         [&] { return fmt::format("rigid body \"{}\"", model.rigid_bodies[r].name); });
  for (int f = 0; f < bodies::freedoms<dim>; ++f)
    if (!state.stage.drive[f].by_force)
      take(speed_of_drive(model, state, f), [&] { return fmt::format("the drive of stage \"{}\"", model.stages[state.stage.index].name); });
  for (std::size_t b = 0; b < model.bodies.size() && state.step == 0; ++b)
    state.particles[b].visit([&](Index, Index block, int l) {
      const bodies::Particle<dim> p = state.particles[b].read(block, l);
      take(p.v.norm(), [&] { return fmt::format("body \"{}\", particle {}", model.bodies[b].name, p.id); });
    });
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    for (const Index i : workspace.grids[b].nodes) {
      const Vec<dim>& x = model.mesh.position[i];
      take(workspace.grids[b].mapped_velocity[i].norm(),
           [&] { return fmt::format("body \"{}\" at the node at ({}) m", model.bodies[b].name, text_of_list(x, ", ", "{:.6g}")); });
    }
  return fastest;
}

/// The largest Courant number at which explicit steps with the bulk viscosity b are stable: the shortest wave has the damping ratio b, which leaves
/// sqrt(1 + b^2) - b of the limit without it (Belytschko, Liu, Moran and Elkhodary 2014, section 6.3).
template <int dim>
Real stable_courant(const problem::Model<dim>& model)
{
  const bool viscous = std::any_of(model.bodies.begin(), model.bodies.end(),
                                   [](const problem::Body<dim>& body) { return yields(body.soil.materials.front()); });
  const Real b = viscous ? model.mpm.bulk_viscosity : 0;
  return std::sqrt(1 + b * b) - b;
}

/// Inverse square of the height, 1/m2, that limits the time step of a cell: that of the smallest. In axisymmetry a node at the radius r has the part (R + r) /
/// 4R of the cell's mass, R the sum of the three radii, where it has a third in the plane, and moves the cell's hoop strain by 1/R of its radial velocity, which
/// on the axis is 0: the square is then the largest of (|grad N|^2 + 1/R^2) 4R / 3(R + r).
template <int dim>
Real stiffest_square(const mesh::Mesh<dim>& mesh, Index cell, const mesh::Shape<dim>& shape)
{
  if (mesh.metric != mesh::Metric::axisymmetric) return shape.steepest_square();
  Real radii = 0, stiffest = 0;
  for (const Index node : mesh.nodes[cell]) radii += mesh.position[node][0];
  for (int k = 0; k <= dim; ++k) {
    const Real radius = mesh.position[mesh.nodes[cell][k]][0], hoop = radius > 0 ? 1 / (radii * radii) : 0;
    stiffest = std::max(stiffest, (shape.gradient(k).squaredNorm() + hoop) * 4 * radii / (3 * (radii + radius)));
  }
  return stiffest;
}

/// The time step, s, at which an explicit step of the stiffest spring of the drive is at its limit: 2 sqrt(m / k).
template <int dim>
Real limit_of_springs(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  const Index driven = model.driven[state.stage.index];
  Real limit = infinity;
  for (int f = 0; f < bodies::freedoms<dim> && driven != none; ++f) {
    const bodies::RigidBody<dim>& body = model.rigid_bodies[driven];
    Real inertia = body.mass;
    if constexpr (dim == 2)
      inertia = f < dim ? inertia : body.inertia;
    else
      inertia = f < dim ? inertia : body.inertia.minCoeff();
    if (const Real stiffness = state.stage.drive[f].spring; stiffness > 0) limit = std::min(limit, 2 * std::sqrt(inertia / stiffness));
  }
  return limit;
}

/// A run with a time step this small beside that of a body at rest has become unstable: soil moves a thousand times faster
/// than its own waves.
constexpr Real min_fraction = 1e-3;

}  // namespace

template <int dim>
TimeSteps stable_time_steps(const problem::Model<dim>& model, const problem::State<dim>& state, const Workspace<dim>& workspace)
{
  Real fastest = 0;
  for (std::size_t r = 0; r < state.rigid_bodies.size(); ++r) {
    const bodies::RigidState<dim>& rigid = state.rigid_bodies[r];
    fastest = std::max(fastest, rigid.velocity.norm() +
                                    bodies::size_of_angular(rigid.angular_velocity) * reach_of<dim>(model.rigid_bodies[r].shape));
  }
  for (int f = 0; f < bodies::freedoms<dim>; ++f)
    if (!state.stage.drive[f].by_force) fastest = std::max(fastest, speed_of_drive(model, state, f));
  if (state.step == 0)  // the nodes do not move yet
    for (const bodies::Particles<dim>& particles : state.particles) {
      particles.visit([&](Index, Index b, int l) {
        Real square = 0;
        for (int d = 0; d < dim; ++d) square += particles.block(b).v[d][l] * particles.block(b).v[d][l];
        fastest = std::max(fastest, std::sqrt(square));
      });
    }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyGrid<dim>& grid = workspace.grids[b];
    // A comparison with NaN is false, so NaN is replaced by infinity to be detected.
    const auto& active = state.particles[b].active();
    fastest = largest_of("fastest node", static_cast<Index>(active.size()), fastest, [&](Index c) {
      Real of_cell = 0;
      for (const Index node : model.mesh.nodes[active[c]]) {
        const Real speed = grid.mapped_velocity[node].norm();
        of_cell = std::max(of_cell, std::isfinite(speed) ? speed : infinity);
      }
      return of_cell;
    });
  }
  Ranks& ranks = Ranks::of_run();
  fastest = ranks.largest(fastest);
  if (!std::isfinite(fastest)) {
    const auto bodies = static_cast<Index>(model.bodies.size());
    Index body = bodies;
    for (Index b = bodies; b-- > 0;)
      for (const Index cell : state.particles[b].occupied())
        for (const Index node : model.mesh.nodes[cell])
          if (!workspace.grids[b].mapped_velocity[node].allFinite()) body = b;
    body = -static_cast<Index>(ranks.largest(-body));
    if (body < bodies) throw_not_finite(model, state, body);
  }
  if (!std::isfinite(fastest))
    throw RunError(fmt::format("velocities are not finite at t = {} s (step {}); try {}", state.time, state.step, smaller_step(model.mpm)));

  const Real most = stable_courant(model), courant = std::min(model.mpm.courant.value_or(default_courant), most);
  Real min = infinity, min_at_rest = infinity, by_default = infinity;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Real wave_speed = model.bodies[b].waves.fastest;
    const auto& occupied = state.particles[b].occupied();  // the time step does not depend on which soil rests
    const Real steepest = ranks.largest(largest_of("smallest height", static_cast<Index>(occupied.size()), 0, [&](Index c) {
      return stiffest_square(model.mesh, occupied[c], workspace.grids[b].shape(model.mesh, occupied[c]));
    }));
    const Real of_mesh =
        std::max(std::min(default_courant, most) / std::sqrt(steepest), default_stable_fraction * most * model.bodies[b].critical_length);
    const Real length = model.mpm.courant ? courant / std::sqrt(steepest) : of_mesh;
    min = std::min(min, length / (wave_speed + fastest));
    by_default = std::min(by_default, of_mesh / (wave_speed + fastest));
    min_at_rest = std::min(min_at_rest, length / wave_speed);
  }
  const Real dt = std::min(min, courant * limit_of_springs(model, state));
  if (min < min_fraction * min_at_rest || state.time + dt == state.time) {
    const auto [of_rank, words] = fastest_of(model, state, workspace);
    const Real speed = ranks.largest(of_rank);
    const std::string what = ranks.text_of_largest(of_rank, words);
    throw RunError(fmt::format("the time step has fallen to {:.3g} s (at rest it is {:.3g} s) at t = {:.6g} s (step {}), because of {}, "
                               "which moves at {:.3g} m/s; try {}, and check velocities and loads",
                               dt, min_at_rest, state.time, state.step, what, speed, smaller_step(model.mpm)));
  }
  return {dt, by_default};
}

std::string smaller_step(const settings::MpmSettings& settings)
{
  return settings.courant ? fmt::format("a smaller mpm.courant (now {:g})", *settings.courant)
                          : "mpm.courant = 0.4 or less (now it is not set)";
}

template TimeSteps stable_time_steps(const problem::Model<2>&, const problem::State<2>&, const Workspace<2>&);
template TimeSteps stable_time_steps(const problem::Model<3>&, const problem::State<3>&, const Workspace<3>&);

}  // namespace berm::mpm
