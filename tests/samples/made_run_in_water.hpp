// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/linear_elastic.hpp"
#include "samples/made_run.hpp"

namespace berm {

/// A pipe of D = 20 mm that was pushed into elastic soil whose water flows, c_v = 4e-4 m2/s, and rests there for 6 s: D^2 / c_v = 1 s.
struct MadeRunInWater {
  static material::LinearElastic soil()
  {
    material::LinearElastic law;
    law.density = 800;
    law.young_modulus = 1e6;
    law.poisson_ratio = 0;
    law.water.emplace().drainage = material::Drainage::consolidation;
    law.water->porosity = 0.5;
    law.water->bulk_modulus = 1e12;
    law.water->permeability = 4e-4 * material::unit_weight_of_water * (1 / 1e6 + 0.5 / 1e12);
    return law;
  }

  record::RunRecord record() const
  {
    MadeRun made;
    made.dragged = 0;
    record::RunRecord run = made.record();
    run.settings.material[0].second = soil();
    settings::StageSettings rest = MadeRun::stage_of("rest", settings::StageKind::drive);
    rest.velocity.reset();
    rest.until.time = 6;
    run.settings.stage.push_back(rest);
    run_folder::History& h = run.history;
    for (const run_folder::Column& column : columns_named({"p_max_Pa", "U"})) {
      h.columns.push_back(column);
      h.values.emplace_back(h.stage.size(), 0);
    }
    const Real U[] = {0, 0.25, 0.4, 0.5, 0.6, 0.75};
    const Real begin = h.values[0].back();
    for (int k = 0; k < 6; ++k) {
      const Real row[] = {begin + k + 1, 0, 0.002, 0, 500, 1000 * (1 - U[k]), U[k]};
      for (int c = 0; c < 7; ++c) h.values[c].push_back(row[c]);
      h.stage.push_back("rest");
    }
    return run;
  }

  /// The same with an effective normal force of 100 N/m in the push, 400 N/m in the rest and 550 N/m in its last row, where V is 500 N/m.
  record::RunRecord record_with_normal_force() const
  {
    record::RunRecord run = record();
    run_folder::History& h = run.history;
    h.columns.push_back(columns_named({"N_eff_N_m"}).front());
    h.values.emplace_back();
    for (const std::string& stage : h.stage) h.values.back().push_back(stage == "rest" ? 400 : 100);
    h.values.back().back() = 550;
    return run;
  }
};

}  // namespace berm
