// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "structures/driven/report.hpp"

#include "structures/base/errors_of_methods.hpp"
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

/// Numbers with grains beside those without, forces and lengths in the page's units.
std::string grains_table(const DrivenRun& run, const run_folder::Grains& grains)
{
  text::HtmlTable table(
      fmt::format("grains-{}", run.number),
      fmt::format("{}: its sand has no d50. On cells {} times as large, with grains", run.name, text::short_number(grains.size)));
  std::vector<text::HtmlCell> columns = {{"result"}, {"without", true}};
  for (const Real d50 : grains.d50) columns.push_back({fmt::format("d<sub>50</sub> = {}", text::length_words(d50)), true});
  table.columns(std::move(columns));
  for (const auto& [name, unit, without, with] : grains.numbers) {
    const Real per_si = unit == "m" ? 1000 : 1;
    const std::string shown = unit == "m" ? ", mm" : unit == "1" ? "" : ", " + unit;
    std::vector<text::HtmlCell> row = {{text::html_text(name + shown)}, {text::table_number(without * per_si), true}};
    for (const Real number : with) row.push_back({text::table_number(number * per_si), true});
    table.row(std::move(row));
  }
  return table.html();
}

/// How far a pipe pushed into clay by the material point method is from zero cell size, where no run of the page tells; "" elsewhere.
std::string error_of_cells_note(const DrivenRun& run)
{
  const bool known = run.settings.method == settings::Method::mpm && run.settings.geometry == settings::Geometry::plane_strain &&
                     run.scale.strength > 0 && base::circle_of(run.settings) && !path_of(run.history, run.stages).push.rows.empty();
  const Real cell = base::near_cells(run.record).first / run.scale.width;
  const run_folder::Uncertainty* bands = uncertainty_of(run);
  if (!known || (bands != nullptr && !bands->quantities.empty()) || !(cell > 0)) return "";
  const base::ErrorOfSize& coarse = base::errors_of_cells.front();
  return text::html_paragraph(
      fmt::format("{}: on cells of D/{:.3g} V of a push into clay is some {:.2g} % above its value at zero cell size, and the embedment "
                  "under a given V too small (first order in the cells, examples/two_methods). berm run --uncertainty extrapolates both.",
                  run.name, 1 / cell, 100 * coarse.of_V * coarse.n * cell),
      "quiet");
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
  for (const DrivenRun& run : runs) notes += error_of_cells_note(run);
  if (some_have_bands(runs))
    notes += text::html_paragraph(
        "Converged: extrapolated to zero cell size from this run and others of finer or coarser cells, with the half width of a 95 % "
        "confidence band for this soil law and this case. The band covers the effects of cell size, mesh, noise "
        "and speed, not those of the soil law or its parameters.",
        "quiet");
  for (const DrivenRun& run : runs)
    if (const run_folder::Uncertainty* uncertainty = uncertainty_of(run); uncertainty != nullptr && !uncertainty->grains.numbers.empty())
      notes +=
          text::html_paragraph("Sand with psi below phi that has no d50 forms shear bands whose width is set by the cells. The narrower "
                               "those of the sand are, the smaller its resistance: give its d50, and the band is that of its own result.",
                               "quiet") +
          grains_table(run, uncertainty->grains);
  for (const DrivenRun& run : runs)
    if (const run_folder::Uncertainty* uncertainty = uncertainty_of(run); uncertainty != nullptr && !uncertainty->missing.empty())
      notes += text::html_paragraph(fmt::format("{} was run with --uncertainty, and has no bands: {}.", run.name, uncertainty->missing),
                                    "quiet");
  return notes;
}

}  // namespace berm::driven
