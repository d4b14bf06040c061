// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::base {

/// The size of the cells (finite elements: of the elements) at the driven body, m; NaN where it is not known.
Real near_cell_size(const problem::Case& settings);

/// The same of a run: from its case, or as the run found it; and the largest that it met on its way, NaN where that was not watched.
struct NearCells {
  Real first, largest;  ///< m
};
NearCells near_cells(const record::RunRecord& run);

/// Particles a cell there, of the body that it touches; NaN where it is not known or there are none. Of a block or disk: particles per square of the cell size.
Real near_particles(const problem::Case& settings);

}  // namespace berm::base
