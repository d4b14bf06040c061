// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "text/html.hpp"

namespace berm::report {

/// The case, as HTML: for each run of the page a drawing to scale and all parameters.
std::string setup_section(const std::vector<record::RunRecord>& runs);

/// Soil, rigid bodies, interface, mesh and stages of all runs in a few rows; lengths and forces of the prototype in brackets where the model is not under one
/// gravity.
text::HtmlTable compact_table(const std::vector<record::RunRecord>& runs);

/// How the runs were computed: version, date, machine, threads, time, cells, particles, steps.
text::HtmlTable computation_table(const std::vector<record::RunRecord>& runs);

/// Strength and stiffness over depth of the bodies whose soil varies: layers, regions, gradients and profiles, a row for each part over which they are linear;
/// runs of one soil together. "" where no soil varies. HTML.
std::string soil_over_depth(const std::vector<record::RunRecord>& runs);

/// A parameter by its dotted path, as `--set` takes it: "material.sand.friction_angle", "stage.push.until.embedment".
struct ParameterEntry {
  std::string path, value, unit, meaning;  ///< the value with nine digits, angles in degrees behind it; "not set" where it is left out
};

/// Every parameter of a case, table by table.
std::vector<ParameterEntry> parameters_of(const settings::Case& settings);

/// Every parameter of all runs: its path, a column with its value for each run, unit and meaning. Rows in which runs differ have the class "differs".
text::HtmlTable parameter_columns(const std::vector<record::RunRecord>& runs);

}  // namespace berm::report
