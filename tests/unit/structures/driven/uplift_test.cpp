// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/uplift.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

constexpr Real D = 0.02;

/// A pipe in sand with its invert at 2.5 D that is lifted by 0.5 D; `V` is that on the pipe after a travel.
record::RunRecord lifted(const std::function<Real(Real over_D)>& V)
{
  MadeRun made;
  made.first_w = made.pushed_to = 2.5 * D;
  made.dragged = 0;
  record::RunRecord run = made.record();
  run.settings.stage.push_back(MadeRun::stage_of("uplift", settings::StageKind::push));
  run.settings.stage.back().velocity = -0.1;
  for (int k = 1; k <= 250; ++k) {
    const Real row[] = {static_cast<Real>(run.history.rows()), 0, (2.5 - 0.002 * k) * D, 0, V(0.002 * k)};
    for (int column = 0; column < 5; ++column) run.history.values[column].push_back(row[column]);
    run.history.stage.emplace_back("uplift");
  }
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  return run;
}

TEST(Uplift, has_its_peak_the_travel_to_it_and_what_is_left)
{
  const record::RunRecord run = lifted([](Real u) { return u < 0.05 ? 100 - 2e4 * u : u < 0.25 ? -900 + 2000 * (u - 0.05) : -500; });
  EXPECT_NEAR(run.quantity("uplift.R_max")->value, 900, 20) << "the corner is rounded by the averaging";
  EXPECT_NEAR(run.quantity("uplift.travel_at_R_max")->value, 0.05 * D, 0.01 * D) << "averaged over 0.01 D to both sides";
  EXPECT_NEAR(run.quantity("uplift.travel_at_half_R_max")->value, 0.0275 * D, 0.002 * D);
  EXPECT_NEAR(run.quantity("uplift.R_end")->value, 500, 1);
  EXPECT_NEAR(run.quantity("uplift.w_begin")->value, 2.5 * D, 1e-12);
  EXPECT_EQ(run.quantity("uplift.R_max")->of, "uplift");
}

TEST(Uplift, is_not_told_of_a_pipe_that_is_only_unloaded)
{
  EXPECT_EQ(lifted([](Real u) { return 900 - 1000 * u; }).quantity("uplift.R_max"), nullptr);
}

TEST(Uplift, stands_in_the_words_and_beside_formulas)
{
  const record::RunRecord run = lifted([](Real u) { return u < 0.05 ? -1.8e4 * u : -900 + 1000 * (u - 0.05); });
  const base::Structure& pipe = structures::structure_of(run.settings);
  const base::DisplayUnits shown({{base::body_scale(run), &run.quantities}});
  EXPECT_NE(pipe.in_words(run, shown).find("uplift resistance"), std::string::npos);
  EXPECT_EQ(pipe.in_words(run, shown).find("growing"), std::string::npos) << "it falls";
  const record::RunRecord level = lifted([](Real u) { return u < 0.05 ? -1.8e4 * u : -900; });
  EXPECT_NE(pipe.in_words(level, shown).find("keeps it to the end"), std::string::npos) << pipe.in_words(level, shown);
  const record::RunRecord grows = lifted([](Real u) { return -1000 * u; });
  EXPECT_NE(pipe.in_words(grows, shown).find("still growing"), std::string::npos) << pipe.in_words(grows, shown);
  const base::Runs runs = {{&run, 0}};
  EXPECT_NE(pipe.key_results(runs, shown).find("key-uplift"), std::string::npos);
  EXPECT_NE(pipe.published_values(runs, shown).find("lifted from w = 2.5 D"), std::string::npos);
}

}  // namespace
}  // namespace berm::driven::this_file
