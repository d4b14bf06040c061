// SPDX-License-Identifier: BSD-3-Clause
// A cable on a slope that a user drew in Gmsh, and one that berm makes: embedment counts from the slope, the first stage ends at equilibrium.
#include "samples/program.hpp"

#include "run_folder/history.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numbers>

namespace berm::commands::this_file {
namespace {

constexpr Real slope = -10 * std::numbers::pi / 180, radius = 0.075;

constexpr const char* geometry = R"(t = Tan(10*Pi/180); L = -1.2; R = 1.4; B = -0.7; T = 0.6; f = 0.05; c = 0.15;
Point(1)={L,B,0,c}; Point(2)={R,B,0,c}; Point(3)={R,-R*t,0,c}; Point(4)={0.6,-0.6*t,0,f}; Point(5)={-0.3,0.3*t,0,f}; Point(6)={L,-L*t,0,c};
Point(7)={L,T,0,c}; Point(8)={R,T,0,c}; Point(11)={-0.3,-0.3,0,f}; Point(12)={0.6,-0.4,0,f};
Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,4}; Line(4)={4,5}; Line(5)={5,6}; Line(6)={6,1}; Line(7)={6,7}; Line(8)={7,8}; Line(9)={8,3};
Line(10)={5,11}; Line(11)={11,12}; Line(12)={12,4};
Curve Loop(1)={10,11,12,4}; Plane Surface(1)={1};
Curve Loop(2)={1,2,3,-12,-11,-10,5,6}; Plane Surface(2)={2};
Curve Loop(3)={7,8,9,3,4,5}; Plane Surface(3)={3};
Physical Surface("near")={1}; Physical Surface("bed")={2}; Physical Surface("space")={3};
Physical Curve("left")={6,7}; Physical Curve("right")={2,9}; Physical Curve("base")={1}; Physical Curve("top")={8};
Mesh.Algorithm=6;
)";

constexpr const char* mesh_of_berm = R"(kind = "seabed"
slope = "-10 deg"
length = "2.6 m"
left = "1.2 m"
depth = "0.7 m"
headroom = "0.5 m"
near_size = "50 mm"
near_left = "-0.3 m"
near_right = "0.6 m"
near_depth = "0.25 m"
near_height = "0.15 m"
growth = 0.2
)";

std::string case_on(const std::string& mesh)
{
  return "title = \"cable of 150 mm on loose sand\"\ngravity = [0, \"-9.81 m/s^2\"]\n[mesh]\n" + mesh +
         fmt::format("[rigid.cable]\nshape = \"circle\"\ncenter = [{}, {}]\ndiameter = \"150 mm\"\nmass = \"35 kg/m\"\n",
                     -radius * std::sin(slope), radius * std::cos(slope)) +
         R"([material.sand]
law = "mohr_coulomb"
density = "850 kg/m^3"
young_modulus = "1 MPa"
poisson_ratio = 0.3
friction_angle = "30 deg"
[body.sand]
material = "sand"
regions = ["near", "bed"]
particles_per_cell = 4
damping = 0.05
k0 = 0.5
[contact.skin]
body = "sand"
rigid = "cable"
friction_angle = "20 deg"
[support.left]
boundary = "left"
fixed = ["x"]
[support.right]
boundary = "right"
fixed = ["x"]
[support.base]
boundary = "base"
fixed = ["x", "y"]
[support.top]
boundary = "top"
fixed = ["y"]
[[stage]]
name = "rest"
kind = "geostatic"
damping = 0.7
[[stage]]
name = "lay"
kind = "push"
velocity = "0.2 m/s"
ramp = "20 ms"
until.embedment = "10 mm"
[[stage]]
name = "drag"
kind = "drag"
velocity = "0.2 m/s"
ramp = "20 ms"
vertical = "fixed"
until.displacement = "50 mm"
)";
}

class CableOnSlope : public testing::TestWithParam<const char*> {
protected:
  CableOnSlope()
  {
    folder_.write("slope.geo", geometry);
    folder_.write("slope.toml", case_on(GetParam()));
    ended_ = run_program(folder_.path(), {"run", "slope.toml", "-o", "out", "--threads", "1"});
    if (ended_.status == 0) history_ = run_folder::read_history(folder_ / "out/history.csv");
  }

  TemporaryFolder folder_;
  Ended ended_;
  run_folder::History history_;
};

TEST_P(CableOnSlope, counts_its_embedment_from_the_slope_where_it_is)
{
  ASSERT_EQ(ended_.status, 0) << ended_.err;
  const std::vector<Real>&u = history_["u_m"], &w = history_["w_m"];
  // It touches the slope with w = R - R / cos(slope), and w grows by what the slope falls off, or the cable sinks.
  EXPECT_NEAR(w.front(), radius - radius / std::cos(slope), 1e-9);
  std::size_t first = 0;
  while (history_.stage[first] != "drag") ++first;
  // The push fades over the ramp of 20 ms; from there on the cable keeps its level.
  std::size_t level = first;
  while (history_["time_s"][level] < history_["time_s"][first - 1] + 0.021) ++level;
  ASSERT_LT(level + 10, u.size());
  for (std::size_t k = level; k < u.size(); ++k) EXPECT_NEAR(w[k], w.back() + std::tan(slope) * (u[k] - u.back()), 1e-9);
  EXPECT_NEAR(u.back(), 0.05, 1e-4);
  EXPECT_NEAR(w[first - 1], 0.01, 1e-4) << "the push ends at its embedment below the slope";
}

