// SPDX-License-Identifier: BSD-3-Clause
#include "verify_falls.hpp"

namespace berm::verification::this_file {
namespace {

class VerifyResume : public VerifyFalls {
protected:
  void SetUp() override { example("fall", two_runs + claim("earth", "-10") + claim("light", "-5")); }

  /// Changes the first `from` in a file to `to`.
  void change(const std::string& file, const std::string& from, const std::string& to) const
  {
    std::string text = text_of_file(folder_ / file);
    ASSERT_NE(text.find(from), std::string::npos) << text;
    folder_.write(file, text.replace(text.find(from), from.size(), to));
  }
  static bool says(const Ended& ended, const std::string& words) { return ended.err.find(words) != std::string::npos; }
};

TEST_F(VerifyResume, runs_no_problem_again_whose_result_holds)
{
  ASSERT_EQ(verify({}).status, 0);
  const std::string before = result("fall/light/summary.json");
  const Ended again = verify({});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_TRUE(says(again, "2 of 2 problems have their result already and are not run again\n")) << again.err;
  EXPECT_NE(again.out.find("fall/light  stone_vy_m_s acceleration  -5 m/s^2"), std::string::npos) << again.out;
  EXPECT_EQ(result("fall/light/summary.json"), before);
}

TEST_F(VerifyResume, judges_results_that_hold_by_what_is_expected_now)
{
  ASSERT_EQ(verify({}).status, 0);
  change("examples/fall/expected.toml", "exact = -10", "exact = -10.1");
  const Ended again = verify({});
  EXPECT_TRUE(says(again, "2 of 2 problems have their result already")) << again.err;
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(again.out.find("MISSED"), std::string::npos) << again.out;
}

TEST_F(VerifyResume, runs_again_what_another_engine_computed_and_another_case)
{
  ASSERT_EQ(verify({}).status, 0);
  const auto runs_one = [&](const char* name) {
    const Ended again = verify({});
    EXPECT_TRUE(says(again, "1 of 2 problems have their result already")) << again.err;
    EXPECT_TRUE(says(again, std::string("1/1 ") + name + ": ")) << again.err;
  };
  change("out/verification/fall/earth/summary.json", "engine_build\": \"", "engine_build\": \"dead");
  runs_one("fall/earth");
  change("examples/fall/expected.toml", "gravity=[0, -5]", "gravity=[0, -5.0001]");
  runs_one("fall/light");
  change("examples/fall/case.toml", "0.1 s", "0.11 s");
  EXPECT_FALSE(says(verify({}), "result already"));
  EXPECT_TRUE(says(verify({}), "2 of 2 problems have their result already"));
}

TEST_F(VerifyResume, runs_again_where_the_mesh_file_of_the_case_has_other_bytes)
{
  const std::string mesh =
      "Point(1) = {0, 0, 0, 0.25};\nPoint(2) = {1, 0, 0, 0.25};\nPoint(3) = {1, 1, 0, 0.25};\nPoint(4) = {0, 1, 0, 0.25};\n"
      "Line(1) = {1, 2};\nLine(2) = {2, 3};\nLine(3) = {3, 4};\nLine(4) = {4, 1};\nCurve Loop(1) = {1, 2, 3, 4};\n"
      "Plane Surface(1) = {1};\nPhysical Surface(\"air\") = {1};\n";
  folder_.write("examples/fall/box.geo", mesh);
  change("examples/fall/case.toml", "mesh = {kind = \"box\", size = [1, 1], cells = [4, 4]}",
         "mesh = {kind = \"gmsh\", file = \"box.geo\"}");
  const Ended first = verify({});
  ASSERT_EQ(first.status, 0) << first.out << first.err;
  EXPECT_TRUE(says(verify({}), "2 of 2 problems have their result already"));
  folder_.write("examples/fall/box.geo", mesh + "// changed\n");
  EXPECT_FALSE(says(verify({}), "result already"));
}

TEST_F(VerifyResume, runs_all_anew_where_it_is_told_to)
{
  ASSERT_EQ(verify({}).status, 0);
  folder_.write("out/verification/fall/light/old.txt", "");
  const std::string before = result("fall/light/origin.json");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // origin.json tells seconds
  const Ended anew = verify({"--force"});
  EXPECT_EQ(anew.status, 0) << anew.err;
  EXPECT_TRUE(says(anew, "2 problems to run")) << anew.err;
  EXPECT_NE(result("fall/light/origin.json"), before);
}

TEST_F(VerifyResume, says_which_results_another_build_of_the_program_recorded)
{
  ASSERT_EQ(verify({}).status, 0);
  change("out/verification/fall/earth/summary.json", "program_build\": \"", "program_build\": \"dead");
  const Ended again = verify({});
  EXPECT_TRUE(says(again, "2 of 2 problems have their result already and are not run again; 1 of them by the same engine in another build"))
      << again.err;
}

TEST_F(VerifyResume, runs_no_element_tests_again_whose_result_holds)
{
  example("soil",
          "[run.sheared]\nelement = true\ncase = \"tests.toml\"\n[[expect]]\nrun = \"sheared\"\nquantity = \"ds.s_u\"\nexact = \"8 kPa\"\n"
          "tolerance = 1e-6\nsource = \"s_u\"\nwhy = \"rounding\"\nrequirement = \"r\"\nderived = \"d\"\n");
  folder_.write("examples/soil/tests.toml",
                "[material.clay]\nlaw = \"mohr_coulomb\"\ndensity = 600\nyoung_modulus = 3e6\npoisson_ratio = 0.49\nfriction_angle = "
                "0\ncohesion = 8e3\n[[test]]\nname = \"ds\"\nkind = \"simple_shear\"\nmaterial = \"clay\"\ndrained = "
                "false\nconfining_stress = 5e4\nstrain_path = [0.05]\n");
  ASSERT_EQ(verify({"soil"}).status, 0);
  EXPECT_TRUE(says(verify({"soil"}), "1 of 1 problems have their result already"));
  change("examples/soil/tests.toml", "8e3", "9e3");
  EXPECT_EQ(verify({"soil"}).status, 1);
}

TEST_F(VerifyResume, that_was_killed_loses_no_run_that_had_ended_and_goes_on_with_that_in_hand)
{
  // Without gravity the stone stays where it is, for some hundred thousand steps.
  example("fall", std::string("[run.still]\nset = ['stage.fall.until.time=2000', 'gravity=[0, 0]', 'output.history_time=1']\n") + two_runs +
                      ends("still") + claim("earth", "-10") + claim("light", "-5"));
  {
    Program program(folder_.path(), {"verify", "--threads", "2"});
    ASSERT_TRUE(wait_until([&] {
      return is_there("fall/light/summary.json") && is_there("fall/earth/summary.json") && result("fall/still/history.csv").size() > 2000;
    }));
    program.signal(SIGKILL);
    program.wait();
  }
  // The run is asked to stop as its program ends.
  ASSERT_TRUE(wait_until([&] { return is_there("fall/still/summary.json"); }));
  ASSERT_NE(result("fall/still/summary.json").find("\"finished\": false"), std::string::npos);
  const std::string earth = result("fall/earth/summary.json");
  Ended again;
  EXPECT_TRUE(wait_until([&] {
    again = verify({});
    return !says(again, "another run is writing into it");
  })) << "the runs in hand end within a second or two";
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(result("fall/earth/summary.json"), earth);
  EXPECT_NE(result("fall/still/run.log").find("resumes from the checkpoint"), std::string::npos);
}

}  // namespace
}  // namespace berm::verification::this_file
