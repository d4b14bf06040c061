// SPDX-License-Identifier: BSD-3-Clause
#include "report/results/results_section.hpp"
#include "samples/lived_pipe.hpp"
#include "samples/made_run_in_water.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

bool holds(const std::string& html, const std::string& part)
{
  return html.find(part) != std::string::npos;
}

std::string answer_of(const std::vector<record::RunRecord>& runs)
{
  return results_section(runs, judgements_of(runs));
}

TEST(answer, says_which_drag_came_before)
{
  record::RunRecord run = lived_pipe();
  EXPECT_TRUE(holds(answer_of({run}), "Dragged in \"sweep_1\" 2 D with V held")) << answer_of({run});
  run.settings.stage[5].role = settings::StageRole::breakout;
  EXPECT_TRUE(holds(answer_of({run}), "Dragged in \"sweep_2\" after \"sweep_1\", from w = 0.29 D (5.8 mm), 2 D with V held"))
      << answer_of({run});
}

/// Where the row of a table begins; npos: it has none.
std::size_t row_of(const std::string& html, const std::string& table, const std::string& heading)
{
  const std::size_t begin = html.find("<table id=\"" + table + "\"");
  return begin == std::string::npos ? begin : html.find("<th scope=\"row\">" + heading + "</th>", begin);
}

TEST(answer, begins_its_tables_with_the_operating_state_and_the_drag_in_it)
{
  record::RunRecord run = lived_pipe();
  std::string html = answer_of({run});
  EXPECT_LT(row_of(html, "key-states", "operation"), row_of(html, "key-states", "touchdown")) << html;
  EXPECT_LT(html.find("id=\"key-states\""), html.find("id=\"key-resistance\""));
  EXPECT_LT(html.find("id=\"key-resistance\""), html.find("id=\"key-push\""));
  EXPECT_LT(row_of(html, "key-stages", "sweep_1"), row_of(html, "key-stages", "lay_1")) << html;
  run.settings.stage[5].role = settings::StageRole::breakout;
  html = answer_of({run});
  EXPECT_LT(row_of(html, "key-stages", "sweep_2"), row_of(html, "key-stages", "sweep_1")) << html;
}

TEST(answer, begins_with_the_numbers_that_the_job_asks_for)
{
  record::RunRecord run = lived_pipe();
  const std::string html = answer_of({run});
  std::size_t last = 0;
  for (const char* part : {"<dt>Breakout resistance (sweep_1)</dt><dd class=\"number\">0.198 kN/m</dd>", "kN/m: DNVGL-RP-F114",
                           "<dt>Displacement at breakout</dt><dd class=\"number\">4.04 mm <small>0.202 D</small></dd>",
                           "<dt>Residual resistance</dt><dd class=\"number\">0.1 kN/m</dd>",
                           "<dt>Embedment in operation</dt><dd class=\"number\">5.8 mm", "id=\"first-look\""}) {
    const std::size_t place = html.find(part);
    ASSERT_NE(place, std::string::npos) << part << "\n" << html.substr(0, 2000);
    EXPECT_GT(place, last) << part;
    last = place;
  }
  run.summary.emplace().uncertainty.emplace().quantities = {
      {"sweep_1.H_residual", "N/m", {.value = 100, .converged = 90, .half_width = 12}}};
  EXPECT_TRUE(holds(answer_of({run}), "0.1 kN/m</dd><dd class=\"quiet\">band 78 N/m to 0.102 kN/m</dd>")) << answer_of({run});
  EXPECT_FALSE(holds(answer_of({run, run}), "class=\"headline\"")) << "of several runs a table compares them";
}

TEST(answer, says_in_words_what_the_pipe_met)
{
  MadeRun made;
  made.dragged = 0.02;
  const std::string html = answer_of({made.record()});
  EXPECT_TRUE(holds(
      html, "Pushed to w = 0.1 D (2 mm, 0.1 m in the prototype), the pipe carries V = 0.8 kN/m (40 kN/m in the prototype, 4.65 γ′ D²)."))
      << html;
  EXPECT_TRUE(holds(html, "Dragged 1 D with V held, 0.8 kN/m (40 kN/m in the prototype, 4.65 γ′ D²) on average, it mobilises H = 0.57 kN/m "
                          "(28.5 kN/m in the prototype, "
                          "3.31 γ′ D²), 0.713 V, over the last 0.1 D, and sinks to w = 0.6 D"))
      << html;
  EXPECT_TRUE(holds(html, "There is no peak: H grows to the end of the drag.")) << html;
}

