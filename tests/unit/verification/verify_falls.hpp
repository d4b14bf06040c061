// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/falling_stone.hpp"
#include "samples/program.hpp"

#include <gtest/gtest.h>

namespace berm::verification {

/// Runs berm verify on examples of a stone that falls.
class VerifyFalls : public testing::Test {
protected:
  using Words = std::vector<std::string>;

  static constexpr const char* two_runs = "[run.earth]\nfast = true\ntitle = \"on earth\"\n[run.light]\nset = ['gravity=[0, -5]']\n";

  /// A claim that a run's stone has this acceleration.
  static std::string claim(const std::string& run, const std::string& acceleration, const std::string& more = "")
  {
    return "[[expect]]\nrun = \"" + run + "\"\ncolumn = \"stone_vy_m_s\"\nmeasure = \"acceleration\"\ntolerance = 1e-6\nsource = " +
           "\"g\"\nwhy = \"round-off\"\nrequirement = \"r\"\nderived = \"d\"\nexact = " + acceleration + "\n" + more;
  }
  /// A claim that a run comes to its end.
  static std::string ends(const std::string& run)
  {
    return "[[expect]]\nrun = \"" + run +
           "\"\nquantity = \"finished\"\nleast = 1\nsource = \"s\"\nwhy = \"w\"\nrequirement = \"r\"\nderived = \"d\"\n";
  }
  void example(const std::string& name, const std::string& expected) const
  {
    std::filesystem::create_directories(folder_ / ("examples/" + name));
    folder_.write("examples/" + name + "/case.toml", test::falling_stone);
    folder_.write("examples/" + name + "/README.md", "# A stone that falls\n\nIt obeys $v = -g t$.\n");
    folder_.write("examples/" + name + "/expected.toml", expected);
  }
  Ended verify(Words words, const Words& environment = {}) const
  {
    words.insert(words.begin(), "verify");
    return run_program(folder_.path(), words, environment);
  }
  std::vector<std::string> made() const { return names_in(folder_ / "out/verification/fall"); }
  bool is_there(const std::string& name) const { return std::filesystem::exists(folder_ / ("out/verification/" + name)); }
  std::string result(const std::string& name) const { return text_of_file(folder_ / ("out/verification/" + name)); }

  TemporaryFolder folder_;
};

}  // namespace berm::verification
