// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/made_push.hpp"

namespace berm {

/// A pile of 2 m that stands 8 m in the bed turns about a point 5 m below it, under a load of 100 MN times its tilt that acts 4 m above the bed along `sign` x,
/// and a weight that hangs there.
struct MadePile {
  static constexpr Real height = 4, pivot = 5,
                        depth_of_centre = 2;  // m, of the load above the bed, of what stays and of the centre below it
  Real sign = 1, weight = 0;

  record::RunRecord record() const
  {
    MadePush made;
    made.geometry = settings::Geometry::space;
    made.shape = bodies::CylinderSettings{{0, -depth_of_centre, 0}, {0, 1, 0}, 2, 12};
    record::RunRecord run;
    run.name = "made";
    run.settings = made.settings();
    run.settings.gravity = {0, -standard_gravity, 0};
    settings::StageSettings rest, push_over;
    rest.name = "rest", rest.kind = settings::StageKind::geostatic;
    push_over.name = "push_over", push_over.kind = settings::StageKind::drive, push_over.rigid = "probe";
    push_over.drive.x.velocity = sign * 0.2;
    push_over.drive.rotation_z.free = true;
    run.settings.stage = {rest, push_over};
    const std::vector<std::string> names{"time_s", "u_m",  "w_m",   "H_N",   "V_N",   "Fx_N",       "Fy_N",       "Fz_N",      "dx_m",
                                         "dy_m",   "dz_m", "Mx_Nm", "My_Nm", "Mz_Nm", "anglex_rad", "angley_rad", "anglez_rad"};
    run.history = {columns_named(names), std::vector<std::vector<Real>>(names.size()), {}};
    for (int k = -5; k <= 40; ++k) {
      const Real tilt = std::max(0, k) * 1e-3, H = 100e6 * tilt, d = (pivot - depth_of_centre) * std::sin(tilt);
      // About the centre the load and the weight have the moment of both across the axis, times the distance along it; the soil the opposite.
      const Real M = (height + depth_of_centre) * (H + weight * std::tan(tilt));
      const std::vector<Real> row{k + 5., sign * d, 8, sign * H, weight,   -sign * H, weight, 0,           sign * d,
                                  0,      0,        0, 0,        sign * M, 0,         0,      -sign * tilt};
      for (std::size_t c = 0; c < names.size(); ++c) run.history.values[c].push_back(row[c]);
      run.history.stage.emplace_back(k <= 0 ? "rest" : "push_over");
    }
    run.quantities = structures::structure_of(run.settings).quantities(run, {});
    run.end = record::RunEnd::finished;
    return run;
  }
};

}  // namespace berm
