// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/run_charts.hpp"

#include "record/travel_curve.hpp"
#include "samples/made_run.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::driven::this_file {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const record::RunRecord& run)
{
  return Json::parse(structures::curves_json(run));
}

const Json& chart_of(const Json& json, const std::string& id)
{
  for (const Json& chart : json["charts"])
    if (chart["chart"] == id) return chart;
  ADD_FAILURE() << "there is no chart " << id;
  return json;
}

TEST(RunCharts, have_the_rows_of_the_history_and_the_same_freed_from_noise)
{
  MadeRun made;
  made.H = [](Real u) { return 3e4 * u + 50 * std::sin(1e5 * u); };
  const record::RunRecord run = made.record();
  const Json json = json_of(run);
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["history_rows"], run.history.rows());
  const Json &chart = chart_of(json, "H_u"), &drag = chart["curves"].at(0);
  EXPECT_EQ(chart["x"]["symbol"], "u");
  EXPECT_EQ(chart["y"]["unit"], "N/m");
  EXPECT_EQ(drag["name"], "drag");
  ASSERT_EQ(drag["rows"].size(), drag["y"].size());
  const Index first = drag["rows"][0];
  EXPECT_NE(run.history.stage[first], "drag") << "it begins with the row before its first";
  std::vector<Real> u, H;
  for (std::size_t k = 0; k < drag["rows"].size(); ++k) {
    const Index row = drag["rows"][k];
    u.push_back(run.history["u_m"][row] - run.history["u_m"][first]), H.push_back(run.history["H_N_m"][row]);
    ASSERT_EQ(drag["x"][k], u.back());
    ASSERT_EQ(drag["y"][k], H.back());
    ASSERT_EQ(chart_of(json, "w_u")["curves"][0]["y"][k], run.history["w_m"][row]);
  }
  const Real half = averaging_half(base::body_scale(run));
  EXPECT_EQ(drag["smoothed"].get<std::vector<Real>>(), record::drawn_along(u, H, half));
  EXPECT_EQ(chart_of(json, "H_travel")["curves"][0]["y"].get<std::vector<Real>>(), record::TravelCurve(u, H).smoothed(half).value());
}

TEST(RunCharts, leave_the_way_down_to_the_bed_as_it_is)
{
  MadeRun made;
  made.first_w = -0.001;
  made.V = [](Real w) { return w < 0 ? 0. : 1e3 + 4e5 * w; };
  const Json json = json_of(made.record()), &push = chart_of(json, "V_w")["curves"][0];
  std::size_t above = 0;
  for (std::size_t k = 0; k < push["x"].size(); ++k)
    if (push["x"][k] < 0) {
      ++above;
      EXPECT_EQ(push["smoothed"][k], 0);
    }
  EXPECT_GT(above, 20u);
  EXPECT_NEAR(push["smoothed"][above].get<Real>(), 1e3, 30) << "V = 0 above the bed does not smooth away the first touch";
}

TEST(RunCharts, of_a_drag_back_have_H_along_x_over_u_from_the_first_drag)
{
  MadeRun made;
  record::RunRecord run = made.record();
  run.settings.stage.push_back(MadeRun::stage_of("back", settings::StageKind::drag));
  run.settings.stage.back().velocity = -0.1;
  for (int k = 1; k <= 100; ++k) {
    const Real row[] = {static_cast<Real>(run.history.rows()), made.dragged - 4e-5 * k, 0.007, -200, 800};
    for (int column = 0; column < 5; ++column) run.history.values[column].push_back(row[column]);
    run.history.stage.emplace_back("back");
  }
  const Json json = json_of(run), &back = chart_of(json, "H_u")["curves"].at(1);
  EXPECT_EQ(back["direction"], -1);
  EXPECT_NEAR(back["x"][0].get<Real>(), made.dragged, 1e-12);
  EXPECT_NEAR(back["x"].back().get<Real>(), made.dragged - 4e-3, 1e-12);
  EXPECT_EQ(back["y"].back(), -200);
  EXPECT_NEAR(chart_of(json, "H_travel")["curves"].at(1)["y"].back().get<Real>(), 200, 1e-9) << "against the drag";
}

TEST(RunCharts, have_the_bands_of_the_summary_and_null_where_nothing_is_known)
{
  record::RunRecord run = MadeRun{}.record();
  run.summary.emplace().uncertainty.emplace().curves = {{"V_w", {0, 0.001}, {nan, 100}, {nan, 300}}};
  const Json json = json_of(run);
  EXPECT_EQ(chart_of(json, "V_w")["bands"], Json::parse(R"([{"x": [0.0, 0.001], "low": [null, 100.0], "high": [null, 300.0]}])"));
  EXPECT_TRUE(chart_of(json, "H_u")["bands"].empty());
}

TEST(RunCharts, are_none_without_a_driven_body)
{
  record::RunRecord run = MadeRun{}.record();
  run.history = {columns_named({"time_s"}), {{0, 1}}, {"rest", "rest"}};
  run.settings.rigid.clear(), run.settings.contact.clear();
  run.settings.stage.clear();
  EXPECT_TRUE(json_of(run)["charts"].empty());
}

}  // namespace
}  // namespace berm::driven::this_file
