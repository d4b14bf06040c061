// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/made_run.hpp"

namespace berm {

/// A pipe of 20 mm in clay that was never run: it touches down with 800 N/m at 0.1 D, is laid by two drags of 0.1 D to 0.3 D, is unloaded to 300 N/m at 0.29 D,
/// elastically, and swept out by 2 D and back: H peaks with 200 N/m at 0.2 D, stays at 100 N/m, and on the way back, without a peak, at 80 N/m until it grows to 160
/// N/m in the last half D.
inline record::RunRecord lived_pipe()
{
  MadeRun made;
  made.gravity_level = 1;
  made.law = MadeRun::clay_law();
  made.contact.friction_angle = 0;
  made.contact.adhesion_factor = 0.4;
  made.dragged = 0;
  record::RunRecord run = made.record();
  settings::Case& c = run.settings;
  const Real D = made.D, step = 0.002 * D;
  c.stage[0].until.force = 800;
  const auto add_stage = [&](const char* name, Real velocity, Real displacement) {
    c.stage.push_back(MadeRun::stage_of(name, settings::StageKind::drag));
    c.stage.back().velocity = velocity;
    c.stage.back().until.displacement = displacement;
  };
  const auto add = [&](const char* stage, Real u, Real w, Real H, Real V) {
    const Real row[] = {static_cast<Real>(run.history.rows()), u, w, H, V};
    for (int k = 0; k < 5; ++k) run.history.values[k].push_back(row[k]);
    run.history.stage.emplace_back(stage);
  };
  add_stage("lay_1", 0.1, 0.1 * D);
  add_stage("lay_2", -0.1, 0.1 * D);
  for (int k = 1; k <= 50; ++k) add("lay_1", k * step, (0.1 + 0.002 * k) * D, 50, 800);
  for (int k = 1; k <= 50; ++k) add("lay_2", (50 - k) * step, (0.2 + 0.002 * k) * D, -50, 800);
  c.stage.push_back(MadeRun::stage_of("unload", settings::StageKind::push));
  c.stage.back().velocity.reset();
  c.stage.back().force = 300;
  for (int k = 1; k <= 100; ++k) add("unload", 0, 0.3 * D - std::min(1., k / 50.) * 0.01 * D, 0, 800 - std::min(1., k / 50.) * 500);
  add_stage("sweep_1", 0.1, 2 * D);
  add_stage("sweep_2", -0.1, 2 * D);
  const auto out = [](Real u) { return u < 0.2 ? 1000 * u : u < 0.5 ? std::lerp(200., 100., (u - 0.2) / 0.3) : 100; };
  const auto back = [](Real u) { return u < 0.2 ? 400 * u : u < 1.5 ? 80 : std::min(160., std::lerp(80., 160., (u - 1.5) / 0.1)); };
  for (int k = 1; k <= 1000; ++k) add("sweep_1", k * step, 0.29 * D, out(0.002 * k), 300);
  for (int k = 1; k <= 1000; ++k) add("sweep_2", 2 * D - k * step, 0.29 * D, -back(0.002 * k), 300);
  run.quantities = structures::structure_of(c).quantities(run, {});
  return run;
}

}  // namespace berm
