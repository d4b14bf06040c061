// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/library/library_pipeline_test.cpp
#include "structures/line/line.hpp"

#include "structures/line/answers.hpp"
#include "structures/line/load_curves.hpp"
#include "structures/line/tables.hpp"
#include "text/html.hpp"

#include <cmath>
#include <fmt/format.h>

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

std::string Line::in_words(const record::RunRecord& run, const base::DisplayUnits&) const
{
  std::string words;
  for (const StageEnd& end : stage_ends(run)) {
    const auto of = [&](const char* name) {
      const run_folder::Quantity* found = run.quantity(fmt::format("{}.{}", end.name, name));
      return found == nullptr ? nan : found->value;
    };
    if (std::isnan(of("y"))) continue;
    words += fmt::format("At the end of {} the line stands {:.3g} m from its axis at x = {:.3g} m, with {:.4g} kN of effective "
                         "compression, a bending moment of {:.4g} kN m and strains of {:.2g} and {:.2g} %. ",
                         text::html_text(end.name), of("y"), of("x_of_y"), of("P") / 1e3, of("M") / 1e3, 100 * of("strain_max"),
                         100 * of("strain_min"));
  }
  return words.empty() ? "The line has not been loaded yet." : words;
}

std::string Line::published_values(const base::Runs& runs, const base::DisplayUnits&) const
{
  std::string tables;
  for (const base::PageRun& run : runs) tables += tables_beside(*run.record, fmt::format("beside-line-{}", run.number));
  return tables.empty() ? "" : "<h3>Theory and springs beside</h3>\n" + tables;
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
