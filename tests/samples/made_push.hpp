// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/kind.hpp"
#include "structures/structures.hpp"

#include "material/mohr_coulomb.hpp"
#include "samples/history_columns.hpp"
#include <functional>

namespace berm {

/// A run that was never run: a body of D = 0.2 m around an axis is pushed by 2 m from where its lowest point is at the surface, along a resistance q(z) that is
/// given, z being the depth of its level of full width. Tresca's clay of s_u = 10 kPa, G/s_u = 100, 5 kN/m3, k0 = 1; rows 0.01 D apart.
struct MadePush {
  Real D = 0.2, pushed_to = 2;  ///< m
  Real first_w = 0;             ///< m
  settings::Geometry geometry = settings::Geometry::axisymmetric;
  bodies::RigidShapeSettings shape = cone();
  material::MohrCoulomb law = clay();
  contact::ContactSettings contact = smooth();
  std::optional<Real> k0 = 1;
  settings::Method method = settings::Method::fem;  ///< without noise: nothing is averaged
  std::function<Real(Real z)> shaft = {};  ///< N, V_shaft at z: V is q over the area and this; without it the history has no such column
  std::function<Real(Real z)> q = [](Real) { return 100e3; };
  std::string name = "made";

  /// Of 60 degrees, its tip at y = 0.
  static bodies::ProfileSettings cone()
  {
    const Real up = 0.1 / std::tan(30 * degree);
    return {{0, 0.1, 0.1, 0}, {0, up, 3, 3}};
  }
  static material::MohrCoulomb clay()
  {
    material::MohrCoulomb law;
    law.density = 5000 / standard_gravity;
    law.young_modulus = 2.9e6;
    law.poisson_ratio = 0.45;
    law.cohesion = 10e3;
    return law;
  }
  static material::MohrCoulomb sand()
  {
    material::MohrCoulomb law = clay();
    law.cohesion = 0;
    law.friction_angle = law.dilation_angle = 30 * degree;
    return law;
  }
  static contact::ContactSettings smooth()
  {
    contact::ContactSettings contact;
    contact.body = "soil";
    contact.rigid = "probe";
    return contact;
  }

  settings::Case settings() const
  {
    settings::Case c;
    c.title = name;
    c.method = method;
    c.geometry = geometry;
    c.gravity = {0, -standard_gravity};
    mesh::SeabedMesh bed;
    bed.left = 0;
    bed.length = 4;
    bed.depth = 4;
    c.mesh = bed;
    c.material = {{"soil", law}};
    c.body = {{"soil", {}}};
    c.body[0].second.material = "soil";
    c.body[0].second.k0 = k0;
    c.rigid = {{"probe", {}}};
    c.rigid[0].second.shape = shape;
    c.contact = {{"skin", contact}};
    settings::StageSettings push;
    push.name = "push";
    push.kind = settings::StageKind::push;
    push.rigid = "probe";
    push.velocity = 0.1;
    c.stage.push_back(push);
    return c;
  }

  /// The height of the level of full width above the lowest point, and the area, of the whole body.
  Real shoulder() const { return base::body_profile(shape)->shoulder; }
  Real area() const { return geometry == settings::Geometry::plane_strain ? D : pi * D * D / 4; }

  run_folder::History history() const
  {
    const std::string V = geometry == settings::Geometry::plane_strain ? "V_N_m" : "V_N",
                      H = geometry == settings::Geometry::plane_strain ? "H_N_m" : "H_N";
    std::vector<std::string> names{"time_s", "u_m", "w_m", H, V};
    if (shaft) names.emplace_back("V_shaft_N");
    run_folder::History h{columns_named(names), std::vector<std::vector<Real>>(names.size()), {}};
    const Real step = 0.01 * D;
    for (int k = 0; first_w + k * step <= pushed_to + step / 2; ++k) {
      const Real w = first_w + k * step, sides = shaft ? shaft(w - shoulder()) : 0;
      const std::vector<Real> row{static_cast<Real>(k), 0, w, 0, area() * q(w - shoulder()) + sides, sides};
      for (std::size_t c = 0; c < names.size(); ++c) h.values[c].push_back(row[c]);
      h.stage.emplace_back("push");
    }
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