/// A second drag of D under a vertical force.
record::RunRecord with_a_second_drag(Real V)
{
  MadeRun made;
  made.dragged = 0.02;
  record::RunRecord run = made.record();
  run.settings.stage.push_back(MadeRun::stage_of("second", settings::StageKind::drag));
  for (int k = 1; k <= 500; ++k) {
    const Real row[] = {static_cast<Real>(run.history.rows()), 0.02 + k * 4e-5, 0.012, 300, V};
    for (int c = 0; c < 5; ++c) run.history.values[c].push_back(row[c]);
    run.history.stage.push_back("second");
  }
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  return run;
}

TEST(answer, a_drag_under_another_vertical_force_says_so)
{
  const std::string other = answer_of({with_a_second_drag(400)}), same = answer_of({with_a_second_drag(800)});
  EXPECT_TRUE(holds(other, "One more drag follows with V held, 0.4 kN/m")) << other;
  EXPECT_TRUE(holds(other, "it mobilises at its end H = 0.3 kN/m")) << other;
  EXPECT_TRUE(holds(same, "One more drag follows: it mobilises at its end H = 0.3 kN/m")) << same;
}

TEST(answer, key_results_stand_at_model_scale_dimensionless_and_at_prototype_scale)
{
  const std::string html = answer_of({MadeRun{}.record()});
  EXPECT_TRUE(holds(html, "<th scope=\"col\" class=\"number\">V, kN/m</th><th scope=\"col\" class=\"number\">V/(γ′ D²)</th>"
                          "<th scope=\"col\" class=\"number\">V in the prototype, kN/m</th>"));
  EXPECT_TRUE(holds(html, "times the gravity level (50)"));
  EXPECT_TRUE(holds(
      html,
      "<th scope=\"row\">w = 0.05 D</th><td class=\"number\">0.4000</td><td class=\"number\">2.326</td><td class=\"number\">20.00</td>"
      "<td class=\"number\">0.05000</td><td class=\"number\">1.000</td><td class=\"number\">0.05000</td>"))
      << html;
  // At u = 0.3 D: w = 5 mm, H = 180 N/m, V = 800 N/m.
  EXPECT_TRUE(holds(
      html,
      "<th scope=\"row\">u = 0.3 D</th><td class=\"number\">0.1800</td><td class=\"number\">1.047</td><td class=\"number\">9.000</td>"
      "<td class=\"number\">0.2250</td><td class=\"number\">0.2500</td><td class=\"number\">5.000</td><td class=\"number\">0.2500</td>"))
      << html;
}

TEST(answer, tells_how_sure_it_is_where_that_is_known)
{
  record::RunRecord run = MadeRun{}.record();
  EXPECT_FALSE(holds(answer_of({run}), "converged"));
  run.summary.emplace();
  run_folder::Uncertainty& u = run.summary->uncertainty.emplace();
  u.quantities = {
      {"V_end_of_push", "N/m", {800, 718, 53}}, {"V_at_w_0.05D", "N/m", {400, 360, 28}}, {"H_at_u_0.3D", "N/m", {180, 170, 12}}};
  const std::string html = answer_of({run});
  EXPECT_TRUE(holds(html, "carries V = 0.8 kN/m (40 kN/m in the prototype, 4.65 γ′ D²), converged 0.72 ± 0.05 kN/m.")) << html;
  EXPECT_TRUE(holds(html, "<th scope=\"col\" class=\"number\">V converged, kN/m</th>")) << html;
  EXPECT_TRUE(holds(html, "<td class=\"number\">20.00</td><td class=\"number\">0.360 ± 0.028</td>")) << html;
  EXPECT_TRUE(holds(html, "0.170 ± 0.012")) << html;
  EXPECT_TRUE(holds(html, "not those of the soil law or its parameters")) << html;
  u = {};
  u.missing = "the run cells_2 failed: <no memory>";
  EXPECT_TRUE(holds(answer_of({run}), "has no bands: the run cells_2 failed: &lt;no memory&gt;."));
}

