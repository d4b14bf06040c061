// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/base/chart.hpp"

#include <optional>

namespace berm::report {

/// The ground of a finite element run of large deformations at its start and at the ends of stages, over one another, near the path of the body; each outline is of a
/// row of the history. Of many stages some are left out, evenly. Empty for other runs, and where there are no frames that can be read.
std::optional<base::Chart> ground_chart(const record::RunRecord& run);

}  // namespace berm::report
