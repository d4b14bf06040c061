// SPDX-License-Identifier: BSD-3-Clause
#include "structures/penetration/depth_log.hpp"

#include "samples/drawn_run.hpp"
#include "samples/made_push.hpp"
#include "structures/penetration/penetration.hpp"
#include "structures/penetration/penetrometers.hpp"

namespace berm::penetration::this_file {
namespace {

namespace fs = std::filesystem;

class DepthLogPicture : public DrawnRun {};

record::RunRecord noisy(Real gradient)
{
  MadePush made;
  made.method = settings::Method::mpm;
  made.law.cohesion_gradient = gradient;
  return made.record();
}

plot::Panels log_of(const record::RunRecord& record)
{
  PenetrationRuns runs;
  runs.emplace_back(record, cone());
  return depth_log(runs, "a log");
}

TEST(DepthLog, has_resistance_and_factor_and_strength_where_it_varies)
{
  const record::RunRecord uniform = noisy(0), growing = noisy(1e3);
  const plot::Panels log = log_of(uniform);
  ASSERT_EQ(log.panels.size(), 2u);
  EXPECT_EQ(log.panels[0].title, "q_t (kPa)");
  EXPECT_EQ(log.panels[1].title, "N_kt");
  EXPECT_EQ(log.y_label, "depth z of the shoulder of the cone (m)");
  EXPECT_NEAR(log.panels[0].high / log.second, (2 - 0.1 * std::sqrt(3.)) / 0.2, 1e-9);
  EXPECT_GE(log.panels[0].right, 100);
  EXPECT_LE(log.panels[0].right, 150);
  EXPECT_EQ(log_of(growing).panels.size(), 3u);
}

TEST(DepthLog, has_the_friction_of_a_shaft_that_carries)
{
  MadePush made;
  made.shaft = [](Real z) { return 2e3 * pi * 0.2 * std::max(z, Real(0)); };
  const record::RunRecord record = made.record();
  const plot::Panels log = log_of(record);
  ASSERT_EQ(log.panels.size(), 3u);
  EXPECT_EQ(log.panels[1].title, "f (kPa)");
}

TEST(DepthLog, shows_nothing_that_is_only_recalled)
{
  const record::RunRecord record = noisy(0);
  for (const plot::Panel& panel : log_of(record).panels)
    for (const plot::PanelCurve& curve : panel.curves) EXPECT_EQ(curve.name.find("Houlsby"), std::string::npos) << curve.name;
}

TEST(DepthLog, of_a_run_without_rows_is_empty)
{
  record::RunRecord record = noisy(0);
  record.history = {};
  EXPECT_TRUE(log_of(record).panels.empty());
  EXPECT_EQ(svg_of(log_of(record)), "");
}

TEST(DepthLog, as_svg_has_depth_downwards_and_axes_on_top)
{
  const record::RunRecord record = noisy(0);
  const std::string svg = svg_of(log_of(record));
  EXPECT_NE(svg.find("N<tspan dy=\"4\" font-size=\"80%\">kt</tspan>"), std::string::npos);
  EXPECT_NE(svg.find(">z/D</text>"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(DepthLog, has_its_curves_over_depth_by_row_and_freed_from_noise)
{
  const record::RunRecord record = noisy(1e3);
  const base::Charts charts = pushed_down(cone()).charts(record);
  const PenetrationRun run(record, cone());
  ASSERT_EQ(curves_in(charts, "q_z").size(), 1u);
  const base::Curve& q = curves_in(charts, "q_z").front();
  EXPECT_EQ(q.y, run.q_curve().value());
  EXPECT_EQ(q.smooth, record::drawn_along(run.q_curve().travel(), run.q_curve().value(), run.half()));
  EXPECT_EQ(curves_in(charts, "N_z").size(), 1u);
  EXPECT_EQ(curves_in(charts, "V_w").size(), 1u) << "it is pushed as any body is";
}

TEST_F(DepthLogPicture, is_curves_png_of_a_run)
{
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const record::RunRecord run = noisy(1e3);
  const base::Structure structure = pushed_down(cone());
  structure.write_files(folder, run);
  ASSERT_TRUE(structure.draw_curves(folder, run, {}));
  EXPECT_EQ(png_size(folder.file("curves.png")), (std::pair{1200, 900}));
  EXPECT_TRUE(fs::exists(folder.file("plots/log_0.dat")));
  const std::string csv = content_of(folder.file("log.csv"));
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "z_m,w_m,q_Pa,factor,q_mean_Pa,factor_mean,f_shaft_Pa,s_u_Pa,sigma_v0_Pa");
  EXPECT_EQ(csv.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace berm::penetration::this_file
