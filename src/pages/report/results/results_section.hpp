// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/quality/judgement.hpp"
#include "structures/base/display_units.hpp"
#include "structures/base/published_point.hpp"

namespace berm::report {

/// What stands beside the words on the first run, as HTML: its stages in one line, and its last picture of the soil, "" where the run folder has none. The page's
/// script adds its curves.
struct FirstLook {
  std::string stages, picture;
};

/// Key results of all runs of the page, as HTML, beside what design codes and published formulas give for the same soil. What the first run met stands first, with
/// its first look, and the other runs below it.
std::string results_section(const std::vector<record::RunRecord>& runs, const std::vector<Judgement>& judgements,
                            const FirstLook& first_look = {});

/// The numbers that the job of a run asks for, large, with their bands and what a code gives, as HTML; "" where the run has none.
std::string headline_of(const record::RunRecord& run, const base::DisplayUnits& shown);

/// The key results of cases that ran by the material point method and by finite elements of large deformations, side by side with their differences, as HTML with its
/// heading; "" where no case ran by both. Cases are the same that differ in method, size of cells and particles per cell alone. Which of both methods is more reliable
/// stands below, but for the case of the first run.
std::string two_methods(const std::vector<record::RunRecord>& runs, const std::vector<Judgement>& judgements);

/// On which method to rely for the case of the first run, and why, as a paragraph of HTML; "" where it did not run by both.
std::string reliable_method(const std::vector<record::RunRecord>& runs, const std::vector<Judgement>& judgements);

/// Puts the finite elements first where the case of the first run ran by both methods and they are the more reliable.
void lead_with_reliable_method(std::vector<record::RunRecord>& runs);

/// How the water drained in each stage, of the runs whose water flows, as HTML with its heading; "" where none does.
std::string consolidation_table(const std::vector<record::RunRecord>& runs);

/// The reactions of the supports at the ends of stages, of the runs whose history has them, as HTML with its heading; "" where none has.
std::string support_table(const std::vector<record::RunRecord>& runs);

/// Draws the figures of all runs for print, those of their structures and those over time: SVG and PNG, into a folder that is made. Gives the names of what
/// was drawn.
std::vector<std::string> draw_report_figures(const std::vector<record::RunRecord>& runs, const base::PublishedPoints& published,
                                             const std::filesystem::path& folder);

/// Draws energies and contact of each run over time, as SVG and PNG. Gives the names of what was drawn.
std::vector<std::string> draw_time_charts(const std::vector<record::RunRecord>& runs, const std::filesystem::path& folder);

}  // namespace berm::report
