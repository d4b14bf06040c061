// SPDX-License-Identifier: BSD-3-Clause
// Runs of both methods inside the process, by the context that a program gives them.
#include "simulation/simulate.hpp"

#include "input/read_case.hpp"
#include "os/error.hpp"
#include "run_folder/summary_file.hpp"
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <gtest/gtest.h>
#include <omp.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <sstream>

namespace berm::simulation::this_file {
namespace {

namespace fs = std::filesystem;

class RunOf : public testing::TestWithParam<const char*> {
protected:
  RunOf()
  {
    folder_.write("mpm.toml", test::small_case);
    folder_.write("fem.toml", test::small_fem_case);
    folder_.write("space.toml", test::small_space_case);
    folder_.write("fem_space.toml", test::small_fem_space_case);
    std::string ball = test::small_case;  // the same around an axis, pushed twice
    const auto replace = [&](const std::string& from, const std::string& to) { ball.replace(ball.find(from), from.size(), to); };
    replace("gravity =", "geometry = \"axisymmetric\"\ngravity =");
    replace("center = [\"50 mm\"", "center = [0");
    replace("kg/m\"\n\n[contact", "kg\"\n\n[contact");
    replace("friction_angle = \"23 deg\"", "friction_angle = \"23 deg\"\nadhesion = \"100 Pa\"");
    replace("kind = \"drag\"", "kind = \"push\"");
    replace("until.displacement = \"2 mm\"", "until.embedment = \"4 mm\"");
    folder_.write("axisymmetric.toml", ball);
    std::string water = test::small_case;  // the same with water that flows
    const std::string pores =
        "water.drainage = \"consolidation\"\nwater.permeability = 1e-3\nwater.porosity = 0.4\ninertia_density = 1877\n";
    water.insert(water.find('\n', water.find("friction_angle =")) + 1, pores);
    folder_.write("consolidation.toml", water);
    std::string sand = test::small_fem_case;  // whose flow is not associated
    sand.replace(sand.find("friction_angle = 0"), 18, "friction_angle = 0.5");
    folder_.write("fem_sand.toml", sand);
    sand.replace(sand.find("friction_angle = 0.5"), 20, "friction_angle = 0.5\n" + pores);
    sand.replace(sand.find("friction_angle = 0\n"), 19, "friction_angle = 0.3\n");  // of the interface
    folder_.write("fem_consolidation.toml", sand);
    std::string half = test::small_fem_case;  // a ball in clay, pushed in both stages
    const auto in_half = [&](const std::string& from, const std::string& to) { half.replace(half.find(from), from.size(), to); };
    in_half("method = \"fem\"", "method = \"fem\"\ngeometry = \"axisymmetric\"");
    in_half("length = \"200 mm\"", "length = \"100 mm\"\nleft = 0");
    in_half("near_left = \"-20 mm\"", "near_left = 0");
    in_half("kind = \"drag\"", "kind = \"push\"");
    in_half("until.force = 60", "until.force = 1");
    in_half("until.displacement = \"0.4 mm\"", "until.embedment = \"10.4 mm\"");
    folder_.write("fem_axisymmetric.toml", half);
    std::string large = test::small_fem_case;  // meshed anew five times; two pipes, of which the second is held at first, and then dragged
    large.replace(large.find("contact_size = "), 0, "large_deformation = true\nremeshing_travel = 0.01\n");
    large.replace(large.find("until.displacement = \"0.4 mm\""), 29,
                  "until.displacement = \"1.0 mm\"\nrigid = \"other\"\nvertical = \"fixed\"\n");
    large.replace(large.find("until.force = 60"), 16, "until.force = 60\nrigid = \"pipe\"");
    large += "\n[rigid.other]\nshape = \"circle\"\ncenter = [\"40 mm\", 0]\ndiameter = \"20 mm\"\nmass = 1\n"
             "[contact.other_skin]\nbody = \"clay\"\nrigid = \"other\"\nfriction_angle = 0\n";
    folder_.write("fem_large.toml", large);
  }

  bool is_fem() const { return std::string(GetParam()).starts_with("fem"); }

  RunRequest request(const std::string& name, bool resume = false) const
  {
    const fs::path file = folder_ / (std::string(GetParam()) + ".toml");
    return {input::read_case(file), file, folder_ / name, resume};
  }

  /// Runs at most so many steps, silently.
  bool run(const std::string& name, int max_steps, bool resume = false)
  {
    int steps = 0;
    Context context(
        1, [&] { return ++steps >= max_steps; }, std::make_shared<spdlog::sinks::ostream_sink_mt>(messages_));
    return run_case(request(name, resume), context);
  }

