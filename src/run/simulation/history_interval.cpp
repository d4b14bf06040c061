// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_wrong_inputs_test.cpp
#include "simulation/history_interval.hpp"

#include "bodies/rigid/shape.hpp"
#include "os/error.hpp"

namespace berm::simulation {
namespace {

/// What a stage of unknown duration is taken to last, s: as long as its body needs to go its width, or a wave to cross that a hundred times.
Real typical_time(const settings::Case& c, const settings::StageSettings& stage)
{
  const Index rigid = stage.rigid.empty() ? main_rigid(c) : index_of(c.rigid, stage.rigid);
  Real width = 0;
  if (rigid != none) {
    const bodies::RigidShapeSettings& shape = c.rigid[rigid].second.shape;
    width = c.dimension() == 2 ? width_of<2>(bodies::make_shape<2>(shape)) : width_of<3>(bodies::make_shape<3>(shape));
  }
  if (width > 0 && stage.velocity && *stage.velocity != 0) return width / std::abs(*stage.velocity);
  constexpr Real crossings = 100;
  const material::Material& material = c.material.front().second;
  return crossings * (width > 0 ? width : 1) / std::sqrt(p_wave_modulus(material) / inertia_density(material));
}

}  // namespace

Real history_interval_of(const settings::Case& c)
{
  if (c.output.history_time) return *c.output.history_time;
  Real time = 0;
  for (const settings::StageSettings& stage : c.stage) {
    const Real expected = expected_time(stage);
    time += expected > 0 ? expected : drives(stage.kind) || ends_at_equilibrium(stage) ? typical_time(c, stage) : 0;
  }
  if (time <= 0) throw KeyError("output.history_time: is needed: no stage says how long it takes");
  return time / 1000;
}

}  // namespace berm::simulation
