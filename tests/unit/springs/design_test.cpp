// SPDX-License-Identifier: BSD-3-Clause
#include "springs/design.hpp"

#include "os/error.hpp"
#include "samples/made_run.hpp"
#include "samples/temporary_folder.hpp"
#include "study/sample.hpp"
#include "study/study_rows.hpp"

#include <gtest/gtest.h>

namespace berm::springs::this_file {
namespace {

/// A finite element run with a peak of `peak` N/m at 0.05 D and two thirds of it from 0.15 D on.
Springs with_peak(Real peak)
{
  MadeRun run;
  run.method = settings::Method::fem;
  run.gravity_level = 1;
  run.H = [peak](Real u) { return peak * (u < 0.001 ? u / 0.001 : u < 0.003 ? 1 - (u - 0.001) / 0.006 : 2. / 3); };
  return springs_of(run.record());
}

/// Peaks whose logarithms are the middles of twenty equal shares of a normal distribution.
std::vector<Springs> draws()
{
  std::vector<Springs> all;
  for (int k = 0; k < 20; ++k) all.push_back(with_peak(60 * std::exp(0.2 * study::standard_normal_quantile((k + 0.5) / 20))));
  return all;
}

const Estimate& estimate(const Design& design, const std::string& spring, const std::string& name)
{
  for (const Estimate& e : design.estimates)
    if (e.spring == spring && e.name == name) return e;
  throw std::runtime_error("no estimate of " + spring + " " + name);
}

TEST(Design, of_a_sample_has_its_quantiles_and_the_distribution_that_made_it)
{
  const Design design = design_of_sample("pipe", with_peak(60), draws());
  const Estimate& peak = estimate(design, "lateral drag", "peak");
  EXPECT_EQ(peak.size, 20u);
  EXPECT_NEAR(peak.best, 60, 1e-9);
  // 5 % lies between the first and the second of twenty, as Hazen places them: at 2.5 and 7.5 %.
  const auto of_share = [](Real share) { return 60 * std::exp(0.2 * study::standard_normal_quantile(share)); };
  EXPECT_NEAR(peak.low, (of_share(0.025) + of_share(0.075)) / 2, 1e-6);
  EXPECT_NEAR(peak.middle, (of_share(0.475) + of_share(0.525)) / 2, 1e-6);
  EXPECT_NEAR(peak.high, (of_share(0.925) + of_share(0.975)) / 2, 1e-6);
  EXPECT_NEAR(peak.fit.mean, std::log(60), 1e-9);
  EXPECT_NEAR(peak.fit.deviation, 0.2, 0.01);
  EXPECT_TRUE(peak.fit.fits());
}

TEST(Design, low_and_high_have_the_forces_of_the_sample_at_the_displacements_of_the_best_run)
{
  const Design design = design_of_sample("pipe", with_peak(60), draws());
  for (const auto& [set, which] : {std::pair(&*design.low, &Estimate::low), std::pair(&*design.high, &Estimate::high)}) {
    const Lateral &l = set->lateral.at(0), &best = design.best.lateral.at(0);
    EXPECT_EQ(l.peak, estimate(design, "lateral drag", "peak").*which);
    EXPECT_EQ(l.residual, estimate(design, "lateral drag", "residual").*which);
    EXPECT_EQ(l.u_peak, best.u_peak);
    EXPECT_EQ(l.u_residual, best.u_residual);
    EXPECT_EQ(l.spring().size(), best.spring().size());
  }
  EXPECT_LT(design.low->lateral[0].peak, design.best.lateral[0].peak);
  EXPECT_GT(design.high->lateral[0].peak, design.best.lateral[0].peak);
}

TEST(Design, of_a_sample_without_a_best_run_has_the_middle_of_all)
{
  const Design design = design_of_sample("pipe", std::nullopt, draws());
  EXPECT_TRUE(std::isnan(estimate(design, "lateral drag", "peak").best));
  EXPECT_EQ(design.best.lateral.at(0).peak, estimate(design, "lateral drag", "peak").middle);
  EXPECT_EQ(design.best.lateral.at(0).u_peak, estimate(design, "lateral drag", "u_peak").middle);
}

TEST(Design, counts_only_the_draws_that_have_a_number)
{
  std::vector<Springs> some = draws();
  for (int k = 0; k < 5; ++k) some[k].lateral[0].residual = nan;
  EXPECT_EQ(estimate(design_of_sample("pipe", with_peak(60), some), "lateral drag", "residual").size, 15u);
}

TEST(Design, counts_no_stiffness_that_is_negative_or_zero)
{
  std::vector<Springs> some = draws();
  for (std::size_t k = 0; k < some.size(); ++k) some[k].vertical.unloading = {{"unload", 80, 40, k < 4 ? -1e5 : k < 6 ? 0 : 2e5}};
  Springs best = with_peak(60);
  best.vertical.unloading = {{"unload", 80, 40, -1e4}};
  const Design design = design_of_sample("pipe", best, some);
  const Estimate& e = estimate(design, "vertical", "unload.stiffness");
  EXPECT_TRUE(std::isnan(e.best));
  EXPECT_EQ(e.size, 14u);
  EXPECT_EQ(e.low, 2e5);
}

TEST(Design, has_the_preload_of_the_bed_beside_the_virgin_curve)
{
  Springs best = with_peak(60);
  best.vertical.curve = {{0.001, 100}, {0.002, 200}};
  best.vertical.preload = 250;
  const Design design = design_of_sample("pipe", best, draws());
  EXPECT_EQ(estimate(design, "vertical", "V_at_w_0.05D").meaning, "V in the push at an embedment");
  EXPECT_EQ(estimate(design, "vertical", "preload").best, 250);
}

TEST(Design, has_low_and_high_of_ten_draws_and_not_of_nine)
{
  std::vector<Springs> some = draws();
  some.resize(10);
  EXPECT_TRUE(design_of_sample("pipe", with_peak(60), some).low.has_value());
  some.resize(9);
  const Design design = design_of_sample("pipe", with_peak(60), some);
  EXPECT_FALSE(design.low.has_value() || design.high.has_value());
  EXPECT_EQ(estimate(design, "lateral drag", "peak").size, 9u);
}

TEST(Design, is_refused_of_a_folder_that_is_neither_run_nor_study_and_of_a_study_without_a_sample)
{
  const TemporaryFolder folder;
  const auto words = [&] {
    try {
      designs_in(folder.path());
    } catch (const RunError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(words().find("neither a run folder nor the output of berm study"), std::string::npos) << words();
  folder.write("study.json", R"({"title": "", "rows": [{"names": ["a"], "kind": "row", "run": "runs/a", "finished": true}]})");
  EXPECT_NE(words().find("has no sample"), std::string::npos) << words();
  folder.write("study.json", R"({"rows": [{"names": "a"}]})");
  EXPECT_NE(words().find("study.json is damaged"), std::string::npos) << words();
  folder.write("study.json", R"({"rows": [{"names": ["a"], "kind": "draw", "run": "runs/a", "finished": false}]})");
  EXPECT_NE(words().find("no run of the sample of a is finished"), std::string::npos) << words();
}

}  // namespace
}  // namespace berm::springs::this_file
