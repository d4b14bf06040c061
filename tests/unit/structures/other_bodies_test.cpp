// SPDX-License-Identifier: BSD-3-Clause
#include "structures/other_bodies.hpp"

#include "samples/made_run.hpp"
#include "structures/driven/known_names.hpp"

#include <gtest/gtest.h>

namespace berm::structures::this_file {
namespace {

/// A run of a pipe, behind whose drag a stage presses "old", a pipe of the same size, twice as hard.
record::RunRecord run_of_two()
{
  record::RunRecord run = MadeRun{}.record();
  settings::Case& c = run.settings;
  c.rigid.emplace_back("old", c.rigid[0].second);
  c.contact.emplace_back("old_skin", c.contact[0].second).second.rigid = "old";
  c.stage.push_back(MadeRun::stage_of("press", settings::StageKind::push));
  c.stage.back().rigid = "old";
  run_folder::History& h = run.history;
  for (run_folder::Column& column : h.columns)
    if (column.name != "time_s") column.of = "pipe";
  for (run_folder::Column& column : columns_named({"old_u_m", "old_w_m", "old_H_N_m", "old_V_N_m"})) {
    column.of = "old";
    h.columns.push_back(column), h.values.emplace_back(h.rows(), 0.);
  }
  for (int k = 1; k <= 50; ++k) {
    const Real w = k * 4e-5, row[] = {static_cast<Real>(h.rows()), h.values[1].back(), h.values[2].back(), 0, 800, 0, w, 0, 8e5 * w};
    for (std::size_t column = 0; column < h.columns.size(); ++column) h.values[column].push_back(row[column]);
    h.stage.emplace_back("press");
  }
  run.quantities = quantities_of(run, {});
  return run;
}

TEST(OtherBodies, have_the_key_results_of_the_stages_that_drive_them)
{
  const record::RunRecord run = run_of_two();
  ASSERT_NE(run.quantity("old.V_at_w_0.05D"), nullptr);
  EXPECT_NEAR(run.quantity("old.V_at_w_0.05D")->value, 800, 1);
  EXPECT_NEAR(run.quantity("old.w_end_of_push")->value, 0.002, 1e-9);
  EXPECT_EQ(run.quantity("old.H_at_u_0.1D"), nullptr) << "nothing drags it";
}

TEST(OtherBodies, leave_the_results_of_the_main_body_as_they_are)
{
  const record::RunRecord run = run_of_two(), alone = MadeRun{}.record();
  for (const run_folder::Quantity& q : alone.quantities) {
    ASSERT_NE(run.quantity(q.name), nullptr) << q.name;
    EXPECT_EQ(run.quantity(q.name)->value, q.value) << q.name;
  }
  for (const run_folder::Quantity& q : run.quantities) EXPECT_FALSE(q.name.starts_with("press.")) << q.name << " is of a body at rest";
  EXPECT_TRUE(other_driven_bodies(alone.settings).empty());
}

TEST(OtherBodies, have_names_that_are_known_before_the_run)
{
  const record::RunRecord run = run_of_two();
  const std::vector<std::string> names = quantity_names_of(run.settings);
  for (const char* name : {"V_at_w_0.05D", "old.V_at_w_0.05D", "old.V_end_of_push"})
    EXPECT_NE(std::ranges::find(names, driven::without_number(name)), names.end()) << name;
}

}  // namespace
}  // namespace berm::structures::this_file
