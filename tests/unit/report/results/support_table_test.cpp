// SPDX-License-Identifier: BSD-3-Clause
#include "report/results/results_section.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

TEST(SupportTable, has_a_row_for_each_stage_and_support)
{
  EXPECT_EQ(support_table({MadeRun{}.record()}), "");
  record::RunRecord run = MadeRun{}.record();
  run.settings.support = {{"base", {"bottom", {"x", "y"}}}};
  run.settings.output.support_reactions = true;
  const auto rows = static_cast<std::size_t>(run.history.rows());
  for (const char* name : {"base_Fx_N_m", "base_Fy_N_m"}) {
    run.history.columns.push_back({name, "", "N/m", "", "base"});
    run.history.values.emplace_back(rows, name[6] == 'x' ? -1230. : 45600.);
  }
  const std::string html = support_table({run});
  for (const char* part : {"push", "drag", "base", "kN/m", "-1.23", "45.6"})
    EXPECT_NE(html.find(part), std::string::npos) << "no " << part << " in " << html;
}

}  // namespace
}  // namespace berm::report::this_file
