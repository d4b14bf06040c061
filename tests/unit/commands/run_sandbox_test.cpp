// SPDX-License-Identifier: BSD-3-Clause
// The built program with cases that bring programs which reach for more than their run folder.
#include "sandbox/sandbox.hpp"

#include "samples/falling_stone.hpp"
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iterator>
#include <thread>

namespace berm::commands::this_file {
namespace {

namespace fs = std::filesystem;

constexpr const char* victim_text = "what was there before\n";

/// A folder with a victim beside the case.
class Sandbox : public testing::Test {
protected:
  Sandbox()
  {
    folder_.write("victim", victim_text);
    fs::create_directory(folder_ / "tmp");
  }
  void SetUp() override
  {
    if (const std::string why = sandbox::why_there_is_none(); !why.empty()) GTEST_SKIP() << why;
  }
  Ended berm(const std::vector<std::string>& words, std::vector<std::string> environment = {}) const
  {
    environment.push_back("TMPDIR=" + (folder_ / "tmp").string());
    return run_program(folder_.path(), words, environment);
  }
  /// Nothing outside of the run folder is another, and temporary folders go.
  void expect_nothing_changed(const std::string& what) const
  {
    EXPECT_EQ(text_of_file(folder_ / "victim"), victim_text) << what;
    EXPECT_EQ(fs::status(folder_ / "victim").permissions() & fs::perms::owner_write, fs::perms::owner_write) << what;
    EXPECT_FALSE(fs::exists(folder_ / "made")) << what;
    EXPECT_TRUE(wait_until([&] { return fs::is_empty(folder_ / "tmp"); })) << what;
  }

