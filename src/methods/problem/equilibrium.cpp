// SPDX-License-Identifier: BSD-3-Clause
#include "problem/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace berm::problem {
namespace {

constexpr Real margin = 4;
constexpr Real patience = 10;  // of a trial of the factor of safety: soil near its limit moves slowly

/// The slowest wave of a body's soil, down to a depth, m/s: that of a modulus (Pa).
Real slowest_wave(const settings::BodySoil& soil, Real depth, Real (*modulus)(const material::Material&))
{
  constexpr int parts = 10;
  Real slowest = infinity;
  const auto add = [&](const material::Material& m) { slowest = std::min(slowest, std::sqrt(modulus(m) / inertia_density(m))); };
  for (int k = 1; k <= parts; ++k) {  // at the surface itself soil may have no stiffness
    add(soil.at("", depth * k / parts));
    for (const auto& entry : soil.of_region) add(soil.at(entry.first, depth * k / parts));
  }
  return slowest;
}

/// Lowest and highest level of the soil's cells, m.
template <int dim>
std::pair<Real, Real> levels_of(const Model<dim>& model, const std::vector<bodies::Particles<dim>>& particles)
{
  std::pair<Real, Real> levels(infinity, -infinity);
  for (const bodies::Particles<dim>& body : particles)
    for (const Index cell : body.occupied())
      for (const Index node : model.mesh.nodes[cell]) {
        const Real level = model.axes.height(model.mesh.position[node]);
        levels.first = std::min(levels.first, level);
        levels.second = std::max(levels.second, level);
      }
  return levels;
}

/// The depth of soil below its surface: on a slope not that from its highest to its lowest point.
template <int dim>
Real depth_of(const Model<dim>& model, const std::vector<bodies::Particles<dim>>& particles)
{
  const auto [low, high] = levels_of(model, particles);
  if (dim != 2 || model.ground.line.level()) return high - low;
  Real depth = 0;
  for (const bodies::Particles<dim>& body : particles) depth = std::max(depth, depth_below_ground(model, body.occupied()));
  return depth;
}

}  // namespace

template <int dim>
Real depth_below_ground(const Model<dim>& model, const std::vector<Index>& cells)
{
  Real depth = 0;
  for (const Index cell : cells)
    for (const Index node : model.mesh.nodes[cell]) {
      const Vec<dim>& x = model.mesh.position[node];
      depth = std::max(depth, model.ground.line.height(x[model.axes.along]) - x[model.axes.up]);
    }
  return depth;
}

template <int dim>
Real longest_period(const Model<dim>& model, const std::vector<bodies::Particles<dim>>& particles)
{
  const Real depth = depth_of(model, particles);
  Real slowest = infinity;
  for (const Body<dim>& body : model.bodies)
    slowest = std::min(slowest, slowest_wave(body.soil, depth, [](const material::Material& m) { return elasticity(m).shear; }));
  return 4 * depth / slowest;
}

template <int dim>
void set_fading(Model<dim>& model)
{
  constexpr Real of_width = 0.01, crossings = 10;
  for (Index r = 0; r < static_cast<Index>(model.rigid_bodies.size()); ++r) {
    bodies::RigidBody<dim>& rigid = model.rigid_bodies[r];
    const Real own = width_of<dim>(rigid.shape), width = own > 0 ? own : (model.mesh.upper - model.mesh.lower).minCoeff();
    Real slowest = infinity;
    for (const Contact& contact : model.contacts)
      if (contact.rigid == r)
        slowest = std::min(
            slowest, slowest_wave(model.bodies[contact.body].soil, width, [](const material::Material& m) { return p_wave_modulus(m); }));
    rigid.fading = {of_width * width, slowest > 0 && slowest < infinity ? crossings * width / slowest : 0};
  }
}

template <int dim>
Real longest_pressure_period(const Model<dim>& model, const std::vector<bodies::Particles<dim>>& particles)
{
  Real slowest = infinity;
  for (const Body<dim>& body : model.bodies)
    if (body.flows()) slowest = std::min(slowest, body.waves.slowest);
  return slowest < infinity ? 4 * depth_of(model, particles) / slowest : 0;
}

Real time_to_equilibrium(Real period, Real damping, Real accepted)
{
  return margin * period * std::log(1 / std::min(accepted, Real(0.5))) / (2 * damping);
}

template <int dim>
void limit_equilibrium(const settings::Case& c, Model<dim>& model, const std::vector<bodies::Particles<dim>>& particles)
{
  if (std::none_of(model.stages.begin(), model.stages.end(), settings::ends_at_equilibrium) && !c.safety) return;
  model.longest_period = longest_period(model, particles);
  Real damping = 1;
  for (const auto& [name, body] : c.body) damping = std::min(damping, body.damping);
  for (settings::StageSettings& stage : model.stages)
    if (settings::ends_at_equilibrium(stage) && !stage.until.time) {
      stage.until.equilibrium = true;
      const Real time = time_to_equilibrium(model.longest_period, stage.damping.value_or(damping), stage.equilibrium);
      stage.until.time = model.gravity_ramp + (c.safety ? patience : 1) * time;
    }
}

template <int dim>
Real velocity_at_rest(const Model<dim>& model, const settings::StageSettings& stage)
{
  return stage.equilibrium * model.gravity.norm() * model.longest_period / (2 * std::numbers::pi);
}

template <int dim>
bool in_balance(const Model<dim>& model, const State<dim>& state, Real out_of_balance)
{
  const settings::StageSettings& stage = model.stages[state.stage.index];
  return settings::ends_at_equilibrium(stage) && state.time >= model.gravity_ramp &&
         state.time - state.stage.begin_time >= model.longest_period / 4 && out_of_balance <= stage.equilibrium;
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template Real depth_below_ground(const Model<dim>&, const std::vector<Index>&);                                                          \
  template Real longest_period(const Model<dim>&, const std::vector<bodies::Particles<dim>>&);                                             \
  template void set_fading(Model<dim>&);                                                                                                   \
  template Real longest_pressure_period(const Model<dim>&, const std::vector<bodies::Particles<dim>>&);                                    \
  template void limit_equilibrium(const settings::Case&, Model<dim>&, const std::vector<bodies::Particles<dim>>&);                         \
  template Real velocity_at_rest(const Model<dim>&, const settings::StageSettings&);                                                       \
  template bool in_balance(const Model<dim>&, const State<dim>&, Real);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::problem
