// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "text/html.hpp"

namespace berm::report {

/// Soil, rigid bodies, interface, mesh and stages of all runs in a few rows; lengths and forces of the prototype in brackets where the model is not under one
/// gravity.
text::HtmlTable compact_table(const std::vector<record::RunRecord>& runs);

/// How the runs were computed: version, date, machine, threads, time, cells, particles, steps.
text::HtmlTable computation_table(const std::vector<record::RunRecord>& runs);

}  // namespace berm::report
