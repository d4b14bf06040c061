// SPDX-License-Identifier: BSD-3-Clause
#include "material/clay.hpp"
#include "report/results/results_section.hpp"
#include "samples/made_run.hpp"

#include <functional>
#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

bool holds(const std::string& html, const std::string& part)
{
  return html.find(part) != std::string::npos;
}

/// In clay, with forces that are `larger` times those of the other method.
record::RunRecord by_method(settings::Method method, Real larger = 1)
{
  MadeRun made;
  made.name = method == settings::Method::mpm ? "mpm" : "fem";
  made.method = method;
  made.law = MadeRun::clay_law();
  made.V = [larger](Real w) { return larger * 4e5 * w; };
  record::RunRecord run = made.record();
  run.settings.fem.large_deformation = method == settings::Method::fem;
  return run;
}

struct TwoRuns {
  record::RunRecord mpm = by_method(settings::Method::mpm, 1.05), fem = by_method(settings::Method::fem);

  std::string html() const { return two_methods({mpm, fem}, judgements_of({mpm, fem})); }
  std::string verdict() const { return reliable_method({mpm, fem}, judgements_of({mpm, fem})); }
  /// The name of the run with which a page begins.
  std::string first() const
  {
    std::vector<record::RunRecord> runs = {mpm, fem};
    lead_with_reliable_method(runs);
    return runs.front().name;
  }
};

TEST(two_methods, stand_side_by_side_with_their_differences)
{
  const std::string html = TwoRuns{}.html();
  EXPECT_TRUE(html.starts_with("<h3>Two methods</h3>")) << html;
  EXPECT_TRUE(holds(html, "material point method (mpm)</th>")) << html;
  EXPECT_TRUE(holds(html, "finite elements (fem)</th>")) << html;
  EXPECT_TRUE(holds(html, "<code>V_at_w_0.05D</code> <span class=\"quiet\">vertical reaction in the push at an embedment</span></th>"
                          "<td>kN/m</td><td class=\"number\">0.4200</td><td class=\"number\">0.4000</td><td class=\"number\">+5.0</td>"))
      << html;
  EXPECT_TRUE(holds(html, "<code>H_at_u_0.3D</code>")) << html;
  EXPECT_TRUE(holds(html, "No difference exceeds 10 %.")) << html;
  EXPECT_FALSE(holds(html, "V_noise")) << "no key result: " << html;
  EXPECT_FALSE(holds(html, "V_end_of_push_over")) << "a dimensionless twin: " << html;
  const TwoRuns runs;
  EXPECT_TRUE(holds(results_section({runs.mpm, runs.fem}, judgements_of({runs.mpm, runs.fem})), html));
}

// V is 5 % larger by material points: at 0.05 D 0.42 beside 0.40 kN/m.
TEST(two_methods, with_bands_are_compared_at_size_0_and_within_them)
{
  TwoRuns runs;
  run_folder::Band band;
  band.converged = 408, band.half_width = 12;
  runs.mpm.summary.emplace().uncertainty.emplace().quantities = {{"V_at_w_0.05D", "N/m", band}};
  std::string html = runs.html();
  EXPECT_TRUE(holds(html, "within the bands")) << html;
  EXPECT_TRUE(holds(html, "0.408 ± 0.012</td><td class=\"number\">0.4000</td><td class=\"number\">+2.0</td><td>yes</td>")) << html;
  EXPECT_TRUE(holds(html, "1 of 1 results with a band agree within it.")) << html;
  runs.mpm.summary->uncertainty->quantities[0].band.half_width = 6;
  EXPECT_TRUE(holds(runs.html(), "<td>no</td>")) << runs.html();
  band.converged = 402, band.half_width = 3;
  runs.fem.summary.emplace().uncertainty.emplace().quantities = {{"V_at_w_0.05D", "N/m", band}};
  EXPECT_TRUE(holds(runs.html(), "<td>yes</td>")) << "bands of both meet: " << runs.html();
}