TEST(answer, a_number_with_its_half_width_has_as_many_decimals_as_this)
{
  EXPECT_EQ(text::with_half_width(0.6789, 0.0512), "0.68 ± 0.05");
  EXPECT_EQ(text::with_half_width(0.7149, 0.1182), "0.71 ± 0.12");
  EXPECT_EQ(text::with_half_width(25650.3, 291.7), "25650 ± 290");
  EXPECT_EQ(text::with_half_width(25650.3, 412.0, "+-"), "25700 +- 400");
  EXPECT_EQ(text::with_half_width(20, 0), "20.00 ± 0");
  EXPECT_EQ(text::with_half_width(2.499994, 0.000006), "2.500 ± 0");
  EXPECT_EQ(text::with_half_width(std::nan(""), 1), "–");
}

TEST(answer, a_model_under_one_gravity_has_no_prototype)
{
  MadeRun made;
  made.gravity_level = 1;
  const std::string html = answer_of({made.record()});
  EXPECT_FALSE(holds(html, "prototype")) << html;
  EXPECT_TRUE(holds(html, "V/(γ′ D²)"));
  made.gravity_level = 0;
  EXPECT_FALSE(holds(answer_of({made.record()}), "prototype"));
}

TEST(answer, clay_is_measured_by_its_strength)
{
  MadeRun made;
  made.law = MadeRun::clay_law();
  made.contact.friction_angle = 0;
  const std::string html = answer_of({made.record()});
  EXPECT_TRUE(holds(html, "V/(D s<sub>u</sub>)"));
  EXPECT_FALSE(holds(html, "V/(γ′ D²)"));
  EXPECT_TRUE(holds(html, "40 D s<sub>u</sub>")) << html;  // 800 N/m over 0.02 m x 1 kPa
}

// Cells of D/10.
TEST(answer, a_single_run_of_a_pipe_in_clay_tells_the_error_of_its_cells)
{
  MadeRun made;
  made.law = MadeRun::clay_law();
  record::RunRecord run = made.record();
  std::get<mesh::SeabedMesh>(run.settings.mesh).near_size = 0.002;
  const std::string error_of_cells = "on cells of D/10 V of a push into clay is some 3.7 % above its value at zero cell size";
  EXPECT_TRUE(holds(answer_of({run}), error_of_cells)) << answer_of({run});
  record::RunRecord with_bands = run, by_elements = run;
  run_folder::Uncertainty& bands = with_bands.summary.emplace().uncertainty.emplace();
  bands.missing = "stopped";
  EXPECT_TRUE(holds(answer_of({with_bands}), error_of_cells));
  bands.quantities = {{"V_at_w_0.05D", "N/m", {400, 360, 28}}};
  EXPECT_FALSE(holds(answer_of({with_bands}), error_of_cells));
  by_elements.settings.method = settings::Method::fem;
  EXPECT_FALSE(holds(answer_of({by_elements}), error_of_cells));
  EXPECT_FALSE(holds(answer_of({MadeRun{}.record()}), "of a push into clay")) << "sand";
}

TEST(answer, a_value_out_of_range_is_marked)
{
  MadeRun made;
  made.law.dilation_angle = 0;
  const std::string html = answer_of({made.record()});
  EXPECT_TRUE(holds(html, "<tr class=\"out_of_range\"><th scope=\"row\">V</th>"));
  EXPECT_TRUE(holds(html, "out of range: φ = ψ = 35°, δ = 0 or 2/3 φ, 0.05 ≤ w/D ≤ 0.5")) << html;
  EXPECT_FALSE(holds(answer_of({MadeRun{}.record()}), "out_of_range"));
}

TEST(answer, breakout_is_told_where_there_is_one)
{
  MadeRun made;
  made.dragged = 0.02;
  made.H = [](Real u) { return u < 0.006 ? 5e4 * u : u < 0.012 ? std::lerp(300, 200, (u - 0.006) / 0.006) : 200; };
  const std::string html = answer_of({made.record()});
  EXPECT_TRUE(holds(html, "H peaks first at u = 0.304 D (6.08 mm, 0.304 m in the prototype) with 0.298 kN/m")) << html;
  EXPECT_TRUE(holds(html, "then tends to 0.2 kN/m")) << html;
  EXPECT_TRUE(holds(html, "Displacement at breakout of the drag from w = 0.1 D<")) << html;
  EXPECT_TRUE(holds(html, "Breakout of the drag at u = 0.304 D: ")) << html;
  EXPECT_FALSE(holds(html, "no peak"));
}

