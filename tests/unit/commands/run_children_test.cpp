// SPDX-License-Identifier: BSD-3-Clause
// The built program stopped while another program works for it.
#include "samples/falling_stone.hpp"
#include "samples/processes.hpp"
#include "samples/small_cases.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

namespace berm::commands::this_file {
namespace {

/// A case whose mesh a gmsh makes that does not end.
class EndlessMesh : public testing::Test {
protected:
  EndlessMesh()
  {
    folder_.write("small.toml", test::small_fem_case);
    write_endless_program(folder_, "gmsh");
    std::filesystem::create_directory(folder_ / "tmp");
  }
  /// Stops berm by a signal once gmsh works; nothing of either is left.
  Ended stopped(const std::vector<std::string>& words, int signal)
  {
    std::filesystem::remove(folder_ / "gmsh.process");
    Program program(folder_.path(), words,
                    {"PATH=" + folder_.path().string() + ":" + std::getenv("PATH"), "TMPDIR=" + (folder_ / "tmp").string()});
    const pid_t gmsh = process_in(folder_ / "gmsh.process");
    EXPECT_TRUE(is_alive(gmsh));
    program.signal(signal);
    const Ended ended = program.wait();
    EXPECT_TRUE(wait_until([&] { return !is_alive(gmsh); }));
    EXPECT_TRUE(wait_until([&] { return std::filesystem::is_empty(folder_ / "tmp"); }));
    return ended;
  }

  TemporaryFolder folder_;
};

TEST_F(EndlessMesh, is_ended_by_the_first_signal_to_a_run)
{
  for (const int signal : {SIGTERM, SIGINT}) {
    const Ended ended = stopped({"run", "small.toml", "-o", "results"}, signal);
    EXPECT_EQ(ended.status, 75);
    EXPECT_EQ(ended.err, "berm: stopped while gmsh was running; the same command starts again\n");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "results/resolved.toml"));
  }
}

TEST_F(EndlessMesh, ends_with_commands_that_a_signal_ends)
{
  for (const char* command : {"check", "draw"}) EXPECT_EQ(stopped({command, "small.toml"}, SIGTERM).status, -1) << command;
}

TEST_F(EndlessMesh, ends_with_a_run_that_is_killed)
{
  stopped({"run", "small.toml", "-o", "results"}, SIGKILL);
}

/// A geometry that starts a program.
constexpr const char* busy_geometry = R"(SystemCall "touch started";
Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Physical Surface("soil") = {1};
)";

TEST(NoPrograms, of_a_case_are_run_where_none_are_allowed)
{
  const TemporaryFolder folder;
  const auto berm = [&](std::vector<std::string> words) { return run_program(folder.path(), words); };
  const auto started = [&] { return std::filesystem::exists(folder / "started"); };
  folder.write("busy.geo", busy_geometry);
  std::string text = test::falling_stone;
  text.replace(text.find("{kind = \"box\", size = [1, 1], cells = [4, 4]}"), 45, "{kind = \"gmsh\", file = \"busy.geo\"}");
  folder.write("case.toml", text);
  for (const std::vector<std::string>& words : {std::vector<std::string>{"check", "case.toml", "--no-sandbox"},
                                                {"draw", "case.toml", "-o", "case.svg", "--no-sandbox"},
                                                {"run", "case.toml", "-o", "results", "--no-sandbox"}}) {
    std::vector<std::string> with = words;
    with.emplace_back("--no-programs");
    const Ended refused = berm(with);
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err, "berm: case.toml:2: mesh.file: names a geometry that gmsh runs, a program, and --no-programs allows none\n");
    EXPECT_FALSE(started()) << words[0];
    EXPECT_EQ(berm(words).status, 0) << words[0];
    EXPECT_TRUE(started()) << words[0];
    std::filesystem::remove(folder / "started");
  }
  std::string of_law = test::falling_stone;
  of_law.replace(of_law.find("law = \"linear_elastic\","), 23, "law = \"user\", library = \"their.so\",");
  folder.write("law.toml", of_law);
  EXPECT_EQ(berm({"check", "law.toml", "--no-programs"}).err,
            "berm: law.toml:3: material.stone.library: names a library with a law, a program, and --no-programs allows none\n");
  for (const char* command : {"check", "draw"}) EXPECT_NE(berm({command, "--help"}).out.find("gmsh runs the geometry"), std::string::npos);
}

TEST(Pictures, are_the_same_for_every_user)
{
  const TemporaryFolder folder;
  folder.write("case.toml", test::small_case);
  folder.write(".gnuplot", "system('touch \"" + (folder / "started").string() + "\"')\nset title 'mine'\n");
  for (const char* name : {"with", "without"}) {
    const Ended ended = run_program(folder.path(), {"run", "case.toml", "-o", name}, {"HOME=" + folder.path().string(), with_pictures()});
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "started"));
    std::filesystem::remove(folder / ".gnuplot");
  }
  EXPECT_TRUE(text_of_file(folder / "with/curves.png") == text_of_file(folder / "without/curves.png"));
}

TEST(Check, of_a_case_whose_first_steps_fail_names_it)
{
  const TemporaryFolder folder;
  folder.write("stone.toml", test::falling_stone);
  const Ended ended = run_program(folder.path(), {"check", "stone.toml", "--set", "gravity=[0, -9e3]"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("berm: stone.toml: its first steps fail: particle "), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace berm::commands::this_file