  TemporaryFolder folder_;
};

class SandboxOfLaw : public Sandbox {
protected:
  SandboxOfLaw()
  {
    std::string text = test::falling_stone;
    const std::string old = "law = \"linear_elastic\"";
    text.replace(text.find(old), old.size(), "law = \"user\", library = \"their.so\"");
    folder_.write("case.toml", text);
    fs::copy_file(BERM_REACHING_LAW, folder_ / "their.so");
  }
  Ended run(int act, std::vector<std::string> more = {}) const
  {
    more.insert(more.begin(), {"run", "case.toml", "-o", "results", "--threads", "1", "--force", "--set",
                               fmt::format("material.stone.properties=[1e6, 0, {}]", act)});
    return berm(more);
  }
};

TEST_F(SandboxOfLaw, names_what_a_law_was_kept_from_and_ends_the_run)
{
  const fs::path real = fs::canonical(folder_.path());
  const std::string writes = "written to " + (real / "victim").string(), makes = "written to " + (real / "made").string();
  const std::pair<int, std::string> acts[] = {{1, writes},
                                              {2, "opened a socket of the network"},
                                              {3, "opened a socket to other programs"},
                                              {4, "started the program /bin/sh"},
                                              {5, writes},
                                              {6, writes},
                                              {7, writes},
                                              {8, writes},
                                              {9, makes},
                                              {10, makes},
                                              {11, writes},
                                              {12, "started the program /usr/bin/touch"},
                                              {13, writes},
                                              {14, writes},
                                              {15, "changed /dev/fd/"},
                                              {16, "changed /proc/"},
                                              {17, "changed /proc/"},
                                              {18, makes},
                                              {27, "written to "},
                                              {22, "written to /dev/shm/berm_reaching_law"}};
  for (const auto& [act, words] : acts) {
    const Ended ended = run(act);
    EXPECT_EQ(ended.status, 1) << act;
    EXPECT_NE(ended.err.find("berm: stopped by the sandbox: a library of the case would have " + words), std::string::npos)
        << act << ": " << ended.err;
    EXPECT_TRUE(ended.err.ends_with("; --no-sandbox lets a case that you trust do so\n")) << ended.err;
    EXPECT_NE(text_of_file(folder_ / "results/run.log").find("stopped by the sandbox"), std::string::npos) << act;
    EXPECT_NE(text_of_file(folder_ / "results/summary.json").find("\"finished\": false"), std::string::npos) << act;
    expect_nothing_changed(std::to_string(act));
  }
}

TEST_F(SandboxOfLaw, is_not_there_where_the_user_says_so)
{
  const Ended ended = run(5, {"--no-sandbox"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_FALSE(fs::exists(folder_ / "victim"));
  const std::vector<std::string> words = {"run", "case.toml", "-o", "results", "--force", "--set", "material.stone.properties=[1e6, 0, 9]"};
  EXPECT_EQ(berm(words, {"BERM_NO_SANDBOX=1"}).status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "made"));
}

TEST_F(SandboxOfLaw, holds_for_element_tests)
{
  folder_.write("element.toml", R"(materials_from = "case.toml"
[[test]]
name = "one"
kind = "oedometer"
material = "stone"
confining_stress = "6 kPa"
strain_path = [0.05]
)");
  const Ended ended = berm({"element", "element.toml", "-o", "results", "--set", "material.stone.properties=[1e6, 0, 5]"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("stopped by the sandbox: a library of the case would have written to "), std::string::npos) << ended.err;
  expect_nothing_changed("element");
}

TEST_F(SandboxOfLaw, has_no_other_way_out_and_a_temporary_folder)
{
  for (const int act : {19, 21, 26, 28}) {
    const Ended ended = run(act);
    EXPECT_EQ(ended.status, 0) << act << ": " << ended.err;
    expect_nothing_changed(std::to_string(act));
  }
}

TEST_F(SandboxOfLaw, ends_what_a_law_leaves_behind)
{
  for (const int act : {23, 24}) {
    run(act);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_FALSE(fs::exists(folder_ / "results/late")) << act;
  }
}

TEST_F(SandboxOfLaw, starts_no_shell_by_the_loader)
{
  run(25);
  EXPECT_FALSE(fs::exists(folder_ / "results/by_a_shell"));
}

TEST_F(SandboxOfLaw, of_several_cases_has_a_folder_for_each)
{
  fs::copy_file(folder_ / "case.toml", folder_ / "other.toml");
  const Ended ended = berm({"run", "case.toml", "other.toml", "-o", ".", "--set", "material.stone.properties=[1e6, 0, 1]"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("stopped by the sandbox: a library of the case would have written to "), std::string::npos) << ended.err;
  expect_nothing_changed("several");
}

TEST_F(SandboxOfLaw, is_not_entered_for_a_folder_of_other_files)
{
  const Ended ended = berm({"run", "case.toml", "-o", ".", "--set", "material.stone.properties=[1e6, 0, 1]"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("cannot use . as the run folder: it holds files that are not of a run"), std::string::npos) << ended.err;
  expect_nothing_changed("other files");
}

TEST_F(SandboxOfLaw, is_not_given_up_for_what_lies_where_the_run_folder_would)
{
  const std::vector<std::string> words = {"run", "case.toml", "--set", "material.stone.properties=[1e6, 0, 5]"};
  folder_.write("out", "a file");
  const Ended file = berm(words);
  EXPECT_EQ(file.status, 1);
  EXPECT_NE(file.err.find("cannot make the folder"), std::string::npos) << file.err;
  EXPECT_EQ(file.err.find("no sandbox here"), std::string::npos) << file.err;
  fs::remove(folder_ / "out");
  fs::create_directory(folder_ / "elsewhere");
  fs::create_symlink("elsewhere", folder_ / "out");
  const Ended link = berm(words);
  EXPECT_EQ(link.status, 2);
  EXPECT_NE(link.err.find("out is a link, and the case brings a library"), std::string::npos) << link.err;
  EXPECT_TRUE(fs::is_empty(folder_ / "elsewhere"));
  expect_nothing_changed("planted");
}

TEST_F(SandboxOfLaw, holds_for_the_second_of_two_cases_that_are_checked)
{
  folder_.write("plain.toml", test::falling_stone);
  std::string text = text_of_file(folder_ / "case.toml");
  const std::string library = "library = \"their.so\"";
  folder_.write("case.toml", text.replace(text.find(library), library.size(), library + ", properties = [1e6, 0, 0]"));
  const Ended both = berm({"check", "--json", "plain.toml", "case.toml"});
  EXPECT_EQ(both.status, 0) << both.out;
  EXPECT_EQ(both.err, "");
}

TEST_F(SandboxOfLaw, is_not_put_off_by_what_stands_in_the_environment)
{
  const std::vector<std::string> words = {"run", "case.toml", "-o", "results", "--force", "--set", "material.stone.properties=[1e6, 0, 5]"};
  for (const std::string& variable : {"BERM_SCRATCH=" + (folder_ / "tmp").string(), std::string("BERM_NO_SANDBOX=0")}) {
    EXPECT_EQ(berm(words, {variable}).status, 1) << variable;
    expect_nothing_changed(variable);
  }
}

TEST_F(SandboxOfLaw, leaves_results_as_they_are)
{
  ASSERT_EQ(run(0).status, 0);
  const std::string history = text_of_file(folder_ / "results/history.csv");
  ASSERT_EQ(run(0, {"--no-sandbox"}).status, 0);
  EXPECT_EQ(text_of_file(folder_ / "results/history.csv"), history);
  expect_nothing_changed("done");
}

TEST_F(SandboxOfLaw, is_no_part_of_a_law_that_ends_the_program)
{
  for (const char* option : {"--sandbox", "--no-sandbox"}) {
    const Ended ended = run(20, {option});
    EXPECT_EQ(ended.status, 1) << option;
    EXPECT_NE(ended.err.find("ended the program (_exit); the files in the run folder are complete"), std::string::npos) << ended.err;
  }
}

/// A geometry of one square, after or before which gmsh is told to do something else.
constexpr const char* square = R"(Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Physical Surface("soil") = {1};
)";

TEST_F(Sandbox, names_what_a_geometry_was_kept_from)
{
  std::string text = test::falling_stone;
  const std::string box = "{kind = \"box\", size = [1, 1], cells = [4, 4]}";
  text.replace(text.find(box), box.size(), "{kind = \"gmsh\", file = \"square.geo\"}");
  folder_.write("case.toml", text);
  folder_.write("square.geo", square);
  EXPECT_EQ(berm({"check", "case.toml"}).status, 0);
  const Ended homeless = berm({"check", "case.toml"}, {"HOME=" + (folder_ / "tmp").string()});
  EXPECT_EQ(homeless.status, 0) << "gmsh may keep no settings there, which is no fault of the geometry: " << homeless.err;
  const std::string victim = (fs::canonical(folder_.path()) / "victim").string();
  const std::pair<std::string, std::string> acts[] = {{"SystemCall \"rm victim\";", "started the program /bin/sh"},
                                                      {fmt::format("Printf(\"here\") > \"{}\";", victim), "written to " + victim},
                                                      {fmt::format("Save \"{}\";", victim + ".msh"), "written to " + victim + ".msh"}};
  for (const auto& [line, words] : acts) {
    folder_.write("square.geo", square + line + "\n");
    for (const std::vector<std::string>& command : {std::vector<std::string>{"check", "case.toml"},
                                                    {"draw", "case.toml", "-o", "drawn/case.svg"},
                                                    {"draw", "case.toml", "-o", "-"},
                                                    {"draw", "case.toml", "-o", "case.svg"},
                                                    {"run", "case.toml", "-o", "out/results"}}) {
      const Ended ended = berm(command);
      EXPECT_EQ(ended.status, 1) << command[0];
      EXPECT_NE(ended.err.find("stopped by the sandbox: the geometry of the case would have " + words + "; "), std::string::npos)
          << command[0] << ": " << ended.err;
      expect_nothing_changed(line);
      EXPECT_FALSE(fs::exists(folder_ / "out")) << "a run that has not begun leaves no folder";
    }
  }
}

TEST_F(Sandbox, holds_where_a_command_asks_a_case_before_its_runs_begin)
{
  std::string text = test::falling_stone;
  const std::string box = "{kind = \"box\", size = [1, 1], cells = [4, 4]}", law = "law = \"linear_elastic\"";
  text.replace(text.find(box), box.size(), "{kind = \"gmsh\", file = \"square.geo\"}");
  text.replace(text.find(law), law.size(), "law = \"mohr_coulomb\", cohesion = 1e3, friction_angle = 0");
  fs::create_directory(folder_ / "theirs");
  folder_.write("theirs/case.toml", text);
  folder_.write("theirs/square.geo", square + std::string("SystemCall \"touch made\";\n"));
  folder_.write("theirs/expected.toml",
                "chapter = \"other\"\nrequirement = \"It falls.\"\nderived = \"here\"\n[run.falls]\ntitle = \"It falls\"\n"
                "[[expect]]\nrun = \"falls\"\ncolumn = \"stone_uy_m\"\nmost = 0\nsource = \"it falls\"\nwhy = \"it falls\"\n");
  const std::string why = "stopped by the sandbox: the geometry of the case would have started the program /bin/sh; --no-sandbox";
  const Ended safety = berm({"safety", "theirs/case.toml", "-o", "found"});
  EXPECT_EQ(safety.status, 1);
  EXPECT_NE(safety.err.find(why), std::string::npos) << safety.err;
  const Ended verify = berm({"verify", "theirs", "-o", "book"});
  EXPECT_EQ(verify.status, 1) << verify.err;
  EXPECT_NE((verify.out + verify.err).find(why), std::string::npos) << verify.out << verify.err;
  expect_nothing_changed("asked before");
}

TEST_F(Sandbox, of_a_case_without_programs_changes_nothing)
{
  folder_.write("case.toml", test::small_case);
  folder_.write("fem.toml", test::small_fem_case);
  for (const char* name : {"case.toml", "fem.toml"}) {
    ASSERT_EQ(berm({"run", name, "-o", "without", "--force", "--threads", "1"}, {with_pictures()}).status, 0);
    const Ended ended = berm({"run", name, "-o", "with", "--force", "--threads", "1", "--sandbox"}, {with_pictures()});
    ASSERT_EQ(ended.status, 0) << ended.err;
    for (const char* file : {"history.csv", "curves.png"})
      EXPECT_TRUE(text_of_file(folder_ / "with" / file) == text_of_file(folder_ / "without" / file)) << name << " " << file;
  }
  folder_.write("fem_2.toml", test::small_fem_case);
  const Ended both = berm({"run", "fem.toml", "fem_2.toml", "case.toml", "-o", "both", "--threads", "2", "--sandbox"});  // two side by side
  EXPECT_EQ(both.status, 0) << both.err;
  expect_nothing_changed("done");
}

TEST(TemporaryFolders, that_cannot_be_made_are_told_by_the_variable_that_names_them)
{
  const TemporaryFolder folder;
  folder.write("case.toml", test::falling_stone);
  const Ended ended = run_program(folder.path(), {"check", "case.toml"}, {"TMPDIR=/not/there"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_EQ(ended.err, "berm: TMPDIR names /not/there for temporary files, which is not a folder: No such file or directory\n");
}

}  // namespace
}  // namespace berm::commands::this_file