TEST(answer, formulas_that_are_only_recalled_are_not_shown)
{
  const std::string html = answer_of({MadeRun{}.record()});
  EXPECT_TRUE(holds(html, "id=\"published-0\"")) << html;
  EXPECT_TRUE(holds(html, "DNVGL-RP-F114, table 4-4; BE, best estimate")) << html;
  EXPECT_TRUE(holds(html, "DNVGL-RP-F114, 4.4.2.3; passive wedge and friction, Kp with δ"));
  EXPECT_FALSE(holds(html, "Kp with φ")) << "no public source has that reading";
  EXPECT_FALSE(holds(html, "recalled"));
  EXPECT_FALSE(holds(html, "memory"));
  MadeRun clay;
  clay.law = MadeRun::clay_law();
  clay.contact.friction_angle = 0;
  const std::string in_clay = answer_of({clay.record()});
  EXPECT_TRUE(holds(in_clay, "DNVGL-RP-F114, 4.4.2.2; model 1, without suction behind the pipe, LE, low estimate")) << in_clay;
  EXPECT_TRUE(holds(in_clay, "DNV-RP-F114 (2021), equation 4.22; model 2"));
  EXPECT_FALSE(holds(in_clay, "Merifield, White and Randolph 2009"));
  EXPECT_FALSE(holds(in_clay, "Murff"));
}

TEST(answer, several_runs_stand_one_below_the_other_at_each_point)
{
  MadeRun other;
  other.name = "other <run>";
  other.V = [](Real w) { return 2e5 * w; };
  const std::string html = answer_of({MadeRun{}.record(), other.record()});
  const auto group = html.find("<tr class=\"group\"><th scope=\"row\" colspan=\"7\"><span>w = 0.05 D</span></th></tr>");
  ASSERT_NE(group, std::string::npos) << html;
  const auto first = html.find("<tr><th scope=\"row\">made</th>", group),
             second = html.find("<tr><th scope=\"row\">other &lt;run&gt;</th>", group);
  const auto next = html.find("<tr class=\"group\">", group + 1);
  EXPECT_LT(group, first);
  EXPECT_LT(first, second);
  EXPECT_LT(second, next);
  EXPECT_FALSE(holds(html, "<run>"));
}

TEST(answer, a_push_has_no_point_where_it_begins_but_one_where_it_ends)
{
  for (const settings::Method method : {settings::Method::mpm, settings::Method::fem}) {
    MadeRun made;
    made.method = method;
    made.first_w = 0.004;
    made.pushed_to = 0.0044;
    made.settles = false;
    made.dragged = 0;
    made.V = [](Real w) { return 17000 * (w - 0.004) / 0.0004; };
    const std::string html = answer_of({made.record()});
    EXPECT_FALSE(holds(html, "<th scope=\"row\">w = 0.2 D</th>")) << html;
    EXPECT_TRUE(holds(html, "<th scope=\"row\">end of the push</th><td class=\"number\">17.00</td><td class=\"number\">98.84</td><td "
                            "class=\"number\">850.0</td>"
                            "<td class=\"number\">0.2200</td><td class=\"number\">4.400</td><td class=\"number\">0.2200</td>"))
        << html;
  }
}

TEST(answer, an_end_at_a_round_embedment_stands_among_the_points_of_other_runs)
{
  MadeRun deeper;
  deeper.pushed_to = 0.004;
  const std::string html = answer_of({MadeRun{}.record(), deeper.record()});
  const auto group = html.find("<tr class=\"group\"><th scope=\"row\" colspan=\"7\"><span>w = 0.1 D</span></th></tr>");
  ASSERT_NE(group, std::string::npos) << html;
  const std::string rows = html.substr(group, html.find("<tr class=\"group\">", group + 1) - group);
  EXPECT_TRUE(std::count(rows.begin(), rows.end(), '\n') >= 3) << rows;  // the heading and two runs
  EXPECT_FALSE(holds(html, "end of the push"));
}

