// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "structures/driven/report.hpp"

#include "structures/base/answer_table.hpp"
#include "structures/driven/answers.hpp"
#include "structures/driven/resistance.hpp"
#include "structures/driven/run_points.hpp"
#include "structures/driven/states.hpp"
#include "structures/driven/uplift.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <span>

namespace berm::driven {
namespace {

std::vector<text::HtmlCell> side_by_side(std::initializer_list<std::vector<text::HtmlCell>> parts)
{
  std::vector<text::HtmlCell> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// A table of points of paths: of a single run a row a point, of several a group of rows a point, one row a run.
class PointTable {
public:
  PointTable(std::string id, std::string caption, bool several) : table_(std::move(id), std::move(caption)), several_(several) {}

  void columns(const std::string& first, const std::vector<text::HtmlCell>& cells)
  {
    table_.columns(side_by_side({{{several_ ? "run" : first}}, cells}));
  }

  /// Points stand by their rank, then in the order in which they came.
  void add(Real rank, const std::string& point, const DrivenRun& run, const std::vector<text::HtmlCell>& cells)
  {
    Rows& rows = points_[{rank, point}];
    rows.push_back(side_by_side({{{several_ ? text::html_text(run.name) : point}}, cells}));
  }

  std::string html()
  {
    for (const auto& [key, rows] : points_) {
      if (several_) table_.row({{key.second}}, "group");
      for (const auto& row : rows) table_.row(row);
    }
    return table_.empty() ? "" : table_.html();
  }

private:
  using Rows = std::vector<std::vector<text::HtmlCell>>;
  text::HtmlTable table_;
  bool several_;
  std::map<std::pair<Real, std::string>, Rows> points_;
};

/// What the names of the main drag's numbers begin with.
std::string prefix_of_main(const DrivenRun& run)
{
  const Results results = run.results();
  return results.prefix_of(results.main_drag());
}

/// " in NAME" of a single run whose main drag is not its first.
std::string main_words(const DrivenRuns& runs)
{
  if (runs.size() != 1 || prefix_of_main(runs.front()).empty()) return "";
  return fmt::format(" in {}", text::html_text(runs.front().results().main_drag().stage));
}

std::string push_table(const DrivenRuns& runs, const base::DisplayUnits& shown, bool several)
{
  PointTable table("key-push", "Push: vertical resistance V at embedment w", several);
  table.columns("point", side_by_side({shown.force_columns("V"), converged_column(runs, "V", shown), shown.length_columns("w")}));
  for (const DrivenRun& run : runs) {
    const RunPoints points = points_of(run);
    const auto add = [&](Real rank, const std::string& name, const PushPoint& p, const std::string& quantity) {
      table.add(rank, name, run,
                side_by_side(
                    {shown.force_cells(run.scale, p.V), converged_cell(runs, run, quantity, shown), shown.length_cells(run.scale, p.w)}));
    };
    for (const PushPoint& p : points.push) {
      const Real part = p.w / run.scale.width;
      add(std::round(1000 * part), fmt::format("w = {} D", text::short_number(part)), p, name_at("V_at_w", part));
    }
    if (!points.push_end) continue;
    // An end at a round embedment stands among the points that other runs have there.
    const StageEnd end = end_of_push(run);
    const Real part = points.push_end->w / run.scale.width, round = std::round(20 * part) / 20;
    if (end.reached && round > 0 && std::abs(part - round) < 5e-4)
      add(std::round(1000 * round), fmt::format("w = {} D", text::short_number(round)), *points.push_end, "V_end_of_push");
    else
      add(infinity, end.at, *points.push_end, "V_end_of_push");
  }
  return table.html();
}

std::string drag_table(const DrivenRuns& runs, const base::DisplayUnits& shown, bool several)
{
  PointTable table(
      "key-drag",
      fmt::format("Drag{}: horizontal resistance H and embedment w at displacement u from where the drag began", main_words(runs)),
      several);
  table.columns("point",
                side_by_side({shown.force_columns("H"), converged_column(runs, "H", shown), {{"H/V", true}}, shown.length_columns("w")}));
  for (const DrivenRun& run : runs) {
    const std::string prefix = prefix_of_main(run);
    for (const DragPoint& p : points_of(run).drag) {
      const Real part = p.u / run.scale.width;
      table.add(std::round(1000 * part), fmt::format("u = {} D", text::short_number(part)), run,
                side_by_side({shown.force_cells(run.scale, p.H),
                              converged_cell(runs, run, prefix + name_at("H_at_u", part), shown),
                              {{text::table_number(p.H / p.V), true}},
                              shown.length_cells(run.scale, p.w)}));
    }
  }
  return table.html();
}

/// A column of the table of stages, and its number of a drag and of another push.
struct StageColumn {
  using Value = std::optional<Real>;
  enum class Unit { force, width, none } unit;
  const char* heading;
  Value (*of_drag)(const DragResults& drag);
  Value (*of_push)(const OtherPushResults& push) = [](const OtherPushResults&) { return Value(); };
};

template <class T>
std::optional<Real> member_of(const std::optional<T>& point, Real T::*member)
{
  return point ? std::optional((*point).*member) : std::nullopt;
}

using StageUnit = StageColumn::Unit;
constexpr StageColumn stage_columns[] = {
    {StageUnit::width, "travel/D", [](const DragResults& d) { return member_of(d.end, &DragPoint::u); }},
    {StageUnit::force, "V", [](const DragResults& d) { return d.V; }, [](const OtherPushResults& p) { return std::optional(p.V); }},
    {StageUnit::force, "H<sub>breakout</sub>", [](const DragResults& d) { return member_of(d.breakout, &DragPeak::H); }},
    {StageUnit::width, "at u/D", [](const DragResults& d) { return member_of(d.breakout, &DragPeak::u); }},
    {StageUnit::force, "H<sub>max</sub>", [](const DragResults& d) { return member_of(d.largest, &DragPeak::H); }},
    {StageUnit::force, "H<sub>residual</sub>", [](const DragResults& d) { return d.residual; }},
    {StageUnit::force, "H<sub>berm</sub>", [](const DragResults& d) { return d.berm; }},
    {StageUnit::force, "H<sub>end</sub>", [](const DragResults& d) { return member_of(d.end, &DragPoint::H); }},
    {StageUnit::none, "H<sub>end</sub>/V", [](const DragResults& d) { return d.end ? std::optional(d.end->H / d.end->V) : std::nullopt; }},
    {StageUnit::width, "w<sub>end</sub>/D", [](const DragResults& d) { return member_of(d.end, &DragPoint::w); },
     [](const OtherPushResults& p) { return std::optional(p.w); }},
    {StageUnit::width, "berm height/D", [](const DragResults& d) { return d.berm_height; }},
    {StageUnit::width, "berm ahead by/D", [](const DragResults& d) { return d.berm_distance; }},
    {StageUnit::width, "remoulded below/D", [](const DragResults& d) { return d.remoulded_depth; }}};  // the last: of clay that softens

/// A row for each drag and other push of the runs that have more than one push and one drag: the main drag, then the others in the order of time.
std::string stages_table(const DrivenRuns& runs, const base::DisplayUnits& shown)
{
  text::HtmlTable table("key-stages", "Drags (sweeps) and unloading, one by one; the drag of the numbers above comes first");
  const bool softens = std::any_of(runs.begin(), runs.end(), [](const DrivenRun& run) {
    const auto& drags = run.results().drags;
    return std::any_of(drags.begin(), drags.end(), [](const DragResults& drag) { return drag.remoulded_depth.has_value(); });
  });
  const std::span columns(stage_columns, std::size(stage_columns) - (softens ? 0 : 1));
  std::vector<text::HtmlCell> headings{{"stage"}};
  for (const StageColumn& c : columns)
    headings.push_back(c.unit == StageUnit::force ? shown.force_columns(c.heading).front() : text::HtmlCell{c.heading, true});
  table.columns(headings);
  for (const DrivenRun& run : runs) {
    const Results results = run.results();
    const auto lifts = [&](const OtherPushResults& push) {
      return std::ranges::find(results.uplifts, push.stage, &UpliftResults::stage) != results.uplifts.end();
    };
    // A lift has a table of its own.
    if (results.drags.size() < 2 && std::ranges::all_of(results.other_pushes, lifts)) continue;
    const auto add = [&](const std::string& stage, const auto& value_of) {
      std::vector<text::HtmlCell> cells{{text::html_text(stage)}};
      for (const StageColumn& c : columns) {
        const std::optional<Real> value = value_of(c);
        const auto in_unit = [&](Real v) {
          return c.unit == StageUnit::force ? shown.in_force_unit(v) : c.unit == StageUnit::width ? v / run.scale.width : v;
        };
        cells.push_back({value ? text::table_number(in_unit(*value)) : "", true});
      }
      table.row(cells);
    };
    if (runs.size() > 1) table.row({{text::html_text(run.name)}}, "group");
    Stages stages = run.stages;
    const auto main = results.drags.empty() ? stages.end() : std::ranges::find(stages, results.main_drag().stage, &Stage::name);
    if (main != stages.end()) std::rotate(stages.begin(), main, main + 1);
    for (const Stage& stage : stages) {
      const auto push = std::ranges::find(results.other_pushes, stage.name, &OtherPushResults::stage);
      const auto drag = std::ranges::find(results.drags, stage.name, &DragResults::stage);
      if (push != results.other_pushes.end()) add(stage.name, [&](const StageColumn& c) { return c.of_push(*push); });
      if (drag != results.drags.end()) add(stage.name, [&](const StageColumn& c) { return c.of_drag(*drag); });
    }
  }
  if (table.empty()) return "";
  return table.html() +
         text::html_paragraph(
             fmt::format(
                 "H of a drag is positive where the soil resists it. H at its end is the mean over its last tenth, at least over 0.1 D "
                 "but over a third of it at most; where that is resistance against a berm it is H<sub>berm</sub>, not a residual. The berm "
                 "is the highest soil ahead of the pipe at the end of the drag, above the "
                 "original surface, and its distance from the axis of the pipe.{}",
                 softens ? " Clay below the invert counts as remoulded where it has lost half of the strength that full remoulding takes."
                         : ""),
             "quiet");
}

std::string residual_words(const Resistance& resistance, const StageEnd& end)
{
  if (resistance.berm)
    return resistance.residual ? "lowest plateau, before H rises against a berm"
                               : "not reached: H grows against a berm, without a plateau before";
  const std::string change = fmt::format("{:.2g}", 100 * resistance.last_change);
  const std::string last = end.reached ? "the end of the drag" : "the last part of the drag, " + end.at;
  return resistance.residual ? fmt::format("mean over {}; H changes by {} % there", last, change)
                             : fmt::format("not reached: H changes by {} % over {}", change, last);
}

std::string resistance_table(const DrivenRuns& runs, const base::DisplayUnits& shown, bool several)
{
  PointTable table("key-resistance",
                   fmt::format("Resistance to the drag{}: largest, at breakout or onset, and residual H", main_words(runs)), several);
  table.columns("H", side_by_side({shown.force_columns("H"), converged_column(runs, "H", shown), shown.length_columns("u"), {{"basis"}}}));
  for (const DrivenRun& run : runs) {
    const Resistance resistance = resistance_of(run);
    const StageEnd end = end_of_drag(run);
    const std::string prefix = prefix_of_main(run);
    const auto add = [&](Real rank, const std::string& name, Real u, Real H, const std::string& words) {
      const std::string quantity = prefix + (rank == 0 ? "H_max" : "H_" + name);
      table.add(
          rank, name, run,
          side_by_side(
              {shown.force_cells(run.scale, H), converged_cell(runs, run, quantity, shown), shown.length_cells(run.scale, u), {{words}}}));
    };
    if (resistance.largest) add(0, "largest", resistance.largest->u, resistance.largest->H, "");
    if (std::isnan(resistance.last_change) || run.results().main_drag().moved) continue;
    if (resistance.breakout)
      add(1, "breakout", resistance.breakout->u, resistance.breakout->H, "first peak");
    else
      add(1, "breakout", nan, nan, no_peak_words(resistance, end.to));
    if (resistance.onset) add(1, "onset", 0, *resistance.onset, "H over u = 0.1 to 0.5 D, extrapolated to u = 0");
    add(2, "residual", nan, resistance.residual.value_or(nan), residual_words(resistance, end));
    if (resistance.berm) add(3, "berm", resistance.travel, *resistance.berm, "mean over the end of the drag");
  }
  const std::string html = table.html();
  if (html.empty()) return "";
  return html +
         text::html_paragraph(
             fmt::format(
                 "Breakout is the first peak of H from which H "
                 "falls by at least {:g} % before it grows beyond it, within {:g} D; where forces are averaged, H must also stay below it "
                 "for {:g} D, and "
                 "fall by {:g} "
                 "times the standard deviation of averaged H about its mean over ±{:g} D. Without such a peak the onset is the H at which "
                 "it begins to slide. "
                 "Residual is the mean of H over the end of the drag, its last tenth and at least its last {:g} D (a third of it at most), "
                 "if the straight line "
                 "fitted to H there changes by less than {:g} % of that mean. Where H has risen by more than {:g} % from an earlier "
                 "plateau, that "
                 "plateau is the residual and the end is the resistance of the berm that the body has pushed up. A drag that ends within "
                 "{:g} D of "
                 "where an earlier one in its direction ended, or that grows over swept ground without a plateau, has a berm resistance "
                 "and no residual.",
                 100 * min_fall, longest_breakout, breakout_stays, min_fall_over_swing, swing_half, min_residual_travel,
                 100 * max_residual_change, 100 * min_berm, near_a_berm),
             "quiet");
}

std::string averaging_words(const DrivenRuns& runs)
{
  if (std::none_of(runs.begin(), runs.end(), [](const DrivenRun& run) { return run.scale.noisy; })) return "";
  return text::html_paragraph(
      fmt::format(
          "Forces of the material point method are averaged: each is taken from the straight line fitted to H or V within ±{:g} D of "
          "travel, near the ends of a push or drag to its first or last {:g} D.",
          base::averaging_half_width, 2 * base::averaging_half_width),
      "quiet");
}

/// The states of a run between its travels, the operating one first.
States operation_first(States states)
{
  const auto operation = std::ranges::find(states, "operation", &State::name);
  if (operation != states.end()) std::rotate(states.begin(), operation, operation + 1);
  return states;
}

/// Where a run lies between its travels.
std::string states_table(const DrivenRuns& runs, const base::DisplayUnits& shown)
{
  text::HtmlTable table("key-states", "States: embedment w and vertical force V");
  table.columns(side_by_side({{{"state"}}, shown.length_columns("w"), shown.force_columns("V"), {{"basis"}}}));
  for (const DrivenRun& run : runs) {
    const States states = states_of(run.record);
    if (!has_states_between(states)) continue;
    if (runs.size() > 1) table.row({{text::html_text(run.name)}}, "group");
    for (const State& state : operation_first(states))
      if (!state.name.starts_with("after_"))
        table.row(side_by_side({{{state.name}},
                                shown.length_cells(run.scale, state.w),
                                shown.force_cells(run.scale, state.V),
                                {{text::html_text(state.origin)}}}));
  }
  return table.empty() ? "" : table.html();
}

/// What the rows of a stage are called: with its run, of several.
std::string stage_of(const DrivenRuns& runs, const DrivenRun& run, const std::string& stage)
{
  return runs.size() > 1 ? run.name + ", " + stage : stage;
}

/// How far forces move the bodies.
std::string displacements_table(const DrivenRuns& runs, const base::DisplayUnits& shown)
{
  base::AnswerTable table({"key-displacements", "Displacement under a given force"}, shown, drag_answers);
  for (const DrivenRun& run : runs) {
    const Results results = run.results();
    for (const DragResults& drag : results.drags)
      if (drag.moved) table.add(stage_of(runs, run, drag.stage), run.record, results.prefix_of(drag));
  }
  const std::string html = table.html({{"stage"}});
  if (html.empty()) return "";
  return html + text::html_paragraph("u is the displacement along x since the start of the stage; a half cycle ends where the body "
                                     "reverses by 0.01 D. Times are those of the load history (the record), whatever time_scale "
                                     "was. half_cycles.csv in the run folder lists each half cycle of a varying force.",
                                     "quiet");
}

std::string uplift_table(const DrivenRuns& runs, const base::DisplayUnits& shown)
{
  base::AnswerTable table({"key-uplift", "Uplift: resistance R against the lift"}, shown, uplift_answers);
  for (const DrivenRun& run : runs)
    for (const UpliftResults& u : run.results().uplifts) table.add(stage_of(runs, run, u.stage), run.record, u.stage + ".");
  return table.html({{"stage"}});
}

/// R by the travel upwards, and where it is largest.
std::string uplift_travel_table(const DrivenRuns& runs, const base::DisplayUnits& shown)
{
  constexpr Real told_at[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1};  // over D: not less than forces are averaged over, as the largest is
  text::HtmlTable table("key-uplift-travel", "Uplift resistance R by the travel upwards");
  table.columns(side_by_side({{{"stage"}}, shown.length_columns("travel"), shown.force_columns("R")}));
  for (const DrivenRun& run : runs) {
    if (run.history.rows() == 0) continue;
    for (const OtherPush& push : path_of(run.history, run.stages).other_pushes) {
      if (!push.upwards) continue;
      const LiftPath lift = lift_path(push, run.history);
      const record::TravelCurve R(lift.travel, lift.R);
      for (const Real part : told_at) {
        const Real travel = part * run.scale.width;
        if (R.empty() || !(travel <= R.end())) break;
        table.row(side_by_side({{{text::html_text(stage_of(runs, run, push.stage))}},
                                shown.length_cells(run.scale, travel),
                                shown.force_cells(run.scale, R.at(travel, averaging_half(run.scale)))}));
      }
    }
  }
  return table.empty() ? "" : table.html();
}

/// The travels one by one, folded where the main one is told by itself.
std::string folded(const std::string& table)
{
  return table.empty() ? "" : "<details>\n<summary>All travels, one by one</summary>\n" + table + "</details>\n";
}

/// The mean of a column over the last stage; NaN where there is none.
Real mean_of_last_stage(const run_folder::History& history, const std::string& column)
{
  if (!history.has(column) || history.rows() == 0) return nan;
  const std::vector<Real>& values = history[column];
  Real sum = 0;
  int rows = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (history.stage[k] == history.stage.back()) sum += values[k], ++rows;
  return sum / rows;
}

/// What rigid bodies give to each other, which is no part of H and V.
std::string rigid_contact_notes(const DrivenRuns& runs)
{
  std::string notes;
  for (const DrivenRun& run : runs)
    for (const auto& [name, contact] : run.settings.rigid_contact) {
      const int dimension = run.settings.force_dimension();
      const char* unit = dimension == 2 ? "_N_m" : "_N";
      const Real x = mean_of_last_stage(run.history, name + "_Fx" + unit), y = mean_of_last_stage(run.history, name + "_Fy" + unit);
      if (std::isnan(x)) continue;
      notes += text::html_paragraph(fmt::format(
          "H and V are those of the soil alone. Beside them {} pushes {} by {} along x and {} along y, means over the last stage.",
          contact.other_rigid, contact.rigid, text::force_words(x, dimension), text::force_words(y, dimension)));
    }
  return notes;
}

}  // namespace

std::string key_results(const DrivenRuns& runs, const base::DisplayUnits& shown, bool push)
{
  const bool several = runs.size() > 1;
  const std::string tables = states_table(runs, shown) + resistance_table(runs, shown, several) + displacements_table(runs, shown) +
                             uplift_table(runs, shown) + uplift_travel_table(runs, shown) + (push ? push_table(runs, shown, several) : "") +
                             drag_table(runs, shown, several) + folded(stages_table(runs, shown));
  return tables.empty() ? "" : tables + shown.scale_words() + averaging_words(runs) + rigid_contact_notes(runs) + converged_notes(runs);
}

}  // namespace berm::driven
