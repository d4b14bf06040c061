// SPDX-License-Identifier: BSD-3-Clause
// A run that is stopped and goes on on a longer mesh: refused where it cannot, whole where it is cut short, and near a run on that mesh from the start.
#include "simulation/longer_mesh.hpp"

#include "input/read_case.hpp"
#include "os/error.hpp"
#include "record/run_record.hpp"
#include "run_folder/history.hpp"
#include "run_folder/origin.hpp"
#include "samples/error_of.hpp"
#include "samples/small_cases.hpp"
#include "samples/temporary_folder.hpp"
#include "simulation/run_place.hpp"

#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <sstream>

namespace berm::simulation::this_file {
namespace {

namespace fs = std::filesystem;

using Set = std::vector<std::string>;

/// The small line, laid for half a second and pushed sideways for as long; or its slice alone, dragged.
class LongerMesh : public testing::Test {
protected:
  LongerMesh() { folder_.write("line.toml", test::small_line_case); }

  RunRequest request(const std::string& name, Set set = {}) const
  {
    for (const char* change : {"stage.current.until.time=\"0.3 s\"", "stage.current.ramp=\"0.2 s\"", "stage.lay.until.time=\"0.6 s\"",
                               "output.history_time=\"0.02 s\"", "output.frame_time=\"0.1 s\"", "mesh.pattern=\"lattice\""})
      set.insert(set.begin(), change);
    return {.settings = input::read_case(folder_ / "line.toml", set), .case_file = folder_ / "line.toml", .folder = folder_ / name};
  }

  /// Until a row of this time, s, is written.
  bool run(const RunRequest& request, Real until = infinity, int threads = 1)
  {
    int steps = 0;
    const auto stops = [&] {
      return std::isfinite(until) && ++steps % 10 == 0 &&
             run_folder::read_history(request.folder / "history.csv")["time_s"].back() >= until;
    };
    Context context(threads, stops, std::make_shared<spdlog::sinks::ostream_sink_mt>(messages_));
    return run_case(request, context);
  }

  RunRequest longer(const std::string& name, const Set& set) const { return on_longer_mesh(*run_to_resume(folder_ / name), set); }

  Real end_of(const std::string& name, const std::string& column) const
  {
    return run_folder::read_history(folder_ / name / "history.csv")[column].back();
  }

  /// Or fall, of a column of soil, m.
  Real largest_rise(const std::string& name) const
  {
    std::istringstream rows(folder_.read(name + "/berms.csv"));
    std::string row, number;
    Real largest = 0;
    for (std::getline(rows, row); std::getline(rows, row);) {
      std::istringstream numbers(row);
      for (int k = 0; std::getline(numbers, number, ','); ++k)
        if (k > 2) largest = std::max(largest, std::abs(std::stod(number)));
    }
    return largest;
  }

