// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/structures_test.cpp
#include "structures/generic/generic.hpp"

#include "bodies/rigid/shape.hpp"
#include "soil_plot/panels.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/general_measures.hpp"
#include "structures/base/mechanism_cells.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::generic {
namespace {

std::string quantities_table(const record::RunRecord& run, const std::string& id)
{
  text::HtmlTable table(id, fmt::format("{}: results", run.name));
  table.columns({{"quantity"}, {"value", true}, {"unit"}});
  for (const run_folder::Quantity& q : run.quantities)
    table.row({{text::html_text(q.name)}, {text::table_number(q.value), true}, {q.unit == "1" ? "" : text::html_text(q.unit)}});
  return table.empty() ? "" : table.html();
}

bool is_watched(const settings::Case& c, const run_folder::Column& column)
{
  return std::any_of(c.watch.begin(), c.watch.end(), [&](const auto& watch) { return column.of == watch.first; });
}

std::string watched_table(const record::RunRecord& run, const std::string& id)
{
  const run_folder::History& history = run.history;
  if (history.rows() == 0) return "";
  const std::string when = history.has("time_s") ? fmt::format(" after {} s", text::short_number(history["time_s"].back())) : "";
  text::HtmlTable table(id, fmt::format("{}: the watched quantities, at its end{}", run.name, when));
  table.columns({{"column of the history"}, {"meaning"}, {"last value", true}, {"unit"}});
  for (std::size_t c = 0; c < history.columns.size(); ++c)
    if (is_watched(run.settings, history.columns[c]))
      table.row({{text::html_text(history.columns[c].name)},
                 {text::html_text(history.columns[c].meaning)},
                 {text::table_number(history.values[c].back()), true},
                 {text::html_text(history.columns[c].unit)}});
  return table.empty() ? "" : table.html();
}

std::string checks_table(const record::RunRecord& run, const std::string& id)
{
  text::HtmlTable table(id, fmt::format("{}: checks", run.name));
  table.columns({{"check"}, {"value", true}});
  if (run.summary)
    for (const auto& [name, value] : run.summary->checks) table.row({{text::html_text(name)}, {text::table_number(value), true}});
  return table.empty() ? "" : table.html();
}

/// Columns that are worth a curve: of watched particles, else of the bodies.
std::vector<std::string> curve_columns(const settings::Case& c, const run_folder::History& history)
{
  std::vector<std::string> chosen;
  for (const run_folder::Column& column : history.columns)
    if (is_watched(c, column) && column.unit == run_folder::metres.name) chosen.push_back(column.name);
  if (chosen.empty())
    for (const run_folder::Column& column : history.columns)
      for (const auto& [name, body] : c.body)
        if (column.of == name) chosen.push_back(column.name);
  return chosen;
}

namespace limits {

inline constexpr base::Limit mechanism{
    40, 4, base::Effect::cells,
    "a vertical cut in clay that is loaded 10 % beyond its limit comes to rest with a resistance 7 % too large with 20 cells over its "
    "height, 6 % with 40 (examples/vertical_cut); a cavity with five cells across the flowing clay is 4 % too low (examples/cavity)",
    true};

inline constexpr base::Limit turned = base::too_large(
    {120, 30, base::Effect::cells,
     "the moment of a strip that sticks to clay is 5 % too large with elements of B/67 (an upper bound gives 0.69 B2 s_u)", true});
inline constexpr base::Limit moved = base::too_large({40, 20, base::Effect::cells, "as for a body driven by a push or a drag", true});

inline constexpr base::Limit radius{16, 5, base::Effect::cells,
                                    "the rim of an elastic disk is straight across a cell: with 16 cells over its radius it rolls 2 % too "
                                    "slowly, with 8 some 4 % (examples/cylinder); "
                                    "with 4 it loses 3 % of its angular momentum per revolution (examples/spinning_disk)",
                                    true};

}  // namespace limits

base::TrustMeasure cells_of_mechanism()
{
  return {"cells across the sheared soil",
          &limits::mechanism,
          base::has_mechanism_cells,
          [](const record::RunRecord& run) { return base::cells_across_mechanism(run); },
          base::as_number,
          "there are {} cells across the sheared soil: its resistance depends on them; take finer cells there",
          base::bare_limit,
          true};
}

/// Cells over the radius of the smallest disk of material; NaN where there is none or its cells are not known.
Real cells_over_radius(const settings::Case& c)
{
  Real radius = nan;
  for (const auto& [name, body] : c.body)
    if (body.disk) radius = std::fmin(radius, body.disk->diameter / 2);
  return radius / base::near_cell_size(c);
}

base::TrustMeasure cells_of_disk()
{
  return {"cells over the radius of the smallest disk",
          &limits::radius,
          [](const record::RunRecord& run) { return !std::isnan(cells_over_radius(run.settings)); },
          [](const record::RunRecord& run) { return cells_over_radius(run.settings); },
          base::as_number,
          "there are {} cells over the radius of a disk: its rim is not a circle, so it rotates and rolls too slowly",
          base::bare_limit,
          true};
}

/// The width of a main rigid body that a stage of kind drive moves, m; 0 where there is none, or it reaches from wall to wall.
Real moved_width(const settings::Case& c)
{
  const Index rigid = main_rigid(c);
  const bool driven = std::any_of(c.stage.begin(), c.stage.end(),
                                  [](const settings::StageSettings& stage) { return stage.kind == settings::StageKind::drive; });
  if (rigid == none || !driven || base::covers_the_mesh(c)) return 0;
  const bodies::RigidShapeSettings& shape = c.rigid[rigid].second.shape;
  const Real width = c.dimension() == 2 ? width_of<2>(bodies::make_shape<2>(shape)) : width_of<3>(bodies::make_shape<3>(shape));
  return std::isfinite(width) ? width : 0;
}

bool turns(const settings::Case& c)
{
  return std::any_of(c.stage.begin(), c.stage.end(), [](const settings::StageSettings& stage) {
    const settings::TurnSettings* all[] = {&stage.drive.rotation, &stage.drive.rotation_x, &stage.drive.rotation_y,
                                           &stage.drive.rotation_z};
    return std::any_of(std::begin(all), std::end(all), [](const settings::TurnSettings* turn) { return turn->velocity || turn->moment; });
  });
}

/// Of a body that a drive moves or turns.
base::TrustMeasure cells_at_moved_body(const settings::Case& c)
{
  const std::string what = fmt::format("{} at the {}", c.method == settings::Method::fem ? "elements" : "cells", base::body_word(c));
  return {what,
          turns(c) ? &limits::turned : &limits::moved,
          [](const record::RunRecord& run) { return moved_width(run.settings) > 0; },
          [](const record::RunRecord& run) { return moved_width(run.settings) / base::near_cells(run).first; },
          [](const record::RunRecord& run, Real value) {
            return fmt::format("D/{:.3g} ({})", value, text::length_words(base::near_cells(run).first));
          },
          [what](const record::RunRecord&, Real value) {
            return fmt::format("{} are D/{:.3g}: resistance on a coarse mesh is too large", what, value);
          },
          [](Real value) { return fmt::format("D/{:g}", value); },
          true};
}

/// What it watches, its own quantities, else its checks.
std::string results_of(const record::RunRecord& run, const std::string& id)
{
  const std::string results = quantities_table(run, id + "-quantities") + watched_table(run, id + "-watched");
  return results.empty() ? checks_table(run, id + "-checks") : results;
}

}  // namespace