  TemporaryFolder folder_;
  std::ostringstream messages_;
};

constexpr int all = 1 << 30;

INSTANTIATE_TEST_SUITE_P(Methods, RunOf,
                         testing::Values("mpm", "axisymmetric", "space", "consolidation", "fem", "fem_sand", "fem_consolidation",
                                         "fem_axisymmetric", "fem_large", "fem_space"),
                         [](const auto& of) { return std::string(of.param); });

TEST_P(RunOf, a_case_that_is_stopped_again_and_again_ends_with_the_same_bytes)
{
  ASSERT_TRUE(run("whole", all));
  int parts = 1;
  const int steps = is_fem() ? 4 : 41;
  bool finished = run("parts", steps);
  while (!finished) {
    const auto summary = run_folder::read_summary(folder_ / "parts");
    ASSERT_TRUE(summary);
    EXPECT_FALSE(summary->finished());
    ASSERT_NO_THROW(finished = run("parts", steps, true)) << messages_.str();
    ASSERT_LT(++parts, 100);
    EXPECT_EQ(messages_.str().find("is not used"), std::string::npos) << messages_.str();
  }
  EXPECT_GT(parts, 4);
  EXPECT_TRUE(folder_.read("whole/history.csv") == folder_.read("parts/history.csv"));
  const auto frames = names_in(folder_ / "whole/frames");
  EXPECT_EQ(frames, names_in(folder_ / "parts/frames"));
  for (const std::string& name : frames) EXPECT_TRUE(folder_.read("whole/frames/" + name) == folder_.read("parts/frames/" + name)) << name;
  const auto whole = run_folder::read_summary(folder_ / "whole"), by_parts = run_folder::read_summary(folder_ / "parts");
  EXPECT_EQ(whole->checks, by_parts->checks);
  EXPECT_EQ(whole->timing.at("steps"), by_parts->timing.at("steps"));
  EXPECT_FALSE(fs::exists(folder_ / "parts/checkpoint")) << "a run that is finished has none";
}

/// Runs around an axis and in space.
class RunOfWholeBodies : public RunOf {};

INSTANTIATE_TEST_SUITE_P(Geometries, RunOfWholeBodies, testing::Values("axisymmetric", "space", "fem_axisymmetric", "fem_space"),
                         [](const auto& of) { return std::string(of.param); });

TEST_P(RunOfWholeBodies, tells_forces_energies_and_moments_of_the_whole_and_none_per_metre)
{
  ASSERT_TRUE(run("whole", all));
  for (const char* file : {"history.csv", "history.schema.json", "summary.json", "run.log", "plots/curves.dat", "plots/curves.gp"})
    for (const char* per_metre : {"N/m\"", "N/m)", "N/m ", "N_m,", "J/m\"", "J_m,", "N m/m", "Nm_m,", "kg/m\""})
      EXPECT_EQ(folder_.read(std::string("whole/") + file).find(per_metre), std::string::npos) << per_metre << " in " << file;
  EXPECT_NE(folder_.read("whole/history.csv").find("V_N,"), std::string::npos);
}

TEST_P(RunOf, a_case_takes_threads_messages_and_times_of_its_context_and_leaves_the_caller_as_it_was)
{
  std::ostringstream messages;
  const int threads = omp_get_max_threads();
  const auto logger = spdlog::default_logger();
  {
    Context context(2, {}, std::make_shared<spdlog::sinks::ostream_sink_mt>(messages));
    EXPECT_TRUE(run_case(request("results"), context));
    EXPECT_FALSE(context.timings().table().empty());
    EXPECT_THROW(Context(1), RunError) << "a process has one at a time";
  }
  EXPECT_NE(messages.str().find("2 threads"), std::string::npos) << messages.str();
  EXPECT_NE(messages.str().find("everything is in "), std::string::npos) << messages.str();
  EXPECT_EQ(run_folder::read_summary(folder_ / "results")->timing.at("threads"), 2);
  EXPECT_EQ(omp_get_max_threads(), threads);
  EXPECT_EQ(spdlog::default_logger(), logger);
}

TEST_P(RunOf, a_case_refuses_a_checkpoint_of_another_case)
{
  ASSERT_FALSE(run("parts", 5));
  const std::string file = std::string(GetParam()) + ".toml", more = std::string("[watch.more]\nbody = \"") + (is_fem() ? "clay" : "sand") +
                                                                     "\"\npoint = [0.01, 0" + (file == "space.toml" ? ", 0]\n" : "]\n");
  folder_.write(file, folder_.read(file) + (file == "fem_space.toml" ? "[output]\nframe_time = \"1 s\"\n" : more));
  EXPECT_THROW(run("parts", all, true), RunError);
}

}  // namespace
}  // namespace berm::simulation::this_file