  TemporaryFolder folder_;
  std::ostringstream messages_;
};

const Set further = {"mesh.near_right=\"1 m\"", "mesh.length=\"2.4 m\""};

TEST_F(LongerMesh, goes_on_as_a_run_that_had_it_from_the_start)
{
  run(request("parts"), 1.5);
  ASSERT_TRUE(can_be_resumed(folder_ / "parts"));
  ASSERT_TRUE(run(longer("parts", further))) << messages_.str();
  ASSERT_TRUE(run(request("whole", further)));
  ASSERT_TRUE(run(request("short")));
  ASSERT_TRUE(run(request("coarser", {further[0], further[1], "mesh.far_size=\"0.16 m\""})));
  for (const char* column : {"line_y_m", "V_N_m", "slice_2_u_m"}) {
    const Real whole = end_of("whole", column);
    // Twice what another size of the far cells does; the length does more, or the test could not fail.
    const Real allowed = 2 * std::abs(end_of("coarser", column) - whole);
    EXPECT_NEAR(end_of("parts", column), whole, allowed) << column;
    EXPECT_GT(std::abs(end_of("short", column) - whole), allowed) << column;
  }
  // The same soil has risen: columns do not see that particles of the run before lie otherwise.
  EXPECT_NEAR(largest_rise("parts"), largest_rise("whole"), 0.01) << "an eighth of a cell; 0.06 m where they do";
  const auto origin = run_folder::read_origin(folder_ / "parts");
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->set, further);
  EXPECT_TRUE(origin->lengthened);
  const record::RunRecord record = record::read_run(folder_ / "parts");
  EXPECT_EQ(std::get<mesh::SeabedMesh>(record.settings.mesh).near_right, 1);
}

TEST_F(LongerMesh, goes_on_to_the_same_bytes_after_it_was_stopped_again_and_on_two_threads_without_a_pattern_too)
{
  run(request("once", {"mesh.pattern=\"unstructured\""}), 1.5);
  fs::copy(folder_ / "once", folder_ / "twice", fs::copy_options::recursive);
  ASSERT_TRUE(run(longer("once", further)));
  run(longer("twice", further), 1.55, 2);
  ASSERT_TRUE(can_be_resumed(folder_ / "twice"));
  EXPECT_EQ(std::get<mesh::SeabedMesh>(run_to_resume(folder_ / "twice")->settings.mesh).length, 2.4);
  ASSERT_TRUE(run(*run_to_resume(folder_ / "twice"))) << messages_.str();
  for (const char* name : {"history.csv", "line.csv", "berms.csv"})
    EXPECT_EQ(folder_.read(std::string("once/") + name), folder_.read(std::string("twice/") + name)) << name;
  for (const fs::directory_entry& frame : fs::directory_iterator(folder_ / "once/frames")) {
    const std::string name = "frames/" + frame.path().filename().string();
    EXPECT_EQ(folder_.read("once/" + name), folder_.read("twice/" + name)) << name;
  }
}

TEST_F(LongerMesh, is_refused_for_other_keys_inwards_and_where_nothing_is_to_do_goes_on_as_before)
{
  run(request("run"), 1.6);
  const auto refusal = [&](const Set& set) { return test::error_of<InputError>([&] { longer("run", set); }); };
  EXPECT_NE(refusal({"mesh.depth=\"1 m\""}).find("allowed: mesh.near_left, mesh.near_right, mesh.left, mesh.length"), std::string::npos);
  EXPECT_NE(refusal({"mesh.near_right=\"0.7 m\""}).find("would lie at x = 0.7 m, inside of that of the run, 0.8 m"), std::string::npos);
  EXPECT_NE(refusal({"mesh.left=\"1 m\""}).find("the right end of the mesh"), std::string::npos) << "2 m long, it ends at 1 m";
  EXPECT_FALSE(longer("run", {"mesh.near_right=\"0.8 m\""}).shorter);
  RunRequest other = *run_to_resume(folder_ / "run");
  other.settings.geometry = settings::Geometry::axisymmetric;
  EXPECT_NE(test::error_of<InputError>([&] { on_longer_mesh(other, further); }).find("in plane strain"), std::string::npos);
}

TEST_F(LongerMesh, is_advised_where_a_pipe_comes_nearer_to_the_end_of_the_fine_cells_than_its_width)
{
  RunRequest line = request("line");
  const auto command = [&](Real from, Real to) { return command_to_lengthen(line, {{-0.2, 0.2}, {from, to}}); };
  EXPECT_EQ(command(-0.1, 0.3), "");
  EXPECT_NE(command(0.1, 0.5).find("--set 'mesh.near_right=\"1.7 m\"' --set 'mesh.length=\"2.9 m\"'"), std::string::npos)
      << command(0.1, 0.5);
  EXPECT_NE(command(-0.3, 0.1).find("--set 'mesh.near_left=\"-1.5 m\"' --set 'mesh.left=\"2 m\"' --set 'mesh.length=\"3.2 m\"'"),
            std::string::npos)
      << command(-0.3, 0.1);
  line.settings.geometry = settings::Geometry::axisymmetric;
  EXPECT_EQ(command(0.1, 0.5), "");
}

TEST_F(LongerMesh, is_advised_by_the_error_of_a_pipe_that_leaves_its_mesh)
{
  const Set fast = {"stage.current.pipeline.lateral=\"6 kN/m\"", "stage.current.until.time=\"3 s\""};
  const std::string error = test::error_of<RunError>([&] { run(request("run", fast)); });
  EXPECT_NE(error.find("on a longer mesh: berm run --resume " + (folder_ / "run").string() + " --set 'mesh.near_right="), std::string::npos)
      << error;
}

}  // namespace
}  // namespace berm::simulation::this_file
