// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "text/html.hpp"
#include "structures/pipe/run_record.hpp"

namespace berm {

/// Soil, pipe, interface, mesh and stages of all runs in a few rows; lengths and forces of the prototype in brackets where the model is not under one
/// gravity.
HtmlTable compact_table(const std::vector<RunRecord>& runs);

/// How the runs were computed: version, date, machine, threads, time, cells, particles, steps.
HtmlTable computation_table(const std::vector<RunRecord>& runs);

/// The size of the cells (finite elements: of the elements) at the driven body, m; NaN where it is not known.
Real near_cell_size(const Case& settings);

/// Particles a cell there, of the body that it touches; NaN where it is not known or there are none. Of a block or disk: particles per square of the cell size.
Real near_particles(const Case& settings);

}  // namespace berm
