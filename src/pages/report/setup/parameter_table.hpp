// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/write_case.hpp"
#include "record/run_record.hpp"
#include "text/html.hpp"

namespace berm::report {

/// A parameter by its dotted path, as `--set` takes it: "material.sand.friction_angle", "stage.push.until.embedment".
struct ParameterEntry {
  std::string path, value, unit, meaning;  ///< the value with nine digits, angles in degrees behind it; "not set" where it is left out
};

/// Every parameter of a case, table by table.
std::vector<ParameterEntry> parameters_of(const problem::Case& settings);

/// Every parameter of all runs: its path, a column with its value for each run, unit and meaning. Rows in which runs differ have the class "differs".
text::HtmlTable parameter_columns(const std::vector<record::RunRecord>& runs);

}  // namespace berm::report
