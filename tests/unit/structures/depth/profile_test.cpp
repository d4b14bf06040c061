// SPDX-License-Identifier: BSD-3-Clause
#include "structures/depth/profile_page.hpp"

#include "samples/history_columns.hpp"
#include "samples/made_push.hpp"

#include <gtest/gtest.h>

namespace berm::depth::this_file {
namespace {

constexpr int slices = 4;
constexpr Real height = 8, drag = -3e3, carried = 5e3;  // m; N/m of depth, above and below the middle

/// A pile in 8 m of soil that drags it down over its upper half and carries it over its lower half and its base, while it goes down by 20 mm. Before the last tenth of the
/// time there is nothing on it.
record::RunRecord dragged_pile()
{
  MadePush made;
  made.geometry = settings::Geometry::axisymmetric;
  record::RunRecord run;
  run.name = "made";
  run.settings = made.settings();
  run.settings.rigid[0].second.depth_slices = slices;
  settings::StageSettings settle;
  settle.name = "settle";
  run.settings.stage = {settle};
  std::vector<std::string> names{"time_s", "w_m", "V_N"};
  for (int n = 1; n <= slices; ++n) names.push_back("V_shaft" + std::to_string(n) + "_N");
  names.emplace_back("V_base_N");
  run.history = {columns_named(names), std::vector<std::vector<Real>>(names.size()), {}};
  for (run_folder::Column& column : run.history.columns) column.of = run.settings.rigid[0].first;
  for (int row = 0; row <= 100; ++row) {
    const Real now = row < 90 ? 0 : 1;
    std::vector<Real> values{0.1 * row, height + 2e-4 * row, 0};
    for (int n = 0; n < slices; ++n) values.push_back(now * (n < 2 ? drag : carried) * height / slices);
    values.push_back(now * 7e3);
    for (std::size_t c = 0; c < names.size(); ++c) run.history.values[c].push_back(values[c]);
    run.history.stage.emplace_back("settle");
  }
  return run;
}

TEST(DepthProfile, has_the_axial_force_from_the_base_up_the_drag_load_and_the_neutral_plane)
{
  const std::vector<Profile> all = profiles(dragged_pile());
  ASSERT_EQ(all.size(), 1u);
  const Profile& p = all[0];
  EXPECT_TRUE(p.whole);
  EXPECT_TRUE(p.h.empty());
  EXPECT_NEAR(p.v[0], drag, 1e-9);
  EXPECT_NEAR(p.v[3], carried, 1e-9);
  EXPECT_NEAR(p.axial[4], 7e3, 1e-9);
  EXPECT_NEAR(p.axial[2], 7e3 + carried * 4, 1e-9);
  EXPECT_NEAR(p.axial[0], 7e3 + carried * 4 + drag * 4, 1e-9);
  EXPECT_NEAR(p.drag_load(), 12e3, 1e-9);
  EXPECT_NEAR(p.neutral_plane(), 4, 1e-12);
}

TEST(TzCurves, are_shaft_friction_over_the_way_down_of_the_body)
{
  const std::vector<TzCurve> curves = tz_curves(dragged_pile());
  ASSERT_EQ(curves.size(), static_cast<std::size_t>(slices));
  EXPECT_NEAR(curves[1].z, 3, 1e-12);
  EXPECT_EQ(curves[1].t.front(), 0);
  EXPECT_NEAR(curves[1].t.back(), drag, 1e-9);
  EXPECT_NEAR(curves[1].w.back(), 0.0196, 2e-4) << "the mean of the last twentieth: a row at its begin may count to it or not";
}

TEST(DepthProfile, stands_in_files_and_on_the_page)
{
  const record::RunRecord run = dragged_pile();
  const std::string csv = profile_csv(run);
  EXPECT_EQ(csv.find("body,stage,z_top_m,z_bottom_m,H_N_m,V_N_m,axial_top_N,axial_bottom_N\n"), 0u);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + slices);
  EXPECT_EQ(tz_csv(run).find("body,stage,z_m,w_m,t_N_m\n"), 0u);
  const std::string html = profile_section(run, "results-0");
  for (const char* part : {"drags probe down with 12 kN above a neutral plane 4 m below the bed",
                           "below it: shaft friction 20 kN, base resistance 7 kN", "<svg", "<table"})
    EXPECT_NE(html.find(part), std::string::npos) << part << " is not in\n" << html;
}

TEST(DepthProfile, of_a_body_that_is_loaded_along_the_bed_has_no_neutral_plane)
{
  record::RunRecord run = dragged_pile();
  run.settings.geometry = settings::Geometry::space;
  run.settings.stage[0].kind = settings::StageKind::drag;
  const std::string html = profile_section(run, "results-0");
  EXPECT_EQ(html.find("neutral plane"), std::string::npos) << html;
  EXPECT_NE(html.find("shaft friction 8 kN, base resistance 7 kN"), std::string::npos) << html;
}

TEST(DepthProfile, is_none_without_slices)
{
  record::RunRecord run = dragged_pile();
  run.settings.rigid[0].second.depth_slices = 0;
  EXPECT_TRUE(profiles(run).empty());
  EXPECT_TRUE(tz_curves(run).empty());
  EXPECT_EQ(profile_csv(run) + tz_csv(run) + profile_section(run, "x"), "");
}

}  // namespace
}  // namespace berm::depth::this_file
