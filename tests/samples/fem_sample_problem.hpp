// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fem/load_steps.hpp"
#include "material/linear_elastic.hpp"
#include "material/mohr_coulomb.hpp"
#include "problem/stages.hpp"
#include "samples/temporary_folder.hpp"

#include <random>

namespace berm {

inline fem::FemProblem fem_problem_of(const settings::Case& c)
{
  const TemporaryFolder folder;
  return fem::build_fem(c, ".", folder.path());
}

inline material::LinearElastic elastic_soil()
{
  material::LinearElastic law;
  law.density = 1000;
  law.young_modulus = 1e6;
  law.poisson_ratio = 0.25;
  return law;
}
constexpr Real oedometer_modulus = 1.2e6;  ///< Pa, of elastic_soil

inline material::MohrCoulomb plastic_soil(Real cohesion, Real friction_angle, Real dilation_angle)
{
  material::MohrCoulomb law;
  law.density = 1000;
  law.young_modulus = 1e6;
  law.poisson_ratio = 0.25;
  law.cohesion = cohesion;
  law.friction_angle = friction_angle * pi / 180;
  law.dilation_angle = dilation_angle * pi / 180;
  return law;
}

inline settings::StageSettings resting(Real time)
{
  settings::StageSettings stage;
  stage.name = "rest";
  stage.kind = settings::StageKind::geostatic;
  stage.until.time = time;
  return stage;
}

/// At 1 m/s, which the limit is to be added to.
inline settings::StageSettings pushing()
{
  settings::StageSettings stage;
  stage.name = "push";
  stage.kind = settings::StageKind::push;
  stage.velocity = 1;
  return stage;
}

inline settings::StageSettings dragging(settings::Vertical vertical)
{
  settings::StageSettings stage;
  stage.name = "drag";
  stage.kind = settings::StageKind::drag;
  stage.velocity = 1;
  stage.vertical = vertical;
  return stage;
}

/// A block 0 < x < 1 m, 0 < y < 0.5 m between rollers on a fixed base, its top at the level `surface`, and nothing else.
inline settings::Case block_of(const material::Material& soil, std::vector<Real> cells = {4, 2})
{
  settings::Case c;
  c.method = settings::Method::fem;
  c.surface = 0.5;
  mesh::BoxMesh box;
  box.size = {1, 0.5};
  box.cells = cells;
  c.mesh = box;
  c.material = {{"soil", soil}};
  bodies::BodySettings body;
  body.material = "soil";
  body.regions = {"box"};
  c.body = {{"block", body}};
  c.support = {{"left", {"left", {"x"}}}, {"right", {"right", {"x"}}}, {"base", {"bottom", {"x", "y"}}}};
  c.stage = {resting(1)};
  return c;
}

/// The block under a rigid plate of this width that lies on the middle of its top.
inline settings::Case plate_on_block(const material::Material& soil, Real width = 1, std::vector<Real> cells = {4, 2})
{
  settings::Case c = block_of(soil, cells);
  bodies::RigidSettings plate;
  plate.shape = bodies::BoxSettings{{0.5, 0.6}, {width, 0.2}};
  plate.mass = 1;
  c.rigid = {{"plate", plate}};
  contact::ContactSettings skin;
  skin.body = "block";
  skin.rigid = "plate";
  c.contact = {{"skin", skin}};
  return c;
}

/// Numbers spread evenly between -size and size, the same each time.
inline std::vector<Real> random_numbers(Index count, Real size)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<Real> number(-size, size);
  std::vector<Real> numbers(count);
  for (Real& n : numbers) n = number(random);
  return numbers;
}

/// By unknown: the nodes move as displacement(x) says, the rigid body does not.
template <class Displacement>
std::vector<Real> change_of(const fem::FemModel& model, const Displacement& displacement)
{
  std::vector<Real> change(model.unknowns(), 0.);
  for (Index node = 0; node < model.mesh.node_count(); ++node) {
    const Vec<2> u = displacement(model.mesh.position[node]);
    for (int d = 0; d < 2; ++d) change[2 * node + d] = u[d];
  }
  return change;
}

}  // namespace berm
