// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/read_case.hpp"
#include "record/run_record.hpp"

#include <string>

namespace berm {

/// The probe test, small: a pipe of 20 mm on a bed of 650 mm by 140 mm at 50 g, pushed 2 mm and dragged 20 mm; cells of D/20.
inline settings::Case sample_case(const std::vector<std::string>& changes = {}, const std::string& more = "")
{
  return input::read_case_text("case.toml", R"(title = "a pipe"
gravity = [0, "-50 gravity"]
[mesh]
kind = "seabed"
length = "650 mm"
depth = "140 mm"
headroom = "30 mm"
near_size = "1 mm"
near_left = "-22 mm"
near_right = "64 mm"
near_depth = "26 mm"
near_height = "14 mm"
layer = "14 mm"
[material.sand]
law = "mohr_coulomb"
density = "877 kg/m^3"
young_modulus = "7 MPa"
poisson_ratio = 0.25
friction_angle = "35 deg"
[body.sand]
material = "sand"
regions = ["near", "bed", "layer"]
particles_per_cell = 9
k0 = 0.43
[rigid.pipe]
shape = "circle"
center = [0, "10 mm"]
diameter = "20 mm"
mass = "1 kg/m"
[contact.skin]
body = "sand"
rigid = "pipe"
friction_angle = "23.33 deg"
[support.base]
boundary = "base"
fixed = ["x", "y"]
[support.left]
boundary = "left"
fixed = ["x"]
[[stage]]
name = "geostatic"
kind = "geostatic"
until.time = "5 ms"
[[stage]]
name = "push"
kind = "push"
velocity = "0.1 m/s"
until.embedment = "2 mm"
[[stage]]
name = "drag"
kind = "drag"
velocity = "0.1 m/s"
until.displacement = "20 mm"
)" + more,
                               changes);
}

/// The same in sand whose water flows.
inline settings::Case sample_case_in_water(std::vector<std::string> changes = {})
{
  changes.insert(changes.end(), {"material.sand.inertia_density=1877", "material.sand.water.drainage=consolidation",
                                 "material.sand.water.permeability=1e-5", "material.sand.water.porosity=0.4"});
  return sample_case(changes);
}

/// A record of a run of a case, with a summary in which all is well, and no history.
inline record::RunRecord sample_record(const settings::Case& settings, const std::string& name = "sample")
{
  record::RunRecord run;
  run.name = name;
  run.settings = settings;
  run.end = record::RunEnd::finished;
  run.begun = "2026-01-31 12:00:00";
  run.quantities = {{"V_noise", 0.01, "1"},
                    {"H_noise", 0.05, "1"},
                    {"V_rms_error_in_drag", 0.02, "1"},
                    {"overlap_max_over_D", 0, "1"},
                    {"second_impulse_over_V", 0.001, "1"},
                    {"gap_mean", 5e-5, "m"},
                    {"gap_mean_over_D", 0.0025, "1"}};
  run_folder::RunSummary summary;
  summary.quantities = run.quantities;
  summary.timing = {
      {"wall_s", 10}, {"threads", 1}, {"cells", 100}, {"particles", 900}, {"nodes", 60}, {"steps", 1000}, {"particle_steps_per_s", 9e4}};
  summary.checks = {{"finished", 1},           {"energy_error", 0.004},      {"out_of_balance_after_geostatic", 0.001},
                    {"momentum_error", 1e-16}, {"friction_work_is_loss", 1}, {"largest_unbalance", 5e-4},
                    {"loose_increments", 0},   {"strength_lag", 0.004},      {"largest_overstress", 0.002},
                    {"shaking_at_body", 0.02}, {"mass_at_min_volume", 0},    {"mass_at_max_volume", 0},
                    {"mass_in_the_air", 0}};
  summary.text = {{"version", "0.1.0"}};
  run.summary = summary;
  return run;
}

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

}  // namespace berm
