// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/safety_test.cpp
#include "problem/safety.hpp"

#include "settings/body_soil.hpp"
#include "settings/drainage.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::problem {
namespace {

constexpr Real of_height = 0.01, of_compression = 2;

/// What the largest traction, and the largest force on a rigid body or its weight over its width (squared, of a whole force) press the soil with, Pa.
template <int dim>
Real pressure_of_loads(const settings::Case& c, const Model<dim>& model)
{
  Real pressure = 0, force = 0;
  for (const auto& [name, traction] : c.traction) {
    const Real below_level = std::max(Real(0), traction.level.value_or(0) - model.mesh.lower[1]);
    pressure = std::max(pressure, traction.pressure ? std::abs(*traction.pressure) + std::abs(traction.pressure_gradient) * below_level
                                                    : bodies::to_vec<dim>(traction.stress).norm());
  }
  if (model.main_rigid == none) return pressure;
  const bodies::RigidBody<dim>& body = model.rigid_bodies[model.main_rigid];
  if (body.motion == bodies::Motion::free) force = model.parts * body.mass * model.gravity.norm();
  for (const settings::StageSettings& stage : c.stage)
    for (const std::optional<Real>& given :
         {stage.force, stage.vertical_force, stage.drive.x.force, stage.drive.y.force, stage.drive.z.force})
      force = std::max(force, std::abs(given.value_or(0)));
  const Real width = width_of<dim>(body.shape);
  return pressure + force / (c.force_dimension() == 2 ? width : width * width);
}

/// Compression of a column of elastic soil of this height by its own weight and a pressure on its top, held at its base alone, m.
Real compression_of(const settings::BodySoil& soil, Real gravity, Real pressure, Real height)
{
  constexpr int parts = 100;
  Real sum = 0;
  for (int k = 0; k < parts; ++k) {
    const Real z = height * (k + 0.5) / parts;
    sum += (pressure + gravity * soil.mass_above("", z)) / young_poisson(soil.at("", z)).young_modulus;
  }
  return sum * height / parts;
}

template <int dim>
Real height_that_slides(const Model<dim>& model, Real depth)
{
  if (const std::vector<Vec<2>>& line = model.ground.line.corners; dim == 2 && !line.empty()) {
    const auto [low, high] = std::minmax_element(line.begin(), line.end(), [](const Vec<2>& a, const Vec<2>& b) { return a[1] < b[1]; });
    return std::min(depth, (*high)[1] - (*low)[1]);
  }
  const Real width = model.main_rigid == none ? infinity : width_of<dim>(model.rigid_bodies[model.main_rigid].shape);
  return std::min(depth, width);
}

}  // namespace

template <int dim>
Real depth_of_soil(const Model<dim>& model, const std::vector<Vec<dim>>& corners)
{
  Real low = infinity, high = -infinity, below_ground = 0;
  const bool level = dim != 2 || model.ground.line.level();
  for (const Vec<dim>& x : corners) {
    const Real y = model.axes.height(x);
    low = std::min(low, y);
    high = std::max(high, y);
    if (!level) below_ground = std::max(below_ground, model.ground.line.height(x[model.axes.along]) - x[model.axes.up]);
  }
  return level ? high - low : below_ground;
}

template <int dim>
Real movement_at_failure(const settings::Case& c, const Model<dim>& model, Real depth)
{
  if (c.safety->movement) return *c.safety->movement;
  const Real height = height_that_slides(model, depth), pressure = pressure_of_loads(c, model);
  Real compression = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const bodies::BodySettings& body = c.body[b].second;
    const bool has_stress = body.has_k0() || !body.initial_stress.empty();
    compression = std::max(compression, compression_of(model.bodies[b].soil, model.gravity.norm(), pressure, has_stress ? height : depth));
  }
  return of_height * height + of_compression * compression;
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template Real depth_of_soil(const Model<dim>&, const std::vector<Vec<dim>>&);                                                            \
  template Real movement_at_failure(const settings::Case&, const Model<dim>&, Real);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::problem
