// SPDX-License-Identifier: BSD-3-Clause
#include "samples/program.hpp"

#include <gtest/gtest.h>

namespace berm::commands::this_file {
namespace {

constexpr const char* input = R"([material.sand]
law = "mohr_coulomb"
density = 1000
young_modulus = 30e6
poisson_ratio = 0.3
friction_angle = "30 deg"

[[test]]
name = "cd_100"
kind = "triaxial"
material = "sand"
drained = true
confining_stress = "100 kPa"
strain_path = [0.05]
)";

TEST(Element, prints_a_table_and_leaves_its_folder)
{
  TemporaryFolder folder;
  folder.write("sand.toml", input);
  const Ended ended = run_program(folder.path(), {"element", "sand.toml", "--set", "test.cd_100.confining_stress=50 kPa"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  for (const char* part : {"triaxial, drained", "cd_100", "q, peak (kPa)", "100.0"})
    EXPECT_NE(ended.out.find(part), std::string::npos) << part << " in:\n" << ended.out;
  EXPECT_NE(ended.err.find("out/sand/element.html"), std::string::npos) << ended.err;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/sand/cd_100/element.csv"));
}

TEST(Element, replaces_results_where_it_is_told_to)
{
  TemporaryFolder folder;
  folder.write("sand.toml", input);
  EXPECT_EQ(run_program(folder.path(), {"element", "sand.toml", "-o", "here"}).status, 0);
  const Ended again = run_program(folder.path(), {"element", "sand.toml", "-o", "here"});
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find("--force"), std::string::npos) << again.err;
  EXPECT_EQ(run_program(folder.path(), {"element", "sand.toml", "-o", "here", "--force"}).status, 0);
}

TEST(Element, refuses_two_inputs_for_one_folder)
{
  TemporaryFolder folder;
  folder.write("sand.toml", input);
  const Ended ended = run_program(folder.path(), {"element", "sand.toml", "./sand.toml"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("would both be written to"), std::string::npos) << ended.err;
}

TEST(Element, is_named_where_its_input_is_taken_for_a_case)
{
  TemporaryFolder folder;
  folder.write("sand.toml", input);
  for (const char* command : {"run", "check"}) {
    const Ended ended = run_program(folder.path(), {command, "sand.toml"});
    EXPECT_EQ(ended.status, 2);
    EXPECT_NE(ended.err.find("berm: sand.toml:8: test: "), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("berm element"), std::string::npos) << ended.err;
  }
}

}  // namespace
}  // namespace berm::commands::this_file
