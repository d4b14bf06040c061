// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/display_units.hpp"
#include "structures/base/headline.hpp"
#include "structures/driven/driven_run.hpp"

namespace berm::pipe {

/// The numbers that are asked of a pipe, with what design codes give beside them where they apply.
base::Headline headline(const record::RunRecord& run, const base::DisplayUnits& shown);

/// What pipes in soil with water could carry along their axis by friction at the ends of stages, beside the published wedging factor, as an HTML table; "" where no run has it.
std::string axial_table(const driven::DrivenRuns& runs, const base::DisplayUnits& shown);

/// What rests in which soil consolidates do to that resistance, a sentence each, HTML; "" without any.
std::string consolidation_words(const driven::DrivenRun& run, const base::DisplayUnits& shown);

/// What design codes and published formulas give beside the runs, as HTML with its heading: of each run remarks, then a table with its states as groups. Of
/// several runs each can be folded away; the first stands open. "" where there is none.
std::string published_values(const driven::DrivenRuns& runs, const base::DisplayUnits& shown);

}  // namespace berm::pipe
