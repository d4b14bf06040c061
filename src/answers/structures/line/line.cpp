// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/library/library_pipeline_test.cpp
#include "structures/line/line.hpp"

#include "structures/line/answers.hpp"
#include "structures/line/load_curves.hpp"
#include "structures/line/tables.hpp"
#include "text/html.hpp"

#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace berm::line {

std::vector<run_folder::Quantity> Line::quantities(const record::RunRecord& run, const std::vector<Real>&) const
{
  return line_quantities(run);
}

std::vector<std::string> Line::quantity_names(const problem::Case& c) const
{
  std::vector<std::string> names;
  for (const problem::StageSettings& stage : c.stage)
    if (stage.kind == problem::StageKind::pipeline)
      for (std::string& name : line_quantity_names(stage.name)) names.push_back(std::move(name));
  return names;
}

std::string Line::table_of(const record::RunRecord& run) const
{
  return log_tables(run);
}

bool Line::draw_curves(const run_folder::RunFolder& folder, const record::RunRecord& run, const base::CurveBands&) const
{
  return draw_load_curves(folder, run);
}

/// The extremes of all stages, and in which they came: the numbers of each stage are in the table.
std::string Line::in_words(const record::RunRecord& run, const base::DisplayUnits&) const
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

std::string Line::published_values(const base::Runs& runs, const base::DisplayUnits&) const
{
  std::string tables;
  for (const base::PageRun& run : runs) tables += tables_beside(*run.record, fmt::format("beside-line-{}", run.number));
  return tables.empty() ? "" : "<h3>For comparison: theory and springs</h3>\n" + tables;
}

std::string Line::other_results(const record::RunRecord& run, const std::string& id) const
{
  return load_chart(run) + page_tables(run, id);
}

std::vector<std::string> Line::draw_report_curves(const base::Runs& runs, const base::PublishedPoints&,
                                                  const std::filesystem::path& folder) const
{
  return draw_load_figures(runs, folder);
}

}  // namespace berm::line
