// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/display_units.hpp"

namespace berm::report {

/// What design codes and published formulas give beside a run, as HTML: remarks, then a table with the run's states as groups. `id` names the table.
std::string published_table(const pipe::RunRecord& run, const pipe::DisplayUnits& shown, const std::string& id);

}  // namespace berm::report
