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

}  // namespace
}  // namespace berm::report::this_file
