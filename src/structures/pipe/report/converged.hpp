// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/display_units.hpp"
#include "structures/pipe/results/pipe_run.hpp"

namespace berm::pipe {

/// How sure a force of a run is, HTML. A run that was not asked, or a quantity that has no band, gives "" and an empty cell.

/// ", converged 0.68 ± 0.05 kN/m".
std::string converged_words(const PipeRun& run, const std::string& quantity, const base::DisplayUnits& shown);

/// The column "V converged, kN/m" and its cell "0.68 ± 0.05"; nothing where none of the runs has bands.
std::vector<text::HtmlCell> converged_column(const PipeRuns& runs, const std::string& symbol, const base::DisplayUnits& shown);
std::vector<text::HtmlCell> converged_cell(const PipeRuns& runs, const PipeRun& run, const std::string& quantity,
                                           const base::DisplayUnits& shown);

/// What the column means, and why a run that was asked has no bands, as paragraphs; "" where no run was asked.
std::string converged_notes(const PipeRuns& runs);

}  // namespace berm::pipe
