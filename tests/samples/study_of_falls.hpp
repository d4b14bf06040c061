// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/falling_stone.hpp"
#include "samples/program.hpp"

#include <gtest/gtest.h>

namespace berm::test {

/// Runs berm study in a folder that holds stone.toml, a stone that falls, and a study.toml.
class StudyOfFalls : public testing::Test {
protected:
  using Words = std::vector<std::string>;

  explicit StudyOfFalls(const std::string& study)
  {
    folder_.write("stone.toml", falling_stone);
    write_study(study);
  }
  void write_study(const std::string& study) const { folder_.write("study.toml", study); }
  /// The results go to the folder "results".
  Ended study(const Words& more = {}, const Words& environment = {}) const
  {
    Words words = {"study", ".", "-o", "results"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(folder_.path(), words, environment);
  }
  std::string result(const std::string& name) const { return text_of_file(folder_ / ("results/" + name)); }

  TemporaryFolder folder_;
};

}  // namespace berm::test