TEST(answer, a_push_that_was_stopped_or_killed_has_no_end_to_compare)
{
  MadeRun made;
  made.pushed_to = 0.00156;
  made.dragged = 0;
  record::RunRecord run = made.record();
  run.end = record::RunEnd::stopped;
  std::string html = answer_of({run});
  EXPECT_TRUE(holds(html, "in the prototype), where it was stopped, the pipe carries")) << html;
  EXPECT_TRUE(holds(html, "<th scope=\"row\">where it was stopped</th>"));
  EXPECT_TRUE(holds(html, "Where it was stopped, w = 0.078 D"));
  EXPECT_FALSE(holds(html, "nd of the push"));
  run.end = record::RunEnd::unfinished;
  html = answer_of({run});
  EXPECT_TRUE(holds(html, "in the prototype), as far as it got, the pipe carries")) << html;
  EXPECT_TRUE(holds(html, "As far as it got, w = 0.078 D"));
  EXPECT_FALSE(holds(html, "nd of the push"));
  // Stopped in the drag: the push came to its end, H did not.
  MadeRun dragged;
  dragged.pushed_to = 0.00156;
  run = dragged.record();
  run.end = record::RunEnd::stopped;
  html = answer_of({run});
  EXPECT_TRUE(holds(html, "End of the push, w = 0.078 D")) << html;
  EXPECT_TRUE(holds(html, "There is no peak: H grows to where it was stopped."));
}

TEST(answer, no_H_is_larger_than_the_largest)
{
  // H grows to the end of the drag at 0.5 D, where the table has a point: 300 N/m.
  const std::string html = answer_of({MadeRun{}.record()});
  EXPECT_TRUE(holds(
      html, "<th scope=\"row\">largest</th><td class=\"number\">0.3000</td><td class=\"number\">1.744</td><td class=\"number\">15.00</td>"
            "<td class=\"number\">0.5000</td><td class=\"number\">10.00</td><td class=\"number\">0.5000</td>"))
      << html;
  EXPECT_TRUE(holds(html, "straight line fitted to H or V within ±0.01 D of travel"));
  // An older folder has a largest H without the ends; a folder without a history has nothing else.
  record::RunRecord run = MadeRun{}.record();
  for (run_folder::Quantity& q : run.quantities)
    if (q.name == "H_max") q.value = 290;
  EXPECT_FALSE(holds(answer_of({run}), "0.2900"));
  run.history = {};
  EXPECT_TRUE(holds(answer_of({run}), "<td class=\"number\">0.3000</td>"));
  EXPECT_FALSE(holds(answer_of({run}), "0.2900"));
}

TEST(answer, a_drag_of_less_than_a_tenth_of_D_tells_its_largest_H)
{
  MadeRun made;
  made.method = settings::Method::fem;
  made.first_w = made.pushed_to = 0.006;
  made.dragged = 0.0016;
  made.H = [](Real u) { return u < 0.0008 ? 1e6 * u : 800 - 1e5 * (u - 0.0008); };
  const std::string html = answer_of({made.record()});
  EXPECT_FALSE(holds(html, "Its forces are not known"));
  EXPECT_TRUE(holds(
      html, "Wished in place at w = 0.3 D (6 mm, 0.3 m in the prototype) and dragged 0.08 D with V held, 0.8 kN/m (40 kN/m in the "
            "prototype, 4.65 γ′ D²) on average, the pipe mobilises at most H = 0.8 kN/m (40 kN/m in the prototype, 4.65 γ′ D²), at u = "
            "0.04 D (0.8 mm, "
            "0.04 m in the prototype)"))
      << html;
}

TEST(answer, what_cannot_be_trusted_is_named_beside_the_words)
{
  record::RunRecord run = MadeRun{}.record();
  EXPECT_FALSE(holds(answer_of({run}), "#trust"));
  run.quantities.push_back({"overlap_max_over_D", 0.03, "1"});
  const std::string html = answer_of({run});
  EXPECT_TRUE(holds(html, "<a href=\"#trust\">Reliability</a> low: deepest soil inside the pipe, in D – 0.03.")) << html;
}

TEST(answer, a_body_has_the_name_that_the_case_gives_it)
{
  MadeRun made;
  made.dragged = 0;
  record::RunRecord run = made.record();
  const auto call = [&](const char* name) {
    run.settings.rigid[0].first = run.settings.contact[0].second.rigid = name;
    for (settings::StageSettings& stage : run.settings.stage) stage.rigid = name;
  };
  call("footing");
  run.settings.rigid[0].second.shape = bodies::BoxSettings{{0, 0.01}, {0.02, 0.02}, 0};
  EXPECT_TRUE(holds(answer_of({run}), "the footing (D = ")) << answer_of({run});
  EXPECT_TRUE(holds(answer_of({run}), "). D is the width of the footing.</p>"));
  EXPECT_FALSE(holds(answer_of({run}), "the pipe "));
  bodies::PolygonSettings wedge;
  wedge.x = {-0.01, 0.01, 0};
  wedge.y = {0.02, 0.02, 0};
  run.settings.rigid[0].second.shape = wedge;
  call("steel_wedge<");
  EXPECT_TRUE(holds(answer_of({run}), "the steel wedge&lt;")) << answer_of({run});
  EXPECT_FALSE(holds(answer_of({run}), "wedge<"));
}