base::TrustMeasures measures_of_any_run(const settings::Case& c)
{
  using namespace base;
  if (c.method == settings::Method::fem)
    return joined({convergence(),
                   {energy_balance(c.method), cells_at_moved_body(c), shear_bands(), friction_of_cells(), counted("nodes", "nodes"),
                    counted("elements", "cells")}});
  return joined({{energy_balance(c.method)},
                 energy_that_the_method_takes(),
                 {balance_after_geostatic("after the geostatic stage")},
                 soil_volumes(),
                 {momentum_balance(), cells_of_mechanism(), cells_of_disk(), cells_at_moved_body(c), shear_bands(), friction_of_cells(),
                  counted("particles", "particles"), counted("cells", "cells")}});
}

/// Any case that is of no other structure: it has no key results; what it watches, its own quantities and its checks are told.
base::Structure other()
{
  using Run = const record::RunRecord&;
  return {
      "other",
      {{.draw_curves =
            [](const run_folder::RunFolder& folder, Run run, const base::CurveBands&) {
              return soil_plot::draw_columns(folder, run.history, curve_columns(run.settings, run.history), run.settings.title);
            },
        .words = [](Run, const base::DisplayUnits&) { return "This run has no key results: no push or drag drives a body with a width."; },
        .other_results = results_of,
        .measures = measures_of_any_run}},
      [](const settings::Case&) { return true; }};
}

}  // namespace berm::generic
