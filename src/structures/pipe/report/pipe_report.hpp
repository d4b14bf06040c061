// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/display_units.hpp"
#include "structures/base/published_point.hpp"
#include "structures/base/trust_measure.hpp"
#include "structures/pipe/results/pipe_run.hpp"

namespace berm::pipe {

/// What pipes in soil with water could carry along their axis by friction at the ends of stages, beside the published wedging factor, as an HTML table; "" where no run has it.
std::string axial_table(const PipeRuns& runs, const base::DisplayUnits& shown);

/// Draws V(w), H(u), w(u) and H/V of all runs over one another, with what is published, as SVG and PNG. Gives the names of what was drawn.
std::vector<std::string> draw_curves(const PipeRuns& runs, const base::PublishedPoints& published, const std::filesystem::path& folder);

/// What a run's pipe did and met, in a few sentences, HTML without the run's name.
std::string results_in_words(const PipeRun& run, const base::DisplayUnits& shown);

/// The key results of all runs that have a pipe, as HTML tables: V of the push by embedment, H and w of the drag by displacement, and the resistance to the
/// drag (largest H, breakout, residual H). Of several runs the same point stands one below the other. "" where there is none.
std::string key_results(const PipeRuns& runs, const base::DisplayUnits& shown);

/// What design codes and published formulas give beside the runs, as HTML with its heading: of each run remarks, then a table with its states as groups. Of
/// several runs each can be folded away; the first stands open. "" where there is none.
std::string published_values(const PipeRuns& runs, const base::DisplayUnits& shown);

/// Draws the soil at the end of each run and its mechanism there, and that of the material point method once more at the embedment of finite elements: SVG and
/// PNG. Gives the names of what was drawn.
std::vector<std::string> draw_soil_figures(const PipeRuns& runs, const std::filesystem::path& folder);

/// What is looked at in a run of a case, in the order of the page.
base::TrustMeasures pipe_measures(const problem::Case& c, const base::Limit* of_cells = nullptr);

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