TEST(answer, forces_are_in_the_unit_of_the_largest)
{
  MadeRun made;
  made.dragged = 0;
  for (const auto& [largest, words] : std::vector<std::pair<Real, std::string>>{
           {99, "carries V = 99 N/m"}, {101, "carries V = 0.101 kN/m"}, {1e6, "carries V = 1000 kN/m"}, {2e7, "carries V = 20 MN/m"}}) {
    made.V = [size = largest](Real w) { return size * w / 0.002; };
    EXPECT_TRUE(holds(answer_of({made.record()}), words)) << words;
    EXPECT_EQ(words.substr(words.rfind(' ') + 1), text::unit_of_forces(largest, 2).name);
  }
  EXPECT_EQ(text::force_words(99, 2), "99 N/m");
  EXPECT_EQ(text::force_words(800, 2), "0.8 kN/m");
  EXPECT_EQ(text::force_words(800, 3), "0.8 kN");
}

TEST(answer, of_a_run_that_did_not_end_there_is_what_there_is)
{
  MadeRun made;
  made.dragged = 0.004;
  record::RunRecord run = made.record();
  run.end = record::RunEnd::unfinished;
  const std::string html = answer_of({run});
  EXPECT_TRUE(holds(html, "(not finished) Pushed to w = 0.1 D"));
  EXPECT_TRUE(holds(html, "Dragged 0.2 D"));
  run.history = {};
  run.quantities.clear();
  EXPECT_TRUE(holds(answer_of({run}), "Its forces are not known"));
}

TEST(answer, a_run_without_a_driven_body_tells_its_quantities_and_what_it_watches)
{
  record::RunRecord run = MadeRun{}.record();
  run.settings.stage.clear();
  run.quantities = {{"run_out", 1.234, "m"}};
  run.settings.watch = {{"ti<p", {"soil", {0, 0}}}};
  run.history.columns.push_back({"ti<p_uy_m", "ti<p uy", "m", "displacement", "ti<p"});
  run.history.values.emplace_back(run.history.rows(), -0.0125);
  const std::string html = answer_of({run});
  EXPECT_TRUE(holds(html, "no push or drag drives a body with a width."));
  EXPECT_TRUE(holds(html, "<th scope=\"row\">run_out</th><td class=\"number\">1.234</td><td>m</td>")) << html;
  EXPECT_TRUE(holds(html, "<th scope=\"row\">ti&lt;p_uy_m</th><td>displacement</td><td class=\"number\">-0.01250</td><td>m</td>")) << html;
  EXPECT_FALSE(holds(html, "<p_uy"));
  EXPECT_FALSE(holds(html, "Key results"));
  run.settings.watch.clear();
  run.quantities.clear();
  run.summary = run_folder::RunSummary{{}, {}, {{"momentum_error", 1e-3}}, {}, {}};
  EXPECT_TRUE(holds(answer_of({run}), "<th scope=\"row\">momentum_error</th><td class=\"number\">0.001000</td>"));
}

// w = 0.1 D: the contact reaches to 36.9 degrees from the invert, 2 sin b / (b + sin b cos b) = 1.068.
TEST(axial, resistance_by_friction_stands_beside_that_of_the_wedging_factor)
{
  EXPECT_FALSE(holds(answer_of({MadeRunInWater{}.record()}), "Axial friction resistance"));
  const std::string html = answer_of({MadeRunInWater{}.record_with_normal_force()});
  const std::size_t table = html.find("Axial friction resistance");
  ASSERT_NE(table, std::string::npos);
  for (const char* number : {">1.1", ">1.068", "White and Randolph 2007"}) EXPECT_NE(html.find(number, table), std::string::npos) << number;
}

}  // namespace
}  // namespace berm::report::this_file
