// SPDX-License-Identifier: BSD-3-Clause
#include "structures/lateral/lateral_run.hpp"

#include "samples/made_pile.hpp"
#include "samples/names_before_a_run.hpp"
#include "structures/base/general_measures.hpp"
#include "structures/lateral/lateral_results.hpp"

#include <gtest/gtest.h>

namespace berm::lateral::this_file {
namespace {

constexpr Real height = MadePile::height, pivot = MadePile::pivot, depth_of_centre = MadePile::depth_of_centre;

record::RunRecord pile(Real sign = 1, Real weight = 0)
{
  return MadePile{sign, weight}.record();
}

TEST(Lateral, load_is_told_with_its_height_displacements_tilt_and_pivot)
{
  for (const Real sign : {1., -1.}) {
    const record::RunRecord run = pile(sign);
    const auto value = [&](const char* name) { return base::quantity_value(run, name); };
    EXPECT_STREQ(structures::structure_of(run.settings).word, "pile");
    EXPECT_NEAR(value("lateral_H_end"), 4e6, 1);
    EXPECT_NEAR(value("lateral_height_end"), height, 1e-9);
    EXPECT_NEAR(value("lateral_M_end"), 16e6, 1);
    EXPECT_NEAR(value("lateral_tilt_end"), 0.04, 1e-9);
    EXPECT_NEAR(value("lateral_u_end"), pivot * std::sin(0.04), 1e-9);
    EXPECT_NEAR(value("lateral_u_load_end"), (pivot + height) * std::sin(0.04), 1e-9);
    EXPECT_NEAR(value("lateral_pivot_end"), pivot, 1e-9);
    EXPECT_NEAR(value("lateral_H_end_over_DLsu"), 4e6 / (10e3 * 2 * 8), 1e-6);
    EXPECT_NEAR(value("lateral_H_max"), 4e6, 1);
    // u = 0.02 D = 40 mm at a tilt of 8 mrad.
    EXPECT_NEAR(value("lateral_H_at_u_0.02D"), 0.8e6, 1e2);
    EXPECT_TRUE(std::isnan(value("lateral_H_at_u_0.2D")));  // u comes to 0.1 D
    EXPECT_TRUE(std::isnan(value("w_end_of_push")));
  }
}

TEST(Lateral, load_has_no_results_but_those_that_are_known_before_a_run)
{
  const record::RunRecord run = pile();
  EXPECT_EQ(surprises_of(run), std::vector<std::string>{});
  EXPECT_FALSE(knows(run.settings, "q_b_end"));
}

TEST(Lateral, load_acts_where_its_line_cuts_the_leaning_axis_whatever_weight_is_there)
{
  const record::RunRecord run = pile(1, 2e6);
  EXPECT_NEAR(base::quantity_value(run, "lateral_height_end"), height, 1e-9);
  EXPECT_NEAR(base::quantity_value(run, "lateral_M_end"), height * (4e6 + 2e6 * std::tan(0.04)), 1);
}

TEST(Lateral, load_acts_at_the_point_that_the_case_names)
{
  record::RunRecord run = pile();
  run.settings.stage.back().drive.point = {0, height + 0.05, 0};
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  EXPECT_NEAR(base::quantity_value(run, "lateral_height_end"), height + 0.05, 1e-12);
  EXPECT_NEAR(base::quantity_value(run, "lateral_u_load_end"), (pivot + height + 0.05) * std::sin(0.04), 1e-9);
  const base::DisplayUnits shown({{base::body_scale(run), &run.quantities}});
  const std::string html = structures::structure_of(run.settings).key_results({{&run, 0}}, shown);
  EXPECT_NE(html.find("u at the load, mm"), std::string::npos) << html;
  EXPECT_NE(html.find("72.40</td>"), std::string::npos) << html;  // at u = 0.02 D = 40 mm: (pivot + height) times a tilt of 8 mrad
}

TEST(Lateral, load_is_an_answer_and_where_it_acts_is_prescribed)
{
  const record::RunRecord run = pile();
  EXPECT_EQ(curves_in(structures::structure_of(run.settings).charts(run), "H_u").size(), 1u);
  EXPECT_EQ(run.quantity("lateral_H_end")->kind, run_folder::QuantityKind::answer);
  EXPECT_NE(run.quantity("lateral_height_end")->kind, run_folder::QuantityKind::answer);
}

TEST(Lateral, u_of_the_page_is_that_at_the_bed_as_in_the_answer)
{
  for (const Real sign : {1., -1.}) {
    const record::RunRecord run = pile(sign);
    const std::optional<base::PointTravel> point = structures::structure_of(run.settings).point_travel(run);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->words, "displacement at the seabed");
    ASSERT_EQ(point->u.size(), run.history.stage.size());
    EXPECT_EQ(point->u.front(), 0) << "before the load";
    EXPECT_NEAR(point->u.back(), sign * pivot * std::sin(0.04), 1e-9);
    EXPECT_NEAR(std::abs(run.history["u_m"].back()), (pivot - depth_of_centre) * std::sin(0.04), 1e-9) << "that of the centre";
  }
}

TEST(Lateral, run_without_rows_has_no_results)
{
  record::RunRecord run = pile();
  run.history = {};
  run.quantities.clear();
  const base::Structure& structure = structures::structure_of(run.settings);
  const base::DisplayUnits shown({{base::body_scale(run), &run.quantities}});
  EXPECT_TRUE(structure.quantities(run, {}).empty());
  EXPECT_EQ(structure.key_results({{&run, 0}}, shown), "");
  EXPECT_EQ(structure.in_words(run, shown), "It was not loaded far enough for a result.");
  EXPECT_TRUE(structure.charts(run).empty());
  for (const base::TrustMeasure& measure : structure.measures(run.settings)) EXPECT_EQ(measure.what.find("pipe"), std::string::npos);
}

}  // namespace
}  // namespace berm::lateral::this_file
