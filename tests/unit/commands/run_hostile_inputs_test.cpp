// SPDX-License-Identifier: BSD-3-Clause
// The program under attack: texts that no hand writes, names that would leave the run folder or reach a shell, sizes that no machine holds.
#include "samples/falling_stone.hpp"
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace berm::commands::this_file {
namespace {

using Words = std::vector<std::string>;

std::string repeated(const std::string& text, int times)
{
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

std::string small_case_with(const std::string& from, const std::string& to)
{
  std::string text = test::small_case;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// A folder work/ beside which nothing must appear, with a case in it.
class Hostile : public testing::Test {
protected:
  Hostile() { std::filesystem::create_directory(place_ / "work"); }

  void write(const std::string& name, const std::string& text) const { place_.write("work/" + name, text); }
  Ended berm(const Words& arguments, const Words& environment = {}) const { return run_program(place_ / "work", arguments, environment); }

  /// Status 2 (1: the machine is too small), one line of words that a terminal can show, and nothing written.
  void expect_refused(const std::string& text, const std::string& says, const char* command = "check", int status = 2) const
  {
    write("case.toml", text);
    const Ended ended = berm({command, "case.toml"});
    EXPECT_EQ(ended.status, status) << says << ": " << ended.err.substr(0, 1000);
    EXPECT_EQ(ended.err.find("berm: "), 0u) << ended.err.substr(0, 1000);
    EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << ended.err.substr(0, 1000);
    EXPECT_EQ(ended.err.find('\x1b'), std::string::npos) << ended.err.substr(0, 1000);
    EXPECT_LT(ended.err.size(), 4000u) << says;
    EXPECT_NE(ended.err.find(says), std::string::npos) << "no `" << says << "` in: " << ended.err.substr(0, 1000);
    expect_nothing_else({"case.toml"});
  }
  void expect_nothing_else(const Words& in_work) const
  {
    EXPECT_EQ(names_in(place_ / "work"), in_work);
    EXPECT_EQ(names_in(place_.path()), (Words{"work/"}));
  }

  TemporaryFolder place_;
};

TEST_F(Hostile, texts_that_are_no_toml_end_in_one_line)
{
  const std::string bad[] = {"[&",
                             "[[&]]",
                             "a = {&",
                             "a\xC3\xA9",
                             "a = \xC3\xA9",
                             std::string("a = 1\0", 6),
                             "\xFF\xFE\x00",
                             "a = \"\\uD800\"",
                             "a = 1e999999999999999999999",
                             "a = 0x10000000000000000",
                             "a = " + repeated("[", 900'000),
                             "a = " + repeated("[", 400'000) + repeated("]", 400'000),
                             "a = " + repeated("{a=", 300'000),
                             repeated("a.", 400'000) + "a = 1",
                             "[" + repeated("a.", 400'000) + "a]",
                             "t = {k = \"\"\"\n\"\"\", " + repeated("a.", 400'000) + "a = \"1\"}",
                             repeated("[a]\n", 200'000),
                             repeated("=", 900'000),
                             repeated("[[a]]\n", 2'000'000)};
  for (const std::string& text : bad) expect_refused(text, "case.toml");
}

TEST_F(Hostile, numbers_that_are_none_or_beyond_all_bounds_are_refused)
{
  const std::pair<const char*, const char*> bad[] = {
      {"1e999", "case.toml:4: not valid TOML"},        {"-1e999", "case.toml:4: not valid TOML"},
      {"nan", "surface: must be a finite number"},     {"-inf", "surface: must be a finite number"},
      {"9223372036854775808", "case.toml:4"},          {"99999999999999999999999999", "case.toml:4"},
      {"\"1e999 m\"", "is not a finite number"},       {"\"nan m\"", "is not a finite number"},
      {"\"1 m^2147483647 m^-2147483646\"", "surface"}, {"\"1 m^99999999999999999999\"", "surface"}};
  for (const auto& [number, says] : bad) expect_refused(small_case_with("\"40 mm\"", number), says);
  expect_refused(small_case_with("\"40 mm\"", "\"1 " + repeated("(", 300'000) + "m\""), "surface");
  expect_refused(small_case_with("\"40 mm\"", "\"1 " + repeated("m s^-1 ", 100'000) + "\""), "surface");
}

TEST_F(Hostile, sizes_that_no_machine_holds_are_refused_at_once)
{
  expect_refused(small_case_with("\"1.3333333 mm\"", "1e-12"), "of memory at least");
  expect_refused(small_case_with("\"1.3333333 mm\"", "1e-300"), "of memory at least");
  expect_refused(small_case_with("[30, 15]", "[1e9, 15]"), "mesh.cells");
  expect_refused(small_case_with("[30, 15]", "[1000000, 1000000]"), "mesh.cells: makes 1e+12 cells for ");
  expect_refused("method = \"fem\"\n" + small_case_with("[30, 15]", "[1000000, 1000000]"), "elements need");
  expect_refused(small_case_with("[\"120 mm\", \"60 mm\"]", "[1e-200, 1e-200]"), "mesh.size");
  expect_refused(small_case_with("\"0.05 ms\"", "1e-30"), "output.history_time");
  expect_refused(small_case_with("frame_travel = \"1 mm\"", "frame_time = 1e-30"), "output.frame_time");
  expect_refused(small_case_with("\"1 mm\"", "1e-30"), "output.frame_travel");
  expect_refused(test::small_case + "[mpm]\ncourant = 1e-300\n", "mpm.courant");
  const std::string comb = fmt::format("[rigid.comb]\nshape = \"polygon\"\nx = [{0}]\ny = [{0}]\n", repeated("0, 1, ", 25'000));
  expect_refused(test::small_case + comb, "1000 corners at most");
  const std::string bed = "kind = \"seabed\"\nlength = 1\ndepth = 1\nheadroom = 1\nnear_left = -0.1\nnear_right = 0.1\nnear_depth = 0.1\n"
                          "near_height = 0.1\nnear_size = 1e-12\n";
  expect_refused(small_case_with("kind = \"box\"\nsize = [\"120 mm\", \"60 mm\"]\ncells = [30, 15]\n", bed), "of memory at least");
}

/// The number of cells is told before gmsh works on them for hours.
TEST_F(Hostile, elements_too_small_for_any_machine_are_refused_at_once)
{
  const std::string bed =
      "kind = \"seabed\"\nlength = 1\ndepth = 0.5\nheadroom = 0.1\nnear_left = -0.1\nnear_right = 0.1\nnear_depth = 0.1\n"
      "near_height = 0.05\nnear_size = 0.01\n";
  const auto with = [&](const std::string& growth, const std::string& contact_size) {
    std::string text = small_case_with("kind = \"box\"\nsize = [\"120 mm\", \"60 mm\"]\ncells = [30, 15]\n", bed + growth);
    const std::size_t at = text.find("[\"50 mm\", \"50 mm\"]");
    text.replace(at, std::string("[\"50 mm\", \"50 mm\"]").size(), "[0, 0.005]");
    return "method = \"fem\"\nfem.contact_size = " + contact_size + "\n" + text;
  };
  for (const char* size : {"1e-9", "1e-12", "1e-300"})
    expect_refused(with("", size), "case.toml:2: fem.contact_size: makes more than 2e+07 cells around [rigid.pipe]");
  expect_refused(with("growth = 0", "\"0.05 mm\""), "makes more than 2e+07 cells around [rigid.pipe]");
}

TEST_F(Hostile, names_that_would_become_paths_are_refused)
{
  for (const std::string& name : {std::string("../../x"), std::string("/tmp/x"), std::string("a/b"), std::string(".."), std::string("a b"),
                                  std::string("$(touch x)"), std::string("; touch x"), std::string("`touch x`"), std::string("a\\u0000b"),
                                  std::string("a\\nb"), std::string("\\u001b[2J"), std::string(101, 'a'), std::string(300'000, 'a')}) {
    expect_refused(small_case_with("[rigid.pipe]", "[rigid.\"" + name + "\"]"), "is not a valid name");
    expect_refused(test::small_case + ("[watch.\"" + name + "\"]\nbody = \"sand\"\npoint = [0, 0]\n"), "is not a valid name");
  }
  expect_refused(small_case_with("name = \"rest\"", "name = \"a\\u0007\\u001b]0;x\\u0007\""), "control character");
  expect_refused(small_case_with("name = \"rest\"", "name = \"" + std::string(101, 'a') + "\""), "100 bytes at most");
  expect_refused(small_case_with("name = \"rest\"", "name = \"" + std::string(300'000, 'a') + "\""), "is longer than 4096 bytes");
  expect_refused(small_case_with("a pipe on sand", "a\\npipe"), "title");
}

TEST_F(Hostile, mesh_files_that_are_none_are_refused)
{
  for (const char* file : {"../../../../../../../etc/passwd", "/etc/passwd", "/dev/zero", "/dev/stdin", "/proc/self/mem", "/", ".", "..",
                           "none.msh", "none.geo", "$(touch x).geo", "; touch x.geo", "-o.geo", "a\\u0000.geo"})
    expect_refused(small_case_with("kind = \"box\"\nsize = [\"120 mm\", \"60 mm\"]\ncells = [30, 15]\n",
                                   "kind = \"gmsh\"\nfile = \"" + std::string(file) + "\"\n"),
                   "");
}

/// Whatever words a case holds, they stay words: in the scripts of plots, on the command lines of gmsh and gnuplot, in the log.
TEST_F(Hostile, words_reach_no_shell_and_no_other_folder)
{
  const std::string words = R"(`touch x` $(touch x) '; system('touch x') # \" ; touch x | touch x && touch x ../../x)";
  std::string text = small_case_with("a pipe on sand, small and coarse", words);
  const auto replace_all = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) text.replace(at, from.size(), to);
  };
  replace_all("name = \"rest\"", "name = \"`touch x`$(touch x); touch x | ' /x\"");
  replace_all("[rigid.pipe]", "[rigid.-e]");
  replace_all("rigid = \"pipe\"", "rigid = \"-e\"");
  text += "[watch.-persist]\nbody = \"sand\"\npoint = [0, 0]\n";
  write("-o $(touch x).toml", text);
  const Ended ended = berm({"run", "./-o $(touch x).toml", "-o", "results", "--threads", "1"}, {with_pictures()});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(std::filesystem::exists(place_ / "work/results/soil.png")) << ended.err;
  EXPECT_TRUE(std::filesystem::exists(place_ / "work/results/curves.png")) << ended.err;
  expect_nothing_else({"-o $(touch x).toml", "results/"});
  for (const auto& entry : std::filesystem::recursive_directory_iterator(place_ / "work/results"))
    EXPECT_NE(entry.path().filename(), "x") << entry.path();
  EXPECT_EQ(berm({"report", "results", "--figures"}, {with_pictures()}).status, 0);
  expect_nothing_else({"-o $(touch x).toml", "results/"});
}

TEST_F(Hostile, gmsh_gets_the_path_of_a_geometry_and_no_shell)
{
  constexpr const char* geometry =
      "Point(1) = {0, 0, 0, 0.01}; Point(2) = {0.12, 0, 0, 0.01}; Point(3) = {0.12, 0.06, 0, 0.01};\n"
      "Point(4) = {0, 0.06, 0, 0.01}; Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};\n"
      "Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1}; Physical Surface(\"box\") = {1};\n"
      "Physical Curve(\"bottom\") = {1}; Physical Curve(\"right\") = {2}; Physical Curve(\"left\") = {4};\n";
  for (const std::string name : {"$(touch x).geo", "; touch x; .geo", "`touch x`.geo", "-o x -.geo"}) {
    write(name, geometry);
    write("case.toml", small_case_with("kind = \"box\"\nsize = [\"120 mm\", \"60 mm\"]\ncells = [30, 15]\n",
                                       "kind = \"gmsh\"\nfile = \"" + name + "\"\n"));
    const Ended ended = berm({"check", "case.toml", "--threads", "1"});
    EXPECT_EQ(ended.status, 0) << name << ": " << ended.err;
    Words expected = {name, "case.toml"};
    std::sort(expected.begin(), expected.end());
    expect_nothing_else(expected);
    std::filesystem::remove(place_ / ("work/" + name));
  }
}

TEST_F(Hostile, a_study_stays_in_its_folder_whatever_its_names_are)
{
  write("stone.toml", test::falling_stone);
  write("study.toml", R"(
case = [{name = "..", file = "stone.toml"}, {name = "../../x", file = "stone.toml", set = ["title=`touch x`"]}, {name = "/", file = "stone.toml"}]
measure = [{name = "`touch x`", column = "stone_vy_m_s", unit = "'; system('touch x') #"}]
figure = [{name = "..", x = "time_s", y = "stone_vy_m_s"}, {name = "-persist", x = "time_s", y = "stone_vy_m_s"}, {name = "../x", x = "time_s", y = "stone_vy_m_s"}]
)");
  const Ended ended = berm({"study", "study.toml", "-o", "results", "--threads", "1"}, {with_pictures()});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(names_in(place_ / "work/results/runs"), (Words{".._.._x/", "_../", "_/"}));
  EXPECT_EQ(names_in(place_ / "work/results"),
            (Words{"-persist.png", ".._x.png", "_...png", "plots/", "results.csv", "results.md", "runs/", "study.json"}));
  expect_nothing_else({"results/", "stone.toml", "study.toml"});
}

}  // namespace
}  // namespace berm::commands::this_file
