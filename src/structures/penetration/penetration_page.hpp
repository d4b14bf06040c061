// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/display_units.hpp"
#include "structures/penetration/penetration_run.hpp"

namespace berm::penetration {

/// What a run met, in some sentences, HTML: depth, resistance, factor, whether it is steady, and what the numbers hold.
std::string penetration_words(const PenetrationRun& run, const base::DisplayUnits& shown);

/// The log of the runs and their key results as tables, HTML; `id` begins the names of the tables.
std::string penetration_key_results(const PenetrationRuns& runs, const std::string& id);

/// What is exact or published beside the runs, with its heading, HTML; "" where there is nothing. What is only recalled is not shown.
std::string penetration_published(const PenetrationRuns& runs, const std::string& id);

}  // namespace berm::penetration
