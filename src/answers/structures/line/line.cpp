// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/library/library_pipeline_test.cpp
#include "structures/generic/generic.hpp"
#include "structures/line/answers.hpp"
#include "structures/line/load_curves.hpp"
#include "structures/line/tables.hpp"
#include "text/html.hpp"

#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace berm::line {
namespace {

/// The extremes of all stages, and in which they came: the numbers of each stage are in the table.
std::string words_of(const record::RunRecord& run, const base::DisplayUnits&)
{
  const std::vector<StageEnd> ends = stage_ends(run);
  struct Extreme {
    Real value = nan;
    std::string stage;
  };
  const auto extreme = [&](const char* name, const auto& is_beyond) {
    Extreme found;
    for (const StageEnd& end : ends)
      if (const run_folder::Quantity* q = run.quantity(fmt::format("{}.{}", end.name, name));
          q != nullptr && (found.stage.empty() || is_beyond(q->value, found.value)))
        found = {q->value, text::html_text(end.name)};
    return found;
  };
  const auto larger = [](Real a, Real b) { return std::abs(a) > std::abs(b); };
  const Extreme y = extreme("y", larger);
  if (y.stage.empty()) return "The line has not been loaded yet.";
  const Extreme P = extreme("P", std::greater<>()), M = extreme("M", larger), tension = extreme("strain_max", std::greater<>()),
                compression = extreme("strain_min", std::less<>());
  const Real imperfection = run.settings.pipeline ? std::abs(run.settings.pipeline->imperfection.amplitude) : 0;
  return fmt::format(
      "At the ends of its stages the line is at most {:.3g} m ({}) from its straight axis{}; its effective compression at x = 0 is at "
      "most "
      "{:.4g} kN ({}), its bending moment at most {:.4g} kN m ({}), and its strains range from {:.2g} % ({}) to {:.2g} % ({}).",
      std::abs(y.value), y.stage, imperfection > 0 ? fmt::format(", {:.3g} m of which is the imperfection", imperfection) : "",
      P.value / 1e3, P.stage, std::abs(M.value) / 1e3, M.stage, 100 * compression.value, compression.stage, 100 * tension.value,
      tension.stage);
}

std::string published_beside(const base::Runs& runs, const base::DisplayUnits&)
{
  std::string tables;
  for (const base::PageRun& run : runs) tables += tables_beside(*run.record, fmt::format("beside-line-{}", run.number));
  return tables.empty() ? "" : "<h3>For comparison: theory and springs</h3>\n" + tables;
}

}  // namespace

/// A pipeline on slices of soil: what its line does under each of its loads.
base::Structure pipeline()
{
  using Run = const record::RunRecord&;
  return {
      "pipeline",
      {{.answers = [](Run run, const std::vector<Real>&) { return line_quantities(run); },
        .names = line_names,
        .table = log_tables,
        .draw_curves = [](const run_folder::RunFolder& folder, Run run, const base::CurveBands&) { return draw_load_curves(folder, run); },
        .charts = load_charts,
        .words = words_of,
        .published = published_beside,
        .other_results = [](Run run, const std::string& id) { return page_tables(run, id); },
        .measures = generic::measures_of_any_run,
        .draw_report_curves = [](const base::Runs& runs, const base::PublishedPoints&,
                                 const std::filesystem::path& folder) { return draw_load_figures(runs, folder); }}},
      [](const settings::Case& c) { return c.pipeline.has_value(); }};
}

}  // namespace berm::line