TEST(two_methods, are_those_of_one_case)
{
  TwoRuns runs;
  auto& bed = std::get<mesh::SeabedMesh>(runs.mpm.settings.mesh);
  bed.near_size = 0.001;
  runs.mpm.settings.body[0].second.particles_per_cell = 16;
  runs.mpm.settings.title = "another title";
  runs.mpm.settings.output.frame_travel = 0.001;
  EXPECT_NE(runs.html(), "") << "sizes, particles and output are no part of the case";
  const auto without = [](auto change) {
    TwoRuns changed;
    change(changed.fem.settings);
    return changed.html();
  };
  EXPECT_EQ(without([](settings::Case& c) {
              material::MohrCoulomb soil = MadeRun::clay_law();
              soil.cohesion = 1100;
              c.material = {{"soil", soil}};
            }),
            "")
      << "another soil";
  EXPECT_EQ(without([](settings::Case& c) { c.stage.pop_back(); }), "") << "other stages";
  EXPECT_EQ(without([](settings::Case& c) { std::get<mesh::SeabedMesh>(c.mesh).length = 1; }), "") << "another domain";
  EXPECT_EQ(without([](settings::Case& c) { c.rigid[0].second.shape = bodies::CircleSettings{{0, 0.015}, 0.03}; }), "") << "another pipe";
  EXPECT_EQ(without([](settings::Case& c) { c.fem.large_deformation = false; }), "") << "small strain";
  EXPECT_EQ(two_methods({runs.mpm, runs.mpm}, judgements_of({runs.mpm, runs.mpm})), "") << "one method";
  EXPECT_EQ(two_methods({runs.fem}, judgements_of({runs.fem})), "") << "one run";
}

TEST(two_methods, of_several_runs_of_a_case_the_finest_are_compared)
{
  const TwoRuns runs;
  record::RunRecord coarse = runs.mpm, fine = runs.fem;
  coarse.name = "coarse", fine.name = "fine";
  fine.summary.emplace().timing["nodes"] = 1000;
  const std::vector<record::RunRecord> all = {runs.mpm, coarse, runs.fem, fine};
  const std::string html = two_methods(all, judgements_of(all));
  EXPECT_TRUE(holds(html, "(mpm)</th>")) << html;
  EXPECT_TRUE(holds(html, "(fine)</th>")) << html;
  EXPECT_FALSE(holds(html, "coarse")) << html;
  EXPECT_FALSE(holds(html, "two-methods-2")) << html;
}

TEST(two_methods, cases_have_tables_of_their_own)
{
  const TwoRuns runs;
  TwoRuns others;
  for (record::RunRecord* run : {&others.mpm, &others.fem}) run->settings.stage.back().velocity = 0.2;
  const std::vector<record::RunRecord> all = {runs.mpm, others.mpm, runs.fem, others.fem};
  const std::string html = two_methods(all, judgements_of(all));
  EXPECT_TRUE(holds(html, "id=\"two-methods\"")) << html;
  EXPECT_TRUE(holds(html, "id=\"two-methods-2\"")) << html;
  EXPECT_GT(html.find("Rely on"), html.find("id=\"two-methods-2\"")) << "of the first case it stands on top of the page: " << html;
}

TEST(two_methods, in_clay_finite_elements_are_more_reliable_and_lead)
{
  const TwoRuns runs;
  const std::string html = runs.verdict();
  EXPECT_TRUE(
      html.starts_with("<p id=\"reliable-method\"><strong>Rely on the remeshed finite elements (fem).</strong> Their contact acts on "
                       "the exact surface"))
      << html;
  EXPECT_TRUE(holds(html, "examples/two_methods")) << html;
  EXPECT_TRUE(holds(html, "Material points (mpm) have an error of first order")) << html;
  EXPECT_FALSE(holds(html, "not been compared")) << html;
  EXPECT_EQ(runs.first(), "fem");
  EXPECT_FALSE(holds(runs.html(), "Rely on")) << "it stands on top of the page";
  const std::string answer = results_section({runs.fem, runs.mpm}, judgements_of({runs.fem, runs.mpm}));
  EXPECT_LT(answer.find("Rely on the remeshed"), answer.find("id=\"first-look\"")) << answer;
  EXPECT_EQ(reliable_method({runs.mpm}, judgements_of({runs.mpm})), "") << "of one method alone nothing is said";
}

/// Two runs whose cases are changed alike.
TwoRuns changed(const std::function<void(settings::Case&)>& change)
{
  TwoRuns runs;
  change(runs.mpm.settings), change(runs.fem.settings);
  return runs;
}

void make_softening(settings::Case& c)
{
  material::Clay clay;
  clay.undrained_strength = 1000, clay.sensitivity = 3;
  c.material = {{"soil", clay}};
}

