// SPDX-License-Identifier: BSD-3-Clause
#include "structures/lateral/p_y.hpp"

#include "samples/made_push.hpp"

#include <gtest/gtest.h>

namespace berm::lateral::this_file {
namespace {

constexpr int slices = 4;
constexpr Real pivot = 5, depth = 8, k = 2e6;  // m, m, N/m2

/// A pile of 2 m, 8 m in the seabed, that turns about a point 5 m below it along `sign` x in soil with p = k y.
record::RunRecord pile(Real sign = 1)
{
  MadePush made;
  made.geometry = settings::Geometry::space;
  made.shape = bodies::CylinderSettings{{0, -2, 0}, {0, 1, 0}, 2, 12};
  record::RunRecord run;
  run.name = "made";
  run.settings = made.settings();
  run.settings.gravity = {0, -standard_gravity, 0};
  run.settings.rigid[0].second.depth_slices = slices;
  settings::StageSettings push_over;
  push_over.name = "push_over", push_over.kind = settings::StageKind::drive, push_over.rigid = "probe";
  push_over.drive.x.velocity = sign * 0.2;
  push_over.drive.rotation_z.free = true;
  run.settings.stage = {push_over};
  std::vector<std::string> names{"time_s", "u_m",  "w_m",   "H_N",   "V_N",   "Fx_N",       "Fy_N",       "Fz_N",      "dx_m",
                                 "dy_m",   "dz_m", "Mx_Nm", "My_Nm", "Mz_Nm", "anglex_rad", "angley_rad", "anglez_rad"};
  for (int n = 1; n <= slices; ++n) names.push_back("H" + std::to_string(n) + "_N");
  run.history = {columns_named(names), std::vector<std::vector<Real>>(names.size()), {}};
  for (int row = 0; row <= 40; ++row) {
    const Real tilt = row * 1e-3, d = (pivot - 2) * std::sin(tilt);
    std::vector<Real> values{Real(row), sign * d, depth, sign * 1e6 * tilt, 0, -sign * 1e6 * tilt, 0, 0, sign * d, 0, 0, 0, 0,
                             0,         0,        0,     -sign * tilt};
    for (int n = 0; n < slices; ++n) values.push_back(sign * k * (pivot - (n + 0.5) * depth / slices) * std::sin(tilt) * depth / slices);
    for (std::size_t c = 0; c < names.size(); ++c) run.history.values[c].push_back(values[c]);
    run.history.stage.emplace_back("push_over");
  }
  run.end = record::RunEnd::finished;
  return run;
}

TEST(PyCurves, are_resistance_per_metre_over_the_displacement_at_the_depth_of_each_slice)
{
  for (const Real sign : {1., -1.}) {
    const record::RunRecord run = pile(sign);
    const std::vector<PyCurve> curves = py_curves(LateralRun(run));
    ASSERT_EQ(curves.size(), 4u);
    for (int n = 0; n < slices; ++n) {
      EXPECT_NEAR(curves[n].z, 2 * n + 1, 1e-12);
      EXPECT_NEAR(curves[n].y.back(), (pivot - curves[n].z) * std::sin(0.04), 1e-6);
      EXPECT_EQ(curves[n].p.front(), 0) << "not what is averaged over the begin";
      for (std::size_t point = 1; point < curves[n].y.size(); ++point)
        EXPECT_NEAR(curves[n].p[point], k * curves[n].y[point], 1e-3 * k * std::abs(curves[n].y[point]) + 1) << n;
    }
    EXPECT_LT(curves.back().p.back(), 0) << "below the pivot the soil pushes the other way";
  }
}

TEST(PyCurves, stand_in_a_file_and_a_table)
{
  const record::RunRecord run = pile();
  const std::string csv = py_csv(LateralRun(run));
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "z_m,u_at_bed_m,y_m,p_N_m");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 4 * 21);
  EXPECT_NE(py_table(LateralRun(run), "pile-p-y").find("depth below the seabed"), std::string::npos);
}

TEST(PyCurves, are_none_without_slices)
{
  record::RunRecord run = pile();
  run.settings.rigid[0].second.depth_slices = 0;
  EXPECT_TRUE(py_curves(LateralRun(run)).empty());
  EXPECT_EQ(py_csv(LateralRun(run)), "");
}

TEST(PyCurves, are_a_chart_of_the_page_by_row)
{
  const record::RunRecord run = pile();
  const base::Charts charts = structures::structure_of(run.settings).charts(run);
  ASSERT_EQ(charts.size(), 5u) << "H, w and V over the displacement at the seabed, and no push";
  EXPECT_TRUE(curves_in(charts, "V_w").empty());
  EXPECT_NEAR(curves_in(charts, "H_u").front().x.back(), pivot * std::sin(0.04), 1e-6);
  const base::Chart& chart = charts.back();
  EXPECT_EQ(chart.id, "p_y");
  EXPECT_EQ(chart.title, "p-y curves by depth below the seabed");
  EXPECT_EQ(chart.x.symbol, "y");
  EXPECT_EQ(chart.y.unit, "N/m");
  ASSERT_EQ(chart.curves.size(), 4u);
  EXPECT_EQ(chart.curves.front().name, "1 m");
  ASSERT_EQ(chart.curves.front().x.size(), chart.curves.front().rows.size());
  for (const base::Curve& curve : chart.curves)
    for (std::size_t row = 0; row < curve.rows.size(); ++row) EXPECT_NEAR(curve.y[row], k * curve.x[row], 1e-6 * k) << curve.name;
  record::RunRecord without = run;
  without.settings.rigid[0].second.depth_slices = 0;
  EXPECT_TRUE(curves_in(structures::structure_of(without.settings).charts(without), "p_y").empty());
}

}  // namespace
}  // namespace berm::lateral::this_file