TEST_P(CableOnSlope, rests_in_equilibrium_before_it_is_pushed)
{
  ASSERT_EQ(ended_.status, 0) << ended_.err;
  EXPECT_EQ(ended_.err.find("did not reach equilibrium"), std::string::npos) << ended_.err;
  const nlohmann::json summary = nlohmann::json::parse(text_of_file(folder_ / "out/summary.json"));
  EXPECT_LE(summary["checks"]["out_of_balance_after_geostatic"], 0.01);
  Real rest = 0;
  for (Index k = 0; k < history_.rows(); ++k)
    if (history_.stage[k] == "rest") rest = history_["time_s"][k];
  // No sooner than H / c_S, no later than the limit: 0.7 m to 1.1 m of sand with c_S = 21 m/s.
  EXPECT_GT(rest, 0.03);
  EXPECT_LT(rest, 1);
}

TEST_P(CableOnSlope, has_its_ground_in_the_run_folder_and_in_the_report)
{
  ASSERT_EQ(ended_.status, 0) << ended_.err;
  std::istringstream lines(text_of_file(folder_ / "out/ground.csv"));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "x_m,y_m");
  int corners = 0;
  for (Real x = 0, y = 0; std::getline(lines, line); ++corners) {
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf", &x, &y), 2);
    EXPECT_NEAR(y, std::tan(slope) * x, 1e-9);
  }
  EXPECT_EQ(corners, 2);
  const Ended report = run_program(folder_.path(), {"report", "out"});
  ASSERT_EQ(report.status, 0) << report.err;
  const std::string page = text_of_file(folder_ / "out/report.html");
  EXPECT_NE(page.find("All formulas here are for a level bed"), std::string::npos);
  EXPECT_NE(page.find("out of range: a level bed"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Meshes, CableOnSlope, testing::Values("kind = \"gmsh\"\nfile = \"slope.geo\"\n", mesh_of_berm),
                         [](const auto& of) { return std::string(of.index == 0 ? "gmsh" : "seabed"); });

TEST(RunOnSlope, resumes_with_the_same_numbers)
{
  TemporaryFolder folder;
  folder.write("slope.toml", case_on(mesh_of_berm));
  const std::vector<std::string> set = {
      "--set", "stage.lay.until.embedment=2 mm", "--set", "stage.drag.until.displacement=4 mm", "--threads", "1"};
  const auto run = [&](std::vector<std::string> words) {
    words.insert(words.end(), set.begin(), set.end());
    return run_program(folder.path(), words);
  };
  ASSERT_EQ(run({"run", "slope.toml", "-o", "whole"}).status, 0);
  std::vector<std::string> words = {"run", "slope.toml", "-o", "cut", "--set", "output.checkpoint_wall_time=0.01"};
  words.insert(words.end(), set.begin(), set.end());
  Program cut(folder.path(), words);
  std::error_code not_there;
  const auto rows_there = [&] { return std::filesystem::file_size(folder / "cut/history.csv", not_there) > 2000 && !not_there; };
  for (int k = 0; k < 30000 && !rows_there(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  cut.signal(SIGTERM);
  const Ended ended = cut.wait();
  ASSERT_EQ(ended.status, 75) << ended.err;
  const std::string begun = text_of_file(folder / "cut/history.csv");
  EXPECT_NE(begun.find(",rest,"), std::string::npos);
  EXPECT_EQ(begun.find(",lay,"), std::string::npos) << "it was to be stopped while it waits for equilibrium";
  const Ended resumed = run_program(folder.path(), {"run", "--resume", "cut", "--threads", "1"});
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_EQ(text_of_file(folder / "cut/history.csv"), text_of_file(folder / "whole/history.csv"));
}

TEST(RunOnSlope, says_so_where_the_ground_finds_no_equilibrium)
{
  TemporaryFolder folder;
  folder.write("slope.toml", case_on(mesh_of_berm));
  const Ended ended = run_program(folder.path(), {"run",       "slope.toml",
                                                  "-o",        "out",
                                                  "--threads", "1",
                                                  "--set",     "mesh.slope=-25 deg",
                                                  "--set",     "material.sand.friction_angle=0",
                                                  "--set",     "material.sand.cohesion=0.8 kPa",
                                                  "--set",     "contact.skin.friction_angle=0",
                                                  "--set",     "rigid.cable.center=[0, \"0.09 m\"]",
                                                  "--set",     "stage.rest.until={equilibrium=true, time=\"0.3 s\"}",
                                                  "--set",     "stage.lay.until.embedment=2 mm",
                                                  "--set",     "stage.drag.until.displacement=1 mm"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("slides down it at a depth of"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("stage \"rest\" did not reach equilibrium in 0.3 s"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("flatten the ground"), std::string::npos) << ended.err;
}

// Of a bed at rest but for one side of a trench the mean velocity is small: rest is asked of each cell.
TEST(RunOnSlope, says_so_where_one_side_of_a_trench_slides)
{
  TemporaryFolder folder;
  folder.write("trench.toml", case_on(mesh_of_berm));
  const Ended ended =
      run_program(folder.path(), {"run", "trench.toml", "-o", "out", "--threads", "1", "--set", "mesh.slope=0", "--set",
                                  "mesh.trench={depth=\"0.15 m\", width=\"0.3 m\", side_slope=\"60 deg\", center=\"0.9 m\"}", "--set",
                                  "rigid.cable.center=[0, \"0.08 m\"]", "--set", "stage.rest.until={equilibrium=true, time=\"0.3 s\"}",
                                  "--set", "stage.lay.until.embedment=2 mm", "--set", "stage.drag.until.displacement=1 mm"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("NOT in equilibrium"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("the soil moves"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace berm::commands::this_file
