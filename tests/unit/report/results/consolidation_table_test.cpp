// SPDX-License-Identifier: BSD-3-Clause
#include "report/results/results_section.hpp"

#include "samples/made_run_in_water.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

TEST(ConsolidationTable, has_a_row_for_each_stage_of_runs_whose_water_flows)
{
  EXPECT_EQ(consolidation_table({MadeRun{}.record()}), "");
  const std::string html = consolidation_table({MadeRun{}.record(), MadeRunInWater{}.record()});
  const auto holds = [&](const char* part) { return html.find(part) != std::string::npos; };
  EXPECT_TRUE(holds("c_v = 0.0004 m2/s")) << html;
  EXPECT_TRUE(holds("partially drained")) << html;
  EXPECT_TRUE(holds("75")) << html;
  EXPECT_TRUE(holds("4 s")) << html;
}

// t50 = 4 s of the run; soil that is so many times less permeable takes so many times as long.
TEST(ConsolidationTable, gives_t50_in_the_time_of_the_soil_where_the_permeability_of_the_run_is_another)
{
  const auto table_of = [](Real times_slower) {
    record::RunRecord run = MadeRunInWater{}.record();
    material::LinearElastic law = MadeRunInWater::soil();
    law.water->real_permeability = *law.water->permeability / times_slower;
    run.settings.material[0].second = law;
    return consolidation_table({run});
  };
  EXPECT_NE(table_of(1e6).find("46.3 days (4 s)"), std::string::npos) << table_of(1e6);  // 4e6 s
  EXPECT_NE(table_of(1e4).find("11.1 h (4 s)"), std::string::npos) << table_of(1e4);
}

}  // namespace
}  // namespace berm::report::this_file
