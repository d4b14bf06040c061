// SPDX-License-Identifier: BSD-3-Clause
#include "run/verify.hpp"

#include "core/error.hpp"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

namespace berm {
namespace {

namespace fs = std::filesystem;

/// An example of one block that falls freely for 0.1 s: v_y = -g t.
class Verify : public testing::Test {
protected:
  void SetUp() override
  {
    std::string pattern = (fs::temp_directory_path() / "berm verify XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    fs::create_directories(folder_ / "fall");
    write("case.toml", R"(gravity = [0, "-10 m/s^2"]
mesh = {kind = "box", size = [1, 1], cells = [4, 4]}
material.stone = {law = "linear_elastic", density = 1000, young_modulus = 1e6, poisson_ratio = 0}
body.stone = {material = "stone", block = {center = [0.5, 0.7], size = [0.2, 0.2], spacing = 0.1}}
output.history_time = "1 ms"
[[stage]]
name = "fall"
kind = "free"
until.time = "0.1 s"
)");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / "fall" / name) << text; }
  bool run() const { return verify({(folder_ / "fall").string()}, folder_ / "out", 1); }
  /// A claim that the fall has this acceleration.
  static std::string claim(const std::string& acceleration, const std::string& more = "")
  {
    return "[[expect]]\ncolumn = \"stone_vy_m_s\"\nmeasure = \"acceleration\"\ntolerance = 1e-6\nsource = \"g\"\nwhy = "
           "\"round-off\"\nexact = " +
           acceleration + "\n" + more;
  }

  fs::path folder_;
};

TEST_F(Verify, is_true_where_all_is_met)
{
  write("expected.toml", claim("\"-10 m/s^2\"") + claim("-5", "set = ['gravity=[0, -5]']\n"));
  EXPECT_TRUE(run());
}
TEST_F(Verify, is_false_where_one_is_missed)
{
  write("expected.toml", claim("-10") + claim("-10.01"));
  EXPECT_FALSE(run());
}
TEST_F(Verify, runs_a_case_with_equal_overrides_once)
{
  write("expected.toml", claim("-10") + claim("-10") + claim("-5", "set = ['gravity=[0, -5]']\n"));
  EXPECT_TRUE(run());
  int folders = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_ / "out" / "fall")) ++folders;
  EXPECT_EQ(folders, 2);
}
TEST_F(Verify, refuses_wrong_input_before_anything_runs)
{
  for (const char* more : {"case = \"cave.toml\"\n", "set = [\"gravty=1\"]\n", "most = 1\n"}) {
    write("expected.toml", claim("-10") + claim("-10", more));
    EXPECT_THROW(run(), InputError) << more;
    EXPECT_FALSE(fs::exists(folder_ / "out")) << more;
  }
}

}  // namespace
}  // namespace berm
