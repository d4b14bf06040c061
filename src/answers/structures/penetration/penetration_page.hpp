// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/display_units.hpp"
#include "structures/penetration/penetration_run.hpp"
#include "structures/penetration/penetrometer.hpp"

namespace berm::penetration {

/// What a run met, in some sentences, HTML: depth, resistance, factor, whether it is steady, and what the numbers hold.
std::string penetration_words(const PenetrationRun& run, const base::DisplayUnits& shown);

/// The log of the runs and their key results as tables, HTML; `id` begins the names of the tables.
std::string penetration_key_results(const PenetrationRuns& runs, const base::DisplayUnits& shown, const std::string& id);

/// What is exact or published beside the runs, with its heading, HTML; "" where there is nothing. What is only recalled is not shown.
std::string penetration_published(const PenetrationRuns& runs, const std::string& id);

/// What is looked at in a run of a body that is pushed down: what any driven body has, whether the resistance is steady, and how far walls and base are.
base::TrustMeasures penetration_measures(const settings::Case& c, const Penetrometer& how);

}  // namespace berm::penetration
