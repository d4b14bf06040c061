// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/history_columns.hpp"
#include "samples/pipeline_case.hpp"
#include "samples/temporary_folder.hpp"

#include "record/run_record.hpp"

#include <fmt/format.h>

namespace berm {

/// The folder of a run of samples/pipeline_case.toml whose line.csv is made up: nodes at x = 0, 1, ..., the first frames of the stage "unload", the others of "current".
class MadeLine {
public:
  static constexpr Index unload_frames = 2;
  TemporaryFolder folder;
  record::RunRecord run;

  MadeLine(Index frames, Index nodes)
  {
    run.folder = folder.path();
    run.settings = test::line_case();
    std::string text = "frame,time_s,stage,x_m,y_m,z_m,u_m,P_N,M_Nm,strain_max,strain_min\n";
    for (Index f = 0; f < frames; ++f)
      for (Index k = 0; k < nodes; ++k)
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", f, time(f), stage(f), k, y(f, k), -0.01 * f, 0.001 * k, P(f, k),
                            -2 * P(f, k), 1e-4 * f, -2e-4 * f);
    folder.write("line.csv", text);
    run.history.columns = columns_named({"time_s", "u_m", "slice_1_u_m", "slice_2_u_m", "slice_3_u_m"});
    run.history.values.assign(5, {0});
    run.history.stage = {"unload"};
  }

  static Real time(Index f) { return 0.5 * f; }
  static std::string stage(Index f) { return f < unload_frames ? "unload" : "current"; }
  /// Sideways up to x = 3 m.
  static Real y(Index f, Index k) { return k > 3 ? 0 : 0.1 * f * (4 - k); }
  static Real P(Index f, Index k) { return 1e5 + 1e3 * f - 10. * k; }
};

}  // namespace berm
