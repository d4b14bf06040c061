// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/line/answers_test.cpp
#include "structures/line/tables.hpp"

#include "formulas/strain_limit.hpp"
#include "structures/base/general_measures.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::line {
namespace {

using text::HtmlCell, text::table_number;

/// What the utilisation stands on, HTML; "" where there is none.
std::string strain_words(const settings::Case& c)
{
  const formulas::Formula limit = strain_limit(c);
  if (!limit.valid)
    return c.pipeline->wall ? fmt::format("<p>There is no utilisation: {} is for {}.</p>\n", text::html_text(citation(limit.source)),
                                          text::html_text(limit.source.range))
                            : "";
  return fmt::format(
      "<p>Utilisation is the stress-inducing compressive strain divided by {:.3g} %: the strain at which the wall buckles ({}, as "
      "public "
      "programs quote it), over the factors {} (safety class medium) and {} (load). It has the wall of the case, a ratio of yield stress "
      "to "
      "tensile strength of {}, girth welds by D/t, and no overpressure from inside, which would raise it; overpressure from outside is not "
      "covered. The line is elastic: beyond yield its strain is too small.</p>\n",
      100 * limit.value, text::html_text(citation(limit.source)), formulas::f101_strain_factor_medium, formulas::f101_load_factor,
      formulas::f101_yield_over_tensile);
}

/// A row of the table beside: P, y, M, lobe and slip.
std::vector<HtmlCell> row_beside(const std::string& stage, const std::string& by, Real P, Real y, Real M, Real lobe, Real slip)
{
  std::vector<HtmlCell> row{{text::html_text(stage)}, {by}};
  for (const Real value : {P / 1e3, y, M / 1e3, lobe, slip}) row.push_back({table_number(value), true});
  return row;
}

}  // namespace

std::string log_tables(const record::RunRecord& run)
{
  const auto [loads, shapes] = answer_tables(run, "");
  return loads.text() + shapes.text();
}

std::string page_tables(const record::RunRecord& run, const std::string& id)
{
  auto [loads, shapes] = answer_tables(run, id);
  const std::string of_shapes = shapes.html({{"stage"}});
  return loads.html({{"stage"}}) + of_shapes + (of_shapes.empty() ? "" : strain_words(run.settings));
}

std::string tables_beside(const record::RunRecord& run, const std::string& id)
{
  const Real far = run.settings.pipeline->far_soil.friction;
  const HobbsLine hobbs(run.settings, far);
  text::HtmlTable table(id, fmt::format("{}: the line, springs and theory at the end of each heated stage", run.name));
  table.columns({{"stage"}, {"by"}, {"P, kN", true}, {"y, m", true}, {"M, kN m", true}, {"lobe, m", true}, {"slip, m", true}});
  const bool knows_hobbs = std::isfinite(hobbs.smallest_force());
  bool any = false;
  Real none_at = 0;  // N, the largest constrained force at which Hobbs has none
  for (const StageEnd& end : stage_ends(run)) {
    if (!end.heated) continue;
    const auto of = [&](const char* name) { return base::quantity_value(run, end.name + "." + name); };
    const Real P0 = run.history["line_P0_N"][static_cast<std::size_t>(end.row)];
    const formulas::HobbsBuckle b = hobbs.at(P0);
    const bool has_springs = !std::isnan(of("springs_y")), has_hobbs = !std::isnan(b.lobe);
    if (!has_springs && !knows_hobbs) continue;
    any = true;
    table.row(row_beside(end.name, "the line on slices", of("P"), of("y"), of("M"), of("lobe_length"), of("slip_length")));
    if (has_springs) table.row(row_beside(end.name, "the same on springs", of("springs_P"), of("springs_y"), of("springs_M"), nan, nan));
    if (!knows_hobbs) continue;
    const auto add = [&](const std::string& friction, const formulas::HobbsBuckle& beside) {
      table.row(row_beside(end.name, fmt::format("Hobbs, {}{}", friction, std::isnan(beside.lobe) ? ": no buckle" : ""), beside.compression,
                           beside.amplitude, beside.moment, beside.lobe, beside.slip_length));
    };
    if (const Real mobilised = of("friction"); mobilised > 0)
      add(fmt::format("H/V of the slices {:.2f}", mobilised), HobbsLine(run.settings, mobilised).at(P0));
    add(fmt::format("far_soil {:.3g} W", far), b);
    none_at = has_hobbs ? none_at : std::max(none_at, P0);
  }
  if (!any) return "";
  const std::string none =
      none_at > 0
          ? text::html_paragraph(fmt::format("Hobbs (1984) gives no buckle of this line at constrained forces P0 up to {}: his smallest is "
                                             "{}. The line of the run moves sideways below that because of its imperfection.",
                                             text::force_words(none_at, 3), text::force_words(hobbs.smallest_force(), 3)))
          : "";
  return table.html() + none +
         fmt::format(
             "<p>Hobbs (1984) assumes a straight line without imperfection on the lateral friction that is named in its row, {:.3g} W in "
             "<code>far_soil.friction</code>, where H/V of the slices is the mean resistance in the buckle at the end of the stage, and "
             "{:.3g} W "
             "axial friction (<code>far_soil.axial_friction</code>): rigid, with V = W everywhere, and opposed to the displacement. Real "
             "friction opposes the motion: with that the same line has, with three lobes and at the same P, a sixth less amplitude and a "
             "quarter more moment "
             "(docs/theory/fem_safety_pipelines.md, Pipeline as a beam). His theory has no berms, no embedment, no time and no "
             "cycles.</p>\n",
             far, run.settings.pipeline->far_soil.axial_friction);
}

}  // namespace berm::line
