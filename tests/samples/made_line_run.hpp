// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/history_columns.hpp"
#include "samples/pipeline_case.hpp"
#include "samples/temporary_folder.hpp"

#include "record/run_record.hpp"

#include <cmath>
#include <fmt/format.h>

namespace berm::test {

/// A run of a pipeline that is heated, cooled and heated again: made numbers by row, and the shape of a buckle of given lobes at the end of each stage.
struct MadeLineRun {
  static constexpr Real hot = 32, cold = 2;  // K
  static constexpr Real lobe = 40, second = 25,
                        slip_end = 400;  // m, of the first lobe in all, of that beside it, and to where the line slips
  static constexpr Real expansion = 1.17e-5, young = 206e9, wall = 0.015;
  std::vector<std::string> stages{"heat", "cool", "heat_2"};
  std::vector<Real> y{1.9, 1.3, 2.0};          // m, at the ends of the stages
  std::vector<Real> fed_in{0.10, 0.04, 0.11};  // m, of u at the end of the lobes
  bool springs = false;

  settings::Case settings() const
  {
    settings::Case c = line_case();
    settings::PipelineSettings& p = *c.pipeline;
    p.bending_stiffness = p.axial_stiffness = {};
    p.wall = wall, p.young_modulus = young, p.expansion = expansion;
    p.length = 1500, p.end = settings::LineEnd::anchored;
    p.imperfection = {0.4, 60}, p.slices.spacing = 8, p.slices.to = 64;
    p.far_soil = {};
    p.far_soil.friction = p.far_soil.axial_friction = 0.6;
    p.far_soil.mobilisation = 5e-3;
    settings::StageSettings loaded = c.stage.back();
    c.stage.pop_back();
    loaded.pipeline = {};
    for (const std::string& name : stages) loaded.name = name, c.stage.push_back(loaded);
    return c;
  }

  static Real steel() { return pi / 4 * (0.4 * 0.4 - 0.37 * 0.37); }  // m2

  /// Sideways, m: the first lobe is a cosine, that beside it a sine, then the axis.
  Real sideways(Real x, Real crown) const
  {
    if (x < lobe / 2) return crown * std::cos(pi * x / lobe);
    return x < lobe / 2 + second ? -0.4 * crown * std::sin(pi * (x - lobe / 2) / second) : 0;
  }

  /// Rows every K, as 0.1 s each; the shapes go to line.csv of the folder.
  record::RunRecord record(const TemporaryFolder& folder) const
  {
    record::RunRecord run;
    run.name = "made", run.folder = folder.path(), run.settings = settings();
    std::vector<std::string> names{"time_s",    "u_m",       "w_m",      "H_N_m",    "V_N_m",     "line_T_K",
                                   "line_p_Pa", "line_P0_N", "line_P_N", "line_y_m", "line_M_Nm", "line_strain_min"};
    if (springs)
      for (const char* name : {"springs_y_m", "springs_P_N", "springs_M_Nm"}) names.emplace_back(name);
    run.history = {columns_named(names), std::vector<std::vector<Real>>(names.size()), {}};
    std::string shapes = "frame,time_s,stage,x_m,y_m,z_m,u_m,P_N,M_Nm,strain_max,strain_min\n";
    Real time = 0, T = 0, at = 0.4;
    for (std::size_t s = 0; s < stages.size(); ++s) {
      const Real target = s % 2 == 0 ? hot : cold, from = T, y_from = at;
      for (int k = 1; k <= 10; ++k) {
        T = from + (target - from) * k / 10, at = y_from + (y[s] - y_from) * k / 10, time += 0.1;
        std::vector<Real> row{time, at - 0.4, 0.04, 900, 1500, T, 0, young * steel() * expansion * T, 6e5, at, 5e5, -1e-3};
        if (springs) row.insert(row.end(), {1.1 * at, 5e5, 6e5});
        for (std::size_t c = 0; c < names.size(); ++c) run.history.values[c].push_back(row[c]);
        run.history.stage.push_back(stages[s]);
      }
      for (Real x = 0; x <= 1500; x += 2) {
        const Real u = x < slip_end ? -fed_in[s] * (1 - x / slip_end) : 0;
        shapes += fmt::format("{},{},{},{},{},0,{},6e5,5e5,0.0016,-0.001\n", s, time, stages[s], x, sideways(x, y[s]), u);
      }
    }
    folder.write("line.csv", shapes);
    return run;
  }
};

}  // namespace berm::test
