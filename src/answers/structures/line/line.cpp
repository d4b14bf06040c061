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

/// A number of a stage's end that no other stage goes beyond.
struct Extreme {
  Real value = nan;
  std::string stage, name;  ///< of its quantity
};

template <class Beyond>
Extreme extreme_of(const record::RunRecord& run, const char* number, const Beyond& is_beyond)
{
  Extreme found;
  for (const StageEnd& end : stage_ends(run)) {
    const std::string name = fmt::format("{}.{}", end.name, number);
    if (const run_folder::Quantity* q = run.quantity(name); q != nullptr && (found.stage.empty() || is_beyond(q->value, found.value)))
      found = {q->value, text::html_text(end.name), name};
  }
  return found;
}

bool is_larger(Real a, Real b)
{
  return std::abs(a) > std::abs(b);
}

base::Headline headline_of(const record::RunRecord& run, const base::DisplayUnits&)
{
  base::Headline numbers;
  const auto add = [&](const Extreme& extreme, const char* label) {
    numbers.push_back({extreme.name, fmt::format("{} ({})", label, extreme.stage)});
  };
  add(extreme_of(run, "y", is_larger), "Largest lateral displacement");
  add(extreme_of(run, "P", std::greater<>()), "Largest effective compression at x = 0");
  add(extreme_of(run, "M", is_larger), "Largest bending moment");
  add(extreme_of(run, "strain_min", std::less<>()), "Largest compressive strain");
  return numbers;
}

/// The extremes of all stages, and in which they came: the numbers of each stage are in the table.
std::string words_of(const record::RunRecord& run, const base::DisplayUnits&)
{
  const Extreme y = extreme_of(run, "y", is_larger);
  if (y.stage.empty()) return "The line has not been loaded yet.";
  const Extreme P = extreme_of(run, "P", std::greater<>()), M = extreme_of(run, "M", is_larger),
                tension = extreme_of(run, "strain_max", std::greater<>()), compression = extreme_of(run, "strain_min", std::less<>());
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
        .headline = headline_of,
        .words = words_of,
        .published = published_beside,
        .other_results = [](Run run, const std::string& id) { return page_tables(run, id); },
        .measures = generic::measures_of_any_run,
        .draw_report_curves = [](const base::Runs& runs, const base::PublishedPoints&,
                                 const std::filesystem::path& folder) { return draw_load_figures(runs, folder); }}},
      [](const settings::Case& c) { return c.pipeline.has_value(); }};
}

}  // namespace berm::line
