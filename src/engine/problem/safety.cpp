// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/safety_test.cpp
#include "problem/safety.hpp"

#include "problem/body_soil.hpp"
#include "problem/drainage.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::problem {
namespace {

constexpr Real of_height = 0.01, of_compression = 2;

void weaken(Real& friction_angle, Real& adhesion, Real factor)
{
  friction_angle = std::atan(std::tan(friction_angle) / factor);
  adhesion /= factor;
}

/// What the largest traction, and the largest force on a rigid body or its weight over its width (squared, of a whole force) press the soil with, Pa.
template <int dim>
Real pressure_of_loads(const Case& c, const Model<dim>& model)
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
  for (const StageSettings& stage : c.stage)
    for (const std::optional<Real>& given :
         {stage.force, stage.vertical_force, stage.drive.x.force, stage.drive.y.force, stage.drive.z.force})
      force = std::max(force, std::abs(given.value_or(0)));
  const Real width = width_of<dim>(body.shape);
  return pressure + force / (c.force_dimension() == 2 ? width : width * width);
}

/// Compression of a column of elastic soil of this height by its own weight and a pressure on its top, held at its base alone, m.
Real compression_of(const BodySoil& soil, Real gravity, Real pressure, Real height)
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

bool has_load(const Case& c)
{
  const auto pushes = [](const StageSettings& stage) {
    const FreedomSettings* freedoms[] = {&stage.drive.x, &stage.drive.y, &stage.drive.z};
    return stage.force || stage.vertical_force || has_load_history(stage) ||
           std::any_of(std::begin(freedoms), std::end(freedoms), [](const FreedomSettings* f) { return f->force.has_value(); });
  };
  return std::any_of(c.gravity.begin(), c.gravity.end(), [](Real g) { return g != 0; }) || !c.traction.empty() ||
         std::any_of(c.stage.begin(), c.stage.end(), pushes);
}

}  // namespace

Case with_reduced_strength(Case c)
{
  if (!c.safety) return c;
  const Real factor = c.safety->factor;
  for (auto& [name, soil] : c.material)
    if (const std::optional<material::Material> weaker = with_strength_over(soil, factor)) soil = *weaker;
  for (auto& [name, contact] : c.contact) {
    weaken(contact.friction_angle, contact.adhesion, factor);
    contact.tension /= factor;
    for (contact::SoilInterfaceSettings& beside : contact.soil) weaken(beside.friction_angle, beside.adhesion, factor);
  }
  for (StageSettings& stage : c.stage) stage.equilibrium = std::min(stage.equilibrium, strictest_equilibrium);
  return c;
}

bool moves_body(const StageSettings& stage)
{
  if (!drives(stage.kind)) return false;
  const TurnSettings* turns[] = {&stage.drive.rotation, &stage.drive.rotation_x, &stage.drive.rotation_y, &stage.drive.rotation_z};
  const bool turned =
      std::any_of(std::begin(turns), std::end(turns), [](const TurnSettings* turn) { return turn->velocity.value_or(0) != 0; });
  return stage.kind == StageKind::sweep || turned || speed_of(stage) > 0;
}

void check_safety(Describe& d, const Case& c)
{
  if (!c.safety) return;
  bool yields_somewhere = false;
  for (const auto& [name, soil] : c.material) {
    if (!is_used(c, name)) continue;
    yields_somewhere = yields_somewhere || yields(soil);
    d.check(
        with_strength_over(soil, c.safety->factor).has_value(), "material." + name + ".law",
        fmt::format("\"{}\" has no strength that a factor of safety divides: that of a critical-state soil follows from its density and "
                    "pressure, and the meaning of the properties of a user law is not known; take \"mohr_coulomb\" or \"clay\"",
                    material::law_word(soil)));
  }
  d.check(yields_somewhere, "material",
          "no soil of this case has a strength that a factor of safety could divide: give one the law mohr_coulomb or clay");
  for (const auto& [name, body] : c.body)
    d.check(body.fill.empty() && body.excavation.empty(), "body." + name,
            "a trial of the factor of safety follows the movement of soil that is there from the start to the end: leave out its fills and "
            "excavations, and let the case begin with the ground as it is then");
  d.check(has_load(c), "gravity", "nothing loads the soil of this case, so it never fails: add gravity, a traction or a force");
  d.check(c.stage.empty() || !moves_body(c.stage.back()), fmt::format("stage[{}].kind", c.stage.empty() ? 0 : c.stage.size() - 1),
          "the last stage moves a body, so that the soil cannot come to rest: add a stage after it that is geostatic, free, or driven by a "
          "force");
}

Real time_factor_of_last_stage(const Case& c, Real depth)
{
  const std::optional<Real> time = c.stage.empty() ? std::nullopt : c.stage.back().until.time;
  if (!time) return nan;
  Real factor = nan;
  for (const Consolidation& soil : consolidation_of(c, depth / 2)) factor = std::fmin(factor, soil.c_v * *time / (depth * depth));
  return factor;
}

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
Real movement_at_failure(const Case& c, const Model<dim>& model, Real depth)
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
  template Real movement_at_failure(const Case&, const Model<dim>&, Real);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::problem
