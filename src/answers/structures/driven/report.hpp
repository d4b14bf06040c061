// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/display_units.hpp"
#include "structures/base/headline.hpp"
#include "structures/base/published_point.hpp"
#include "structures/base/trust_measure.hpp"
#include "structures/driven/driven_run.hpp"

namespace berm::driven {

/// Draws V(w), H(u), w(u) and H/V of all runs over one another, with what is published, as SVG and PNG. Gives the names of what was drawn.
std::vector<std::string> draw_travel_figures(const DrivenRuns& runs, const base::PublishedPoints& published,
                                             const std::filesystem::path& folder);

/// What a run's body did and met, in a few sentences, HTML without the run's name; `push`: what it met in its push, too.
std::string results_in_words(const DrivenRun& run, const base::DisplayUnits& shown, bool push = true);

/// The numbers that are asked of a travel: under a force how far it went, of a lift its resistance, of a drag breakout and residual, of a push V and w.
base::Headline headline(const DrivenRun& run);

/// The key results of runs as HTML tables: V of the push by embedment, H and w of the drag by displacement, and the resistance to the drag (largest H, breakout,
/// residual H). Of several runs the same point stands one below the other. "" where there is none. `push`: with V of the push.
std::string key_results(const DrivenRuns& runs, const base::DisplayUnits& shown, bool push = true);

/// Draws the soil at the end of each run and its mechanism there, and that of the material point method once more at the embedment of finite elements: SVG and
/// PNG. Gives the names of what was drawn.
std::vector<std::string> draw_soil_figures(const DrivenRuns& runs, const std::filesystem::path& folder);

/// What is looked at in a run of a case, in the order of the page.
base::TrustMeasures driven_measures(const settings::Case& c, const base::Limit* of_cells = nullptr);

/// How sure a force of a run is, HTML. A run that was not asked, or a quantity that has no band, gives "" and an empty cell.

/// ", converged 0.68 ± 0.05 kN/m".
std::string converged_words(const DrivenRun& run, const std::string& quantity, const base::DisplayUnits& shown);

/// The column "V converged, kN/m" and its cell "0.68 ± 0.05"; nothing where none of the runs has bands.
std::vector<text::HtmlCell> converged_column(const DrivenRuns& runs, const std::string& symbol, const base::DisplayUnits& shown);
std::vector<text::HtmlCell> converged_cell(const DrivenRuns& runs, const DrivenRun& run, const std::string& quantity,
                                           const base::DisplayUnits& shown);

/// What the column means, and why a run that was asked has no bands, as paragraphs; "" where no run was asked.
std::string converged_notes(const DrivenRuns& runs);

}  // namespace berm::driven