TEST(two_methods, where_remeshing_does_worse_the_material_point_method_is_more_reliable_and_leads)
{
  const auto expect_mpm = [](const TwoRuns& runs, const std::string& why) {
    EXPECT_TRUE(holds(runs.verdict(), "<strong>Rely on the material point method (mpm).</strong> The reason: " + why)) << runs.verdict();
    EXPECT_EQ(runs.first(), "mpm");
  };
  expect_mpm(changed([](settings::Case& c) { c.material = {{"soil", MadeRun::sand_law()}}; }), "in soil with friction the material point");
  expect_mpm(changed(make_softening), "in softening clay H of remeshed");
  expect_mpm(changed([](settings::Case& c) {
               settings::StageSettings& storm = c.stage.emplace_back(MadeRun::stage_of("storm", settings::StageKind::push));
               storm.velocity.reset(), storm.force = 100;
               storm.load_times = {0, 1}, storm.load_factors = {0, 1};
             }),
             "recorded forces accelerate the body");
}

TEST(two_methods, what_remeshed_elements_are_not_compared_in_is_said)
{
  const auto expect_open = [](const TwoRuns& runs, const std::string& what) {
    EXPECT_EQ(runs.first(), "fem");
    EXPECT_TRUE(holds(runs.verdict(), " For " + what + " remeshed elements have not been compared with independent results."))
        << runs.verdict();
  };
  expect_open(changed([](settings::Case& c) {
                make_softening(c);
                std::erase_if(c.stage, [](const auto& stage) { return stage.kind == settings::StageKind::drag; });
              }),
              "softening clay");
  expect_open(changed([](settings::Case& c) {
                material::MohrCoulomb stiff = MadeRun::clay_law();
                stiff.cohesion = 2000;
                c.material.emplace_back("deep", stiff);
                c.body[0].second.soil_layer.push_back({.top = 0.1, .material = "deep"});
              }),
              "layered soil");
  expect_open(changed([](settings::Case& c) {
                c.stage.push_back(MadeRun::stage_of("back", settings::StageKind::drag));
                c.stage.back().velocity = -0.1;
              }),
              "drags to and fro");
  const auto pushed_up = [](bool to_a_force) {
    return changed([to_a_force](settings::Case& c) {
      c.stage.push_back(MadeRun::stage_of("up", settings::StageKind::push));
      c.stage.back().velocity = -0.1;
      if (to_a_force) c.stage.back().until.force = 100;
    });
  };
  expect_open(pushed_up(false), "uplift");
  EXPECT_FALSE(holds(pushed_up(true).verdict(), "uplift")) << "unloading is no uplift: " << pushed_up(true).verdict();
}

TEST(two_methods, a_run_with_a_fault_is_less_reliable_than_one_without)
{
  TwoRuns runs;
  runs.fem.end = record::RunEnd::stopped;
  EXPECT_TRUE(holds(runs.verdict(), "Rely on the material point method (mpm).</strong> fem: it has not finished.")) << runs.verdict();
  EXPECT_EQ(runs.first(), "mpm");
  runs.mpm.summary.emplace().checks["energy_error"] = 0.5;
  EXPECT_TRUE(holds(runs.verdict(), "Rely on the material point method (mpm).</strong> mpm: bad measure of trust: energy"))
      << "a run that stopped counts less than one with a bad measure: " << runs.verdict();
  runs.mpm.summary->invalid = {"energy does not balance"};
  EXPECT_TRUE(holds(runs.verdict(), "Neither run is reliable.</strong> mpm: its answer is invalid")) << runs.verdict();
  TwoRuns bad;
  bad.mpm.summary.emplace().checks["energy_error"] = 0.5;
  EXPECT_TRUE(holds(bad.verdict(), "Rely on the remeshed finite elements (fem).</strong> mpm: bad measure of trust: energy"))
      << bad.verdict();
  EXPECT_TRUE(holds(bad.verdict(), "exact surface")) << "the reason stands there, too: " << bad.verdict();
  EXPECT_TRUE(holds(bad.verdict(), "<a href=\"#two-methods\">")) << bad.verdict();
}

TEST(two_methods, large_differences_are_named_with_their_usual_causes)
{
  TwoRuns runs;
  runs.mpm = by_method(settings::Method::mpm, 1.2);
  const std::string html = runs.html();
  EXPECT_TRUE(holds(html, "The difference exceeds 10 % for <code>V_at_w_0.05D</code>, ")) << html;
  EXPECT_TRUE(holds(html, "inertia")) << html;
  EXPECT_TRUE(holds(html, "+20.0")) << html;
}

TEST(two_methods, names_of_runs_are_text)
{
  TwoRuns runs;
  runs.mpm.name = "<b>mpm</b>";
  EXPECT_FALSE(holds(runs.html() + runs.verdict(), "<b>")) << runs.html() << runs.verdict();
}

}  // namespace
}  // namespace berm::report::this_file
