// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/linear_elastic.hpp"
#include "material/mohr_coulomb.hpp"
#include "mpm/step.hpp"
#include "problem/stages.hpp"

namespace berm::test {

/// A block of sand and one of elastic soil side by side in a box of 1 m, and a disk (a sphere) that is pushed into the sand while the boxes' walls
/// hold both. One particle a cell, so that the contact lists many cells.
template <int dim>
settings::Case two_bodies(contact::Scheme scheme)
{
  settings::Case c;
  c.geometry = dim == 2 ? settings::Geometry::plane_strain : settings::Geometry::space;
  c.gravity.assign(dim, 0);
  c.gravity[1] = -10;
  c.surface = 0.5;
  mesh::BoxMesh box;
  box.size.assign(dim, 1);
  box.cells.assign(dim, dim == 2 ? 12 : 5);
  c.mesh = box;
  material::MohrCoulomb sand;
  sand.density = 1600;
  sand.young_modulus = 1e6;
  sand.poisson_ratio = 0.3;
  sand.friction_angle = 0.6;
  sand.max_opening = 0.2;
  sand.dilation_angle = 0.1;
  material::LinearElastic solid;
  solid.density = 1500;
  solid.young_modulus = 1e6;
  solid.poisson_ratio = 0.3;
  c.material = {{"sand", sand}, {"solid", solid}};
  const auto block = [](Real x) {
    bodies::BodySettings body;
    bodies::BlockSettings of;
    of.center.assign(dim, 0.5);
    of.size.assign(dim, 1);
    of.center[0] = x;
    of.size[0] = 0.5;
    of.center[1] = 0.25;
    of.size[1] = 0.5;
    of.spacing = dim == 2 ? 0.0417 : 0.125;
    body.block = of;
    body.damping = 0.02;
    return body;
  };
  c.body = {{"left", block(0.25)}, {"right", block(0.75)}};
  c.body[0].second.material = "sand";
  c.body[1].second.material = "solid";
  bodies::RigidSettings disk;
  std::vector<Real> center(dim, 0.5);
  center[0] = 0.3;
  center[1] = 0.62;
  disk.shape = bodies::CircleSettings{center, 0.24};
  disk.mass = 10;
  c.rigid = {{"disk", disk}};
  contact::ContactSettings skin, between;
  skin.body = "left";
  skin.rigid = "disk";
  skin.friction_angle = 0.4;
  between.body = "left";
  between.other_body = "right";
  between.friction_angle = 0.3;
  skin.scheme = between.scheme = scheme;
  c.contact = {{"skin", skin}, {"between", between}};
  c.support = {{"bottom", {"bottom", {"x", "y"}}}, {"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}};
  if (dim == 3) c.support.insert(c.support.end(), {{"front", {"front", {"z"}}}, {"back", {"back", {"z"}}}});
  settings::StageSettings push;
  push.name = "push";
  push.kind = settings::StageKind::push;
  push.velocity = 0.25;
  push.until.time = 1;
  c.stage = {push};
  return c;
}

/// Everything a step changes: the state, and the memory that it works with.
template <int dim>
struct SampleRun {
  problem::Problem<dim> problem;
  std::optional<mpm::Workspace<dim>> workspace;

  explicit SampleRun(contact::Scheme scheme = contact::ContactSettings{}.scheme) : SampleRun(two_bodies<dim>(scheme)) {}
  explicit SampleRun(const settings::Case& c) : problem(problem::build<dim>(c, ".", ".")) {}

  void steps(int count)
  {
    if (!workspace) workspace.emplace(problem.model, problem.state);
    for (int n = 0; n < count; ++n) step(problem.model, problem.state, *workspace);
  }
};

}  // namespace berm::test
