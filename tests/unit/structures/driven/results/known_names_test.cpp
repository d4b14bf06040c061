// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/results/known_names.hpp"

#include "samples/lived_pipe.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

bool knows(const problem::Case& c, const std::string& name)
{
  const std::vector<std::string> names = structures::structure_of(c).quantity_names(c);
  return std::find(names.begin(), names.end(), without_number(name)) != names.end();
}

TEST(KnownNames, hold_all_that_runs_have)
{
  for (const record::RunRecord& run : {MadeRun{}.record(), lived_pipe()})
    for (const run_folder::Quantity& q : run.quantities) EXPECT_TRUE(knows(run.settings, q.name)) << q.name;
}

TEST(KnownNames, do_not_hold_what_no_run_of_the_case_can_have)
{
  const problem::Case c = MadeRun{}.settings();
  EXPECT_TRUE(knows(c, "V_at_w_0.35D"));
  EXPECT_TRUE(knows(c, "H_over_V_at_u_1.5D"));
  for (const char* name : {"Hmax", "back.H_max", "u_largest", "uplift.R_max"}) EXPECT_FALSE(knows(c, name)) << name;
}

}  // namespace
}  // namespace berm::driven::this_file
