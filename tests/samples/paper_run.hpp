// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/read_case.hpp"
#include "samples/history_columns.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <functional>

namespace berm::test {

/// A run of a case of examples/probe_test with a made-up history: a push to `w_push` with V(w), where the case has one, and a drag to `u_end` with H(u),
/// w(u) and the V it was pushed to. Lengths in D = 20 mm, forces in N/m.
struct PaperRun {
  std::string file = "case.toml";
  std::vector<std::string> overrides;
  double w_push = 0.1, u_end = 1;
  std::function<double(double)> V = [](double depth) { return 40000 * depth; };
  std::function<double(double)> H = [](double travel) { return 1000 * travel; };
  std::function<double(double)> w = [](double travel) { return 0.1 + 0.5 * travel; };

  record::RunRecord record(const std::string& name) const
  {
    record::RunRecord run;
    run.name = name;
    run.origin = run_folder::Origin{{}, {}, file, overrides};
    run.settings = input::read_case(std::string(BERM_SOURCE_DIR) + "/examples/probe_test/" + file, overrides);
    run.history.columns = columns_named({"time_s", "u_m", "w_m", "H_N_m", "V_N_m"});
    run.history.values.resize(5);
    const double D = 0.02;
    const auto add = [&](const char* stage, double here_u, double here_w, double here_H, double here_V) {
      const double time = run.history.rows();
      const double row[] = {time, here_u * D, here_w * D, here_H, here_V};
      for (int c = 0; c < 5; ++c) run.history.values[c].push_back(row[c]);
      run.history.stage.emplace_back(stage);
    };
    const int rows = 200;
    const bool pushes = std::any_of(run.settings.stage.begin(), run.settings.stage.end(),
                                    [](const settings::StageSettings& stage) { return stage.kind == settings::StageKind::push; });
    for (int k = 0; k <= rows && pushes; ++k) add("push", 0, k * w_push / rows, 0, V(k * w_push / rows));
    const int first = pushes ? 1 : 0;
    for (int k = first; k <= rows; ++k) add("drag", k * u_end / rows, w(k * u_end / rows), H(k * u_end / rows), V(w_push));
    run.quantities = structures::structure_of(run.settings).quantities(run, {});
    run.end = record::RunEnd::finished;
    return run;
  }
};

}  // namespace berm::test
