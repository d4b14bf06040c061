// SPDX-License-Identifier: BSD-3-Clause
#include "structures/penetration/penetration.hpp"

#include "formulas/footing.hpp"
#include "formulas/penetrometer.hpp"
#include "samples/made_push.hpp"
#include "samples/names_before_a_run.hpp"
#include "structures/base/general_measures.hpp"
#include "structures/penetration/penetration_results.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::penetration::this_file {
namespace {

const base::Structure& structure_of(const record::RunRecord& run)
{
  return structures::structure_of(run.settings);
}

base::DisplayUnits units_of(const record::RunRecord& run)
{
  return base::DisplayUnits({{base::body_scale(run), &run.quantities}});
}

std::string published(const record::RunRecord& run)
{
  return structure_of(run).published_values({{&run, 0}}, units_of(run));
}

MadePush clay_cone()
{
  MadePush made;
  made.q = [](Real z) { return 5e3 * z + (z < 1 ? 50e3 + 50e3 * z : 100e3); };
  return made;
}

MadePush footing()
{
  MadePush made;
  made.shape = bodies::BoxSettings{{0, 0.05}, {0.2, 0.1}, 0};
  made.pushed_to = 0.1;
  made.q = [](Real z) { return 5e3 * z + 6.048 * 10e3; };
  return made;
}

TEST(Penetration, has_no_results_but_those_that_are_known_before_a_run)
{
  for (const MadePush& made : {clay_cone(), footing()}) {
    const record::RunRecord run = made.record();
    EXPECT_EQ(surprises_of(run), std::vector<std::string>{});
    EXPECT_FALSE(knows(run.settings, "N_kt"));
  }
  EXPECT_FALSE(knows(clay_cone().settings(), "N_gamma_end"));
}

TEST(Penetration, of_a_cone_gives_the_numbers_of_a_log)
{
  const record::RunRecord run = clay_cone().record();
  const auto value = [&](const std::string& name) { return base::quantity_value(run, name); };
  EXPECT_NEAR(value("N_kt_at_z_1D"), 6, 1e-6);
  EXPECT_NEAR(value("q_t_at_z_2D"), 72e3, 1e-3);
  EXPECT_NEAR(value("N_kt_at_z_8D"), 10, 1e-6);
  EXPECT_TRUE(std::isnan(value("N_kt_at_z_10D")));  // the shoulder comes to 9.13 D
  EXPECT_NEAR(value("N_kt_end"), 10, 1e-6);
  EXPECT_NEAR(value("N_kt_steady"), 10, 1e-6);
  EXPECT_NEAR(value("z_at_N_kt_steady_over_D"), 4.5, 0.011);
  EXPECT_NEAR(value("area"), pi * 0.01, 1e-9);
  EXPECT_NEAR(value("w_end_of_push"), 2, 1e-9);
  EXPECT_TRUE(std::isnan(value("V_at_w_1D")));
  EXPECT_NE(structure_of(run).table_of(run).find("N_kt_at_z_8D"), std::string::npos);
}

TEST(Penetration, tells_results_from_measures_of_them)
{
  const record::RunRecord run = clay_cone().record();
  const auto is_answer = [&](const char* name) { return run.quantity(name)->kind == run_folder::QuantityKind::answer; };
  EXPECT_TRUE(is_answer("N_kt_end"));
  EXPECT_TRUE(is_answer("q_t_at_z_1D"));
  EXPECT_FALSE(is_answer("N_kt_change"));
  EXPECT_FALSE(is_answer("N_kt_scatter"));
  EXPECT_FALSE(is_answer("z_end"));
  EXPECT_FALSE(is_answer("area"));
}

TEST(Penetration, that_grows_to_the_end_is_not_steady)
{
  MadePush grows;
  grows.q = [](Real z) { return 60e3 * z; };
  const record::RunRecord growing = grows.record();
  EXPECT_NE(structure_of(growing).in_words(growing, units_of(growing)).find("<strong>not steady</strong>"), std::string::npos);
}

TEST(Penetration, puts_runs_side_by_side)
{
  MadePush one = clay_cone(), other = clay_cone();
  one.name = "fine", other.name = "coarse";
  other.q = [](Real z) { return 5e3 * z + 120e3; };
  const record::RunRecord fine = one.record(), coarse = other.record();
  const std::string html = structure_of(fine).key_results({{&fine, 0}, {&coarse, 1}}, units_of(fine));
  EXPECT_NE(html.find("N<sub>kt</sub>, fine"), std::string::npos);
  EXPECT_NE(html.find("N<sub>kt</sub>, coarse"), std::string::npos);
  EXPECT_NE(html.find("<svg"), std::string::npos);
  EXPECT_EQ(html.find("Houlsby"), std::string::npos);
}

TEST(Penetration, tells_the_band_of_a_factor)
{
  record::RunRecord run = clay_cone().record();
  run.summary.emplace();
  run_folder::Uncertainty& uncertainty = run.summary->uncertainty.emplace();
  run_folder::Band band;
  band.converged = 9.1;
  band.half_width = 0.5;
  uncertainty.quantities.push_back({"N_kt_end", "1", band});
  EXPECT_NE(structure_of(run).in_words(run, units_of(run)).find("converged 9.1 ± 0.5"), std::string::npos);
  EXPECT_NE(structure_of(run).key_results({{&run, 0}}, units_of(run)).find("<td class=\"number\">9.1 ± 0.5</td>"), std::string::npos);
}

TEST(Penetration, shows_cavities_beside_a_cone_and_nothing_that_is_recalled)
{
  const record::RunRecord run = clay_cone().record();
  const std::string html = published(run);
  EXPECT_NE(html.find("7.474"), std::string::npos) << html;
  EXPECT_NE(html.find("5.605"), std::string::npos);
  EXPECT_EQ(html.find("Teh"), std::string::npos);
  EXPECT_EQ(html.find("recalled"), std::string::npos);
}

TEST(Penetration, of_a_footing_has_its_exact_factors)
{
  MadePush made = footing();
  made.contact.adhesion = 10e3;
  const record::RunRecord rough = made.record();
  EXPECT_NEAR(base::quantity_value(rough, "N_c_end"), 6.048, 1e-6);
  EXPECT_NEAR(base::quantity_value(rough, "N_c_at_z_0.1D"), 6.048, 1e-6);
  EXPECT_NE(published(rough).find("6.048</td>"), std::string::npos) << published(rough);
  EXPECT_EQ(published(rough).find("5.689"), std::string::npos);
  EXPECT_FALSE(std::isnan(base::quantity_value(rough, "V_at_w_0.1D")));  // what any push has
  const record::RunRecord smooth = footing().record();
  EXPECT_NE(published(smooth).find("5.689"), std::string::npos);
  MadePush between = footing();
  between.contact.adhesion = 5e3;
  const record::RunRecord half_rough = between.record();
  EXPECT_NE(published(half_rough).find("5.689"), std::string::npos);
  EXPECT_NE(published(half_rough).find("6.048"), std::string::npos);
}

TEST(Penetration, of_a_footing_says_one_number_of_its_end_and_of_which_depths_it_is_the_mean)
{
  MadePush made = footing();
  made.contact.adhesion = 10e3;
  const record::RunRecord run = made.record();
  const std::string words = structure_of(run).in_words(run, units_of(run)),
                    tables = structure_of(run).key_results({{&run, 0}}, units_of(run));
  EXPECT_NE(words.find("N<sub>c</sub> = 6.05 (q = 60.9 kPa, V = 1.91 kN), means over z = 0.333 to 0.5 D"), std::string::npos) << words;
  EXPECT_EQ(words.find("carries V"), std::string::npos) << words;
  EXPECT_NE(words.find("On the surface of the soil below it N<sub>c</sub> is exactly 6.05 (rough base)."), std::string::npos) << words;
  EXPECT_EQ(tables.find("vertical resistance V at embedment w"), std::string::npos);
  EXPECT_NE(tables.find("0.333 to 0.5 D, mean"), std::string::npos) << tables;
  EXPECT_EQ(tables.find("<td>0.5</td>"), std::string::npos) << tables;
}

TEST(Penetration, of_a_footing_has_its_load_by_settlement_and_the_settlement_at_a_load_that_ends_the_push)
{
  MadePush made = footing();
  record::RunRecord run = made.record();
  const std::string tables = structure_of(run).key_results({{&run, 0}}, units_of(run));
  EXPECT_NE(tables.find("Load V by the depth z of the base of the footing, which is the settlement of one that begins on the bed"),
            std::string::npos)
      << tables;
  // z = 0.05 D = 10 mm: V = (5 kPa/m z + 60.48 kPa) times the area.
  EXPECT_NE(tables.find("<td class=\"number\">10.00</td><td class=\"number\">1.902</td>"), std::string::npos) << tables;
  run.settings.stage[0].until.force = 1.91e3;
  run.settings.stage[0].until.embedment = 0.5;
  const std::string words = structure_of(run).in_words(run, units_of(run));
  EXPECT_NE(words.find("Pushed until V = 1.91 kN: the base of the footing is then 0.5 D (100 mm) deep. There the probe"), std::string::npos)
      << words;
  run.settings.stage[0].until.embedment = 0.1;
  EXPECT_EQ(structure_of(run).in_words(run, units_of(run)).find("Pushed until V"), std::string::npos);
}

TEST(Penetration, of_a_footing_is_compared_with_one_on_the_surface_while_it_is_there_and_deeper_with_an_embedded_one)
{
  MadePush made = footing();
  made.contact.adhesion = 10e3;
  const std::string deep = published(made.record());
  EXPECT_NE(deep.find("of a footing on the surface of the soil below z = 0.42 D"), std::string::npos) << deep;
  EXPECT_NE(deep.find("out of range: at the surface"), std::string::npos) << deep;
  EXPECT_NE(deep.find("Skempton 1951; at z = 0.42 D"), std::string::npos) << deep;
  EXPECT_NE(deep.find("6.500</td>"), std::string::npos) << deep;  // 6 (1 + 0.2 x 0.4167)
  made.pushed_to = 0.004;                                         // 0.02 D
  EXPECT_EQ(published(made.record()).find("out of range"), std::string::npos);
}

TEST(Penetration, of_a_round_footing_in_space_has_the_factors_of_a_circle)
{
  MadePush made = footing();
  made.geometry = settings::Geometry::space;
  made.shape = bodies::CylinderSettings{{0, 0.05, 0}, {0, 1, 0}, 0.2, 0.1};
  made.contact.adhesion = 10e3;
  const record::RunRecord run = made.record();
  EXPECT_NEAR(base::quantity_value(run, "N_c_end"), 6.048, 1e-6);
  EXPECT_NE(published(run).find("6.048</td>"), std::string::npos) << published(run);
  made.shape = bodies::BoxSettings{{0, 0.05, 0}, {0.2, 0.1, 0.2}};
  EXPECT_EQ(published(made.record()).find("6.048</td>"), std::string::npos);
}

TEST(Penetration, of_a_footing_that_is_dragged_tells_V_H_and_M_of_its_failure)
{
  MadePush made = footing();
  made.geometry = settings::Geometry::plane_strain;
  record::RunRecord run = made.record();
  settings::StageSettings drag = run.settings.stage.front();
  drag.name = "drag";
  drag.kind = settings::StageKind::drag;
  run.settings.stage.push_back(drag);
  run.history.columns = columns_named({"time_s", "u_m", "w_m", "H_N_m", "V_N_m", "M_Nm_m"});
  run.history.values.emplace_back(run.history.stage.size(), 0);
  for (int k = 1; k <= 20; ++k) {
    const Real row[] = {1000. + k, 1e-3 * k, 0.1, k <= 10 ? 50. * k : 500., 900, 20};
    for (int c = 0; c < 6; ++c) run.history.values[c].push_back(row[c]);
    run.history.stage.emplace_back("drag");
  }
  run.quantities = structure_of(run).quantities(run, {});
  const auto value = [&](const char* name) { return base::quantity_value(run, name); };
  EXPECT_NEAR(value("V_at_H_max"), 900, 1e-6);
  EXPECT_NEAR(value("M_at_H_max"), 20 + 500 * 0.05, 1e-6);          // the centre is 0.05 m above the base
  EXPECT_NEAR(value("H_max_over_As_u"), 500 / (0.1 * 10e3), 1e-9);  // half of it beside the wall
  EXPECT_NEAR(value("M_at_H_max_over_ADs_u"), 45 / (0.1 * 0.2 * 10e3), 1e-9);
}

TEST(Penetration, of_a_footing_on_sand_has_N_gamma_of_associated_soil)
{
  MadePush made = footing();
  made.law = MadePush::sand();
  made.contact.scheme = contact::Scheme::tied;
  made.q = [](Real z) { return 0.5 * 5e3 * 0.2 * 15.53 + 5e3 * z; };
  const record::RunRecord run = made.record();
  EXPECT_NEAR(base::quantity_value(run, "N_gamma_end"), 15.53, 1e-6);
  EXPECT_NE(published(run).find("15.53"), std::string::npos);
  made.law.dilation_angle = 0;
  EXPECT_NE(published(made.record()).find("out of range"), std::string::npos);
}

/// A bar of 0.2 m in clay of 10 kPa with alpha = 0.4, at q = 50 kPa.
record::RunRecord pushed_t_bar()
{
  MadePush made;
  made.geometry = settings::Geometry::plane_strain;
  made.shape = bodies::CircleSettings{{0, -0.4}, 0.2};
  made.first_w = 0.5;
  made.law.density = 1;
  made.contact.adhesion = 4e3;
  made.q = [](Real) { return 50e3; };
  return made.record();
}

TEST(Penetration, of_a_t_bar_has_its_bounds)
{
  const record::RunRecord run = pushed_t_bar();
  const std::string html = published(run);
  EXPECT_NE(html.find("9.142"), std::string::npos) << html;
  EXPECT_NE(html.find("11.94"), std::string::npos);
  EXPECT_NEAR(base::quantity_value(run, "N_Tbar_end"), 10, 1e-3);
  EXPECT_EQ(html.find("out of range"), std::string::npos) << html;
}

TEST(Penetration, of_a_t_bar_under_an_open_cavity_is_not_compared_with_full_flow)
{
  record::RunRecord run = pushed_t_bar();
  run.quantities.push_back({"soil_above", 0.1, "1", "", run_folder::QuantityKind::quality, "push"});
  EXPECT_NE(published(run).find("out of range: the cavity above is open"), std::string::npos);
  const auto words_of = [](const record::RunRecord& one) { return structure_of(one).in_words(one, units_of(one)); };
  const std::string words = words_of(run);
  EXPECT_NE(words.find("still open</strong>: soil fills 10 % of the D/2 above it"), std::string::npos) << words;
  run.quantities.back().value = 0.9;
  EXPECT_EQ(published(run).find("out of range"), std::string::npos);
  EXPECT_EQ(words_of(run).find("still open"), std::string::npos);
}

TEST(Penetration, of_a_ball_stands_beside_the_table_where_it_is_shallow)
{
  MadePush made;
  made.shape = bodies::CircleSettings{{0, 0.1}, 0.2};
  made.law.density = 1e-6;
  made.q = [](Real z) { return formulas::smooth_sphere((z + 0.1) / 0.2).value * 4 / pi * 10e3; };
  const record::RunRecord run = made.record();
  EXPECT_EQ(&structure_of(run), &structures::all_structures()[1]);
  const std::string html = published(run);
  EXPECT_NE(html.find("at w = 0.3 D"), std::string::npos) << html;
  EXPECT_NE(html.find("3.198"), std::string::npos);
}

TEST(Penetration, measures_steadiness_and_the_room_around)
{
  const record::RunRecord run = clay_cone().record();
  const base::TrustMeasures measures = structure_of(run).measures(run.settings);
  const auto value = [&](const std::string& what) {
    const auto found = std::find_if(measures.begin(), measures.end(), [&](const base::TrustMeasure& m) { return m.what == what; });
    return found == measures.end() ? nan : found->value(run);
  };
  EXPECT_NEAR(value("change of N_kt over the end of the push"), 0, 1e-6);
  EXPECT_NEAR(value("nearest wall, over the plastic radius D/2 √I_r"), 4 / (0.1 * 10), 1e-6);
  EXPECT_TRUE(std::isnan(value("nearest wall from the middle, over D")));
  EXPECT_NEAR(value("soil below the probe at the end, over D"), 10, 1e-6);
}

TEST(Penetration, of_a_run_without_rows_says_nothing)
{
  record::RunRecord run = clay_cone().record();
  run.history = {};
  run.quantities.clear();
  EXPECT_TRUE(structure_of(run).quantities(run, {}).empty());
  EXPECT_EQ(structure_of(run).key_results({{&run, 0}}, units_of(run)), "");
  EXPECT_EQ(published(run), "");
  EXPECT_NE(structure_of(run).in_words(run, units_of(run)).find("did not reach the soil"), std::string::npos);
}

}  // namespace
}  // namespace berm::penetration::this_file
