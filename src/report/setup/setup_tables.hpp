// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/run_record.hpp"
#include "text/html.hpp"

namespace berm::report {

/// Soil, pipe, interface, mesh and stages of all runs in a few rows; lengths and forces of the prototype in brackets where the model is not under one
/// gravity.
text::HtmlTable compact_table(const std::vector<pipe::RunRecord>& runs);

/// How the runs were computed: version, date, machine, threads, time, cells, particles, steps.
text::HtmlTable computation_table(const std::vector<pipe::RunRecord>& runs);

/// The size of the cells (finite elements: of the elements) at the driven body, m; NaN where it is not known.
Real near_cell_size(const problem::Case& settings);

/// Particles a cell there, of the body that it touches; NaN where it is not known or there are none. Of a block or disk: particles per square of the cell size.
Real near_particles(const problem::Case& settings);

}  // namespace berm::report
