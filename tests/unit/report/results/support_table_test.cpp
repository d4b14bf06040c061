// SPDX-License-Identifier: BSD-3-Clause
#include "report/results/results_section.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

record::RunRecord run_on_base()
{
  record::RunRecord run = MadeRun{}.record();
  run.settings.support = {{"base", {"bottom", {"x", "y"}}}};
  run.settings.output.support_reactions = true;
  const auto rows = static_cast<std::size_t>(run.history.rows());
  for (const char* name : {"base_Fx_N_m", "base_Fy_N_m"}) {
    run.history.columns.push_back({name, "", "N/m", "", "base"});
    run.history.values.emplace_back(rows, name[6] == 'x' ? -1230. : 45600.);
  }
  return run;
}

TEST(SupportTable, has_a_row_for_each_stage_and_support)
{
  EXPECT_EQ(support_table({MadeRun{}.record()}), "");
  const std::string html = support_table({run_on_base()});
  for (const char* part : {"push", "drag", "base", "kN/m", "-1.23", "45.6"})
    EXPECT_NE(html.find(part), std::string::npos) << "no " << part << " in " << html;
}

TEST(SupportTable, leaves_out_a_support_that_is_released)
{
  record::RunRecord run = run_on_base();
  run.settings.support[0].second.stages = {"drag"};
  const std::string html = support_table({run});
  EXPECT_EQ(html.find("push"), std::string::npos) << html;
  EXPECT_NE(html.find("drag"), std::string::npos) << html;
}

}  // namespace
}  // namespace berm::report::this_file
