// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/mohr_coulomb.hpp"
#include "simulate.hpp"

namespace berm {

inline material::MohrCoulomb loose_sand()
{
  material::MohrCoulomb law;
  law.density = 877;
  law.young_modulus = 7e6;
  law.poisson_ratio = 0.25;
  law.friction_angle = 35 * pi / 180;
  return law;
}

/// A pipe of 20 mm in sand at 50 g, small and coarse: 30 x 15 squares of 4 mm, 2700 particles. Stages "push" at 1 m/s, then "drag" at 1 m/s with
/// the vertical force held; the first 300 steps press the pipe in by some 4 mm.
inline settings::Case pipe_in_sand()
{
  settings::Case c;
  c.gravity = {0, -50 * standard_gravity};
  c.surface = 0.04;
  mesh::BoxMesh mesh;
  mesh.size = {0.12, 0.06};
  mesh.cells = {30, 15};
  c.mesh = mesh;
  c.material = {{"sand", loose_sand()}};
  bodies::BodySettings body;
  body.material = "sand";
  bodies::BlockSettings block;
  block.center = {0.06, 0.02};
  block.size = {0.12, 0.04};
  block.spacing = 0.004 / 3;
  body.block = block;
  body.damping = 0.05;
  body.k0 = 0.43;
  c.body = {{"sand", body}};
  bodies::RigidSettings pipe;
  pipe.shape = bodies::CircleSettings{{0.05, 0.05}, 0.02};
  pipe.mass = 1;
  c.rigid = {{"pipe", pipe}};
  contact::ContactSettings contact;
  contact.body = "sand";
  contact.rigid = "pipe";
  contact.friction_angle = 23 * pi / 180;
  c.contact = {{"skin", contact}};
  c.support = {{"base", {"bottom", {"x", "y"}}}, {"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}};
  settings::StageSettings push, drag;
  push.name = "push";
  push.kind = settings::StageKind::push;
  push.velocity = 1;
  push.until.time = infinity;
  drag = push;
  drag.name = "drag";
  drag.kind = settings::StageKind::drag;
  c.stage = {push, drag};
  return c;
}

/// A column of sand, 0.5 m x 1 m, that collapses over a rough floor at y = 0.1 m and along a smooth wall at x = 0.
inline settings::Case collapsing_column()
{
  settings::Case c;
  c.gravity = {0, -standard_gravity};
  mesh::BoxMesh mesh;
  mesh.size = {2, 1.2};
  mesh.cells = {20, 12};
  c.mesh = mesh;
  material::MohrCoulomb law = loose_sand();
  law.young_modulus = 1e6;
  c.material = {{"sand", law}};
  bodies::BodySettings body;
  body.material = "sand";
  bodies::BlockSettings block;
  block.center = {0.25, 0.6};
  block.size = {0.5, 1};
  block.spacing = 0.1 / 3;
  body.block = block;
  c.body = {{"sand", body}};
  bodies::RigidSettings floor;
  floor.shape = bodies::HalfPlaneSettings{{0, 0.1}, {0, 1}};
  c.rigid = {{"floor", floor}};
  contact::ContactSettings contact;
  contact.body = "sand";
  contact.rigid = "floor";
  contact.friction_angle = 0.5;
  c.contact = {{"floor", contact}};
  c.support = {{"left", {"left", {"x"}}}};
  settings::StageSettings stage;
  stage.name = "collapse";
  stage.until.time = infinity;
  c.stage = {stage};
  return c;
}

/// Every number of every particle, by number.
template <int dim>
std::vector<bodies::Particle<dim>> all_particles(const problem::State<dim>& state, Index body = 0)
{
  const bodies::Particles<dim>& particles = state.particles[body];
  std::vector<bodies::Particle<dim>> all(particles.size());
  particles.visit([&](Index, Index b, int l) { all.at(particles.block(b).id[l]) = particles.read(b, l); });
  return all;
}

template <int dim>
void take_steps(Simulation<dim>& run, int count)
{
  for (int n = 0; n < count; ++n) step(run.model(), run.state(), run.workspace);
}

template <int dim>
void next_stage(Simulation<dim>& run)
{
  ++run.state().stage.index;
  begin_stage(run.model(), run.state());
}

}  // namespace berm
