// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "structures/driven/report/report.hpp"

#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::driven {
namespace {

const run_folder::Uncertainty* uncertainty_of(const DrivenRun& run)
{
  return run.record.summary && run.record.summary->uncertainty ? &*run.record.summary->uncertainty : nullptr;
}

/// "0.68 ± 0.05", or "" without a band.
std::string with_half_width(const DrivenRun& run, const std::string& quantity, const base::DisplayUnits& shown)
{
  const run_folder::Uncertainty* uncertainty = uncertainty_of(run);
  const run_folder::Band* band = uncertainty == nullptr ? nullptr : uncertainty->find(quantity);
  return band == nullptr ? "" : text::with_half_width(shown.in_force_unit(band->converged), shown.in_force_unit(band->half_width));
}

bool some_have_bands(const DrivenRuns& runs)
{
  return std::any_of(runs.begin(), runs.end(), [](const DrivenRun& run) {
    const run_folder::Uncertainty* uncertainty = uncertainty_of(run);
    return uncertainty != nullptr && !uncertainty->quantities.empty();
  });
}

}  // namespace

std::string converged_words(const DrivenRun& run, const std::string& quantity, const base::DisplayUnits& shown)
{
  const std::string words = with_half_width(run, quantity, shown);
  return words.empty() ? "" : fmt::format(", converged {} {}", words, shown.force_unit(run.scale));
}

std::vector<text::HtmlCell> converged_column(const DrivenRuns& runs, const std::string& symbol, const base::DisplayUnits& shown)
{
  return some_have_bands(runs) ? std::vector<text::HtmlCell>{shown.force_columns(symbol + " converged").front()}
                               : std::vector<text::HtmlCell>{};
}

std::vector<text::HtmlCell> converged_cell(const DrivenRuns& runs, const DrivenRun& run, const std::string& quantity,
                                           const base::DisplayUnits& shown)
{
  return some_have_bands(runs) ? std::vector<text::HtmlCell>{{with_half_width(run, quantity, shown), true}} : std::vector<text::HtmlCell>{};
}

std::string converged_notes(const DrivenRuns& runs)
{
  std::string notes;
  if (some_have_bands(runs))
    notes += text::html_paragraph("Converged: for cells without size, from the run and coarser ones, with the half width of a band that is "
                                  "meant to hold the answer of this soil law and this "
                                  "case nineteen times in twenty. It holds what cells, meshes, noise and speed do to the numbers, not what "
                                  "the soil law or its parameters do.",
                                  "quiet");
  for (const DrivenRun& run : runs)
    if (const run_folder::Uncertainty* uncertainty = uncertainty_of(run); uncertainty != nullptr && !uncertainty->missing.empty())
      notes += text::html_paragraph(
          fmt::format("{} was asked how sure its results are, and has no bands: {}.", run.name, uncertainty->missing), "quiet");
  return notes;
}

}  // namespace berm::driven
