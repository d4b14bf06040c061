// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/study_of_falls.hpp"

namespace berm::jobs {

/// A study of three falls, done by a runner.
class StudyByRunner : public test::StudyOfFalls {
protected:
  StudyByRunner() : StudyOfFalls(falls_with("-1.6")) {}
  /// The study with the third value of g_y, m/s^2.
  static std::string falls_with(const std::string& third)
  {
    return R"([[case]]
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
set = ["gravity=[0, )" +
           third + R"(]"]
[[measure]]
name = "g"
column = "stone_vy_m_s"
measure = "acceleration"
)";
  }
  /// results.csv of the same study by local processes.
  std::string local_table() const
  {
    EXPECT_EQ(run_program(folder_.path(), {"study", ".", "-o", "local"}).status, 0);
    return text_of_file(folder_ / "local/results.csv");
  }
};

}  // namespace berm::jobs
