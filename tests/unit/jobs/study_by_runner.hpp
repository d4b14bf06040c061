// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/falling_stone.hpp"
#include "samples/program.hpp"

#include <gtest/gtest.h>

namespace berm::jobs {

/// A study of three falls, done by berm study in a folder of its own.
class StudyByRunner : public testing::Test {
protected:
  using Words = std::vector<std::string>;

  void SetUp() override
  {
    folder_.write("stone.toml", test::falling_stone);
    write_study("-1.6");
  }
  /// The third value of g_y, m/s^2.
  void write_study(const std::string& third) const
  {
    folder_.write("study.toml", R"([[case]]
name = "it's a stone"
file = "stone.toml"
[[axis]]
name = "gravity"
[[axis.value]]
name = "earth"
[[axis.value]]
name = "mars"
set = ["gravity=[0, -3.7]"]
[[axis.value]]
name = "moon"
set = ["gravity=[0, )" + third + R"(]"]
[[measure]]
name = "g"
column = "stone_vy_m_s"
measure = "acceleration"
)");
  }
  berm::Ended study(Words more, const Words& environment = {}) const
  {
    more.insert(more.begin(), {"study", ".", "-o", "results"});
    return run_program(folder_.path(), more, environment);
  }
  /// results.csv of the same study by local processes.
  std::string local_table() const
  {
    EXPECT_EQ(run_program(folder_.path(), {"study", ".", "-o", "local"}).status, 0);
    return text_of_file(folder_ / "local/results.csv");
  }

  TemporaryFolder folder_;
};

}  // namespace berm::jobs
