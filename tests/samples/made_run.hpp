// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/structures.hpp"

#include "material/mohr_coulomb.hpp"
#include "samples/history_columns.hpp"
#include <functional>

namespace berm {

/// A run that was never run: a pipe of 20 mm is pushed from first_w to pushed_to and dragged by `dragged`, along curves that are given. Sand of
/// phi = psi = 35 deg with delta = 2/3 phi, effective unit weight 430 kN/m3 at 50 g.
struct MadeRun {
  std::string name = "made";
  Real D = 0.02, first_w = 0, pushed_to = 0.002, dragged = 0.01;  ///< m; no push where pushed_to is first_w
  Real left = 0.3;                                                ///< m from the wall to the pipe
  Real gravity_level = 50, held_V = 800;                          ///< N/m
  bool settles = true;                                            ///< whether a geostatic stage comes before the push
  material::MohrCoulomb law = sand_law();
  contact::ContactSettings contact = contact_law();
  settings::Method method = settings::Method::mpm;
  std::function<Real(Real w)> V = [](Real w) { return 4e5 * w; };
  std::function<Real(Real u)> H = [](Real u) { return 3e4 * u; };
  std::function<Real(Real u)> sunk = [](Real u) { return u / 2; };

  static material::MohrCoulomb sand_law()
  {
    material::MohrCoulomb law;
    law.density = 430e3 / (50 * standard_gravity);
    law.young_modulus = 7e6;
    law.poisson_ratio = 0.25;
    law.friction_angle = law.dilation_angle = 35 * degree;
    return law;
  }
  /// Clay with s_u = 1 kPa.
  static material::MohrCoulomb clay_law()
  {
    material::MohrCoulomb law = sand_law();
    law.friction_angle = law.dilation_angle = 0;
    law.cohesion = 1000;
    return law;
  }
  static contact::ContactSettings contact_law()
  {
    contact::ContactSettings contact;
    contact.body = "soil";
    contact.rigid = "pipe";
    contact.friction_angle = 70. / 3 * pi / 180;
    return contact;
  }

  static settings::StageSettings stage_of(const std::string& stage_name, settings::StageKind kind)
  {
    settings::StageSettings stage;
    stage.name = stage_name;
    stage.kind = kind;
    stage.rigid = "pipe";
    stage.velocity = 0.1;
    return stage;
  }

  settings::Case settings() const
  {
    settings::Case c;
    c.title = name;
    c.method = method;
    c.gravity = {0, -gravity_level * standard_gravity};
    mesh::SeabedMesh bed;
    bed.length = 0.65;
    bed.left = left;
    c.mesh = bed;
    c.material = {{"soil", law}};
    c.body = {{"soil", {}}};
    c.body[0].second.material = "soil";
    c.rigid = {{"pipe", {}}};
    c.rigid[0].second.shape = bodies::CircleSettings{{0, D / 2 - first_w}, D};
    c.contact = {{"skin", contact}};
    if (pushed_to > first_w) c.stage.push_back(stage_of("push", settings::StageKind::push));
    if (dragged > 0) c.stage.push_back(stage_of("drag", settings::StageKind::drag));
    return c;
  }

  /// Rows 0.002 D apart.
  run_folder::History history() const
  {
    run_folder::History h{columns_named({"time_s", "u_m", "w_m", "H_N_m", "V_N_m"}), std::vector<std::vector<Real>>(5), {}};
    const auto add = [&](const std::string& stage, Real u, Real w, Real H_here, Real V_here) {
      const Real row[] = {static_cast<Real>(h.rows()), u, w, H_here, V_here};
      for (int k = 0; k < 5; ++k) h.values[k].push_back(row[k]);
      h.stage.push_back(stage);
    };
    add(settles ? "geostatic" : "push", 0, first_w, 0, pushed_to > first_w ? V(first_w) : held_V);
    const Real step = 0.002 * D;
    for (int k = 1; first_w + k * step <= pushed_to + step / 2; ++k) add("push", 0, first_w + k * step, 0, V(first_w + k * step));
    for (int k = 1; k * step <= dragged + step / 2; ++k) add("drag", k * step, pushed_to + sunk(k * step), H(k * step), held_V);
    return h;
  }

  record::RunRecord record() const
  {
    record::RunRecord run;
    run.name = name;
    run.settings = settings();
    run.history = history();
    run.quantities = structures::structure_of(run.settings).quantities(run, {});
    run.end = record::RunEnd::finished;
    return run;
  }
};

}  // namespace berm
