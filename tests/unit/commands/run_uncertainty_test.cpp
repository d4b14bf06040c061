// SPDX-License-Identifier: BSD-3-Clause
// The built program from outside: berm run --uncertainty.
#include "io/folder_lock.hpp"
#include "run_folder/summary_file.hpp"
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::commands::this_file {
namespace {

using Words = std::vector<std::string>;
namespace fs = std::filesystem;

/// A folder with the small case on finite elements of a tenth of the pipe.
struct Place {
  TemporaryFolder folder;

  Place() { folder.write("fem.toml", test::small_fem_case); }
  /// With the run of another place.
  explicit Place(const Place& another) : Place() { fs::copy(another.folder / "run", folder / "run", fs::copy_options::recursive); }
  /// All use the same meshes.
  Ended berm(const Words& arguments) const
  {
    static const TemporaryFolder meshes;
    return run_program(folder.path(), arguments, {"BERM_MESH_CACHE=" + meshes.path().string()});
  }
  /// Runs the case on elements small enough for a band.
  Ended run(const Words& more) const
  {
    Words words = {
        "run", "fem.toml", "-o", "run", "--threads", "1", "--set", "fem.contact_size=\"2 mm\"", "--set", "mesh.near_size=\"4 mm\""};
    words.insert(words.end(), more.begin(), more.end());
    return berm(words);
  }
  run_folder::Uncertainty uncertainty() const
  {
    run_folder::Uncertainty nothing;
    nothing.missing = "nothing there";
    return run_folder::read_summary(folder / "run")->uncertainty.value_or(nothing);
  }
};

/// Two runs, made once for all tests: one with bands, and one without.
class Uncertainty : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    with_ = new Place;
    without_ = new Place;
    ended_ = with_->run({"--uncertainty"});
    ASSERT_EQ(ended_.status, 0) << ended_.err;
    ASSERT_EQ(without_->run({}).status, 0);
  }
  static void TearDownTestSuite()
  {
    delete with_;
    delete without_;
  }

  static Place *with_, *without_;
  static Ended ended_;
};
Place *Uncertainty::with_ = nullptr, *Uncertainty::without_ = nullptr;
Ended Uncertainty::ended_;

const Words all_variants = {"cells_0.5", "cells_1.5", "cells_1.5_long_steps"};

TEST_F(Uncertainty, puts_bands_beside_the_results_and_changes_no_byte_of_the_run)
{
  const Place &with = *with_, &without = *without_;
  const Ended& ended = ended_;
  EXPECT_EQ(text_of_file(with.folder / "run/history.csv"), text_of_file(without.folder / "run/history.csv"));
  EXPECT_NE(ended.err.find("3 more runs, which take about 4.7 times the work"), std::string::npos) << ended.err;
  const run_folder::Uncertainty u = with.uncertainty();
  EXPECT_EQ(u.missing, "");
  Words names;
  for (const run_folder::BandRun& run : u.runs) names.push_back(run.name);
  EXPECT_EQ(names, all_variants);
  for (const char* name : {"w_end_of_push", "H_max", "H_end_of_drag"}) {
    const run_folder::Band* band = u.find(name);
    ASSERT_NE(band, nullptr) << name;
    EXPECT_GT(band->half_width, 0) << name;
    EXPECT_EQ(band->noise, 0) << "finite elements have none";
    EXPECT_NEAR(band->half_width, band->extrapolation + std::hypot(band->mesh, band->speed), 1e-9 * std::abs(band->half_width)) << name;
  }
  EXPECT_EQ(u.find("V_end_of_push"), nullptr) << "the input prescribes it";
  EXPECT_EQ(u.find("H_max_over_gammaD2"), nullptr);
  EXPECT_EQ(u.find("overlap_max"), nullptr) << "a measure of quality";
  ASSERT_FALSE(u.curves.empty());
  EXPECT_NE(ended.out.find("H_max"), std::string::npos);
  EXPECT_NE(ended.out.find("converged"), std::string::npos);
  EXPECT_NE(text_of_file(with.folder / "run/run.log").find("converged"), std::string::npos);
  EXPECT_FALSE(without.uncertainty().missing.empty()) << "who did not ask has none";
}

TEST_F(Uncertainty, of_a_finished_run_is_found_by_resuming_it_without_what_is_there_already)
{
  const Place place(*without_);
  const std::string history = text_of_file(place.folder / "run/history.csv");
  ASSERT_EQ(place.berm({"run", "--resume", "run", "--uncertainty", "--threads", "1"}).status, 0);
  const auto first = json_of(place.uncertainty());
  fs::remove_all(place.folder / "run/uncertainty/cells_1.5");
  const Ended again = place.berm({"run", "--resume", "run", "--uncertainty", "--threads", "1"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.err.find("of which 2 have their result already"), std::string::npos) << again.err;
  EXPECT_EQ(json_of(place.uncertainty())["quantities"].dump(), first["quantities"].dump());
  EXPECT_EQ(text_of_file(place.folder / "run/history.csv"), history);
}

TEST_F(Uncertainty, goes_on_with_a_run_that_was_stopped_on_the_way)
{
  const Place place(*with_);
  const auto first = json_of(place.uncertainty());
  // As Ctrl-C leaves a variant that had no checkpoint yet: results of a part, and where its case was.
  const std::string variant = "run/uncertainty/cells_1.5/";
  std::string summary = text_of_file(place.folder / (variant + "summary.json"));
  const std::string finished = "\"finished\": true";
  const std::size_t at = summary.find(finished);
  ASSERT_NE(at, std::string::npos) << summary;
  place.folder.write(variant + "summary.json", summary.replace(at, finished.size(), "\"finished\": false"));
  fs::create_directories(place.folder / (variant + "checkpoint"));
  place.folder.write(variant + "checkpoint/case_file.txt", (place.folder / "run/uncertainty/cells_1.5.toml").string());
  const std::string log = text_of_file(place.folder / (variant + "run.log"));
  const Ended again = place.berm({"run", "--resume", "run", "--uncertainty", "--threads", "1"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.err.find("of which 2 have their result already, 1 resumed from a checkpoint"), std::string::npos) << again.err;
  EXPECT_EQ(text_of_file(place.folder / (variant + "run.log")).find(log), 0u) << "a run that is replaced begins a log of its own";
  EXPECT_EQ(json_of(place.uncertainty())["quantities"].dump(), first["quantities"].dump());
}

TEST_F(Uncertainty, is_refused_while_another_process_has_the_run_folder)
{
  const Place place(*without_);
  const io::FolderLock another(place.folder / "run");
  const Ended ended = place.berm({"run", "--resume", "run", "--uncertainty", "--threads", "1"});
  EXPECT_NE(ended.status, 0);
  EXPECT_NE(ended.err.find("another run is writing into it"), std::string::npos) << ended.err;
  EXPECT_FALSE(fs::exists(place.folder / "run/uncertainty")) << "before any of its runs begins";
}

TEST_F(Uncertainty, that_cannot_be_put_into_the_log_is_an_error)
{
  const Place place(*with_);
  fs::remove(place.folder / "run/run.log");
  fs::create_directory(place.folder / "run/run.log");
  const Ended ended = place.berm({"run", "--resume", "run", "--uncertainty", "--threads", "1"});
  EXPECT_NE(ended.status, 0);
  EXPECT_NE(ended.err.find("cannot write run/run.log"), std::string::npos) << ended.err;
}

TEST_F(Uncertainty, goes_with_the_run_that_is_replaced)
{
  const Place place(*with_);
  ASSERT_EQ(place.run({"--force"}).status, 0);
  EXPECT_FALSE(fs::exists(place.folder / "run/uncertainty"));
  EXPECT_EQ(place.uncertainty().missing, "nothing there");
}

// The springs of its runs, carried to zero cell size: their peak is the largest H of the drag.
TEST_F(Uncertainty, is_in_the_springs_that_are_exported)
{
  const Place place(*with_);
  const Ended ended = place.berm({"export", "run", "-o", "springs"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const std::string springs = text_of_file(place.folder / "springs/springs.csv");
  EXPECT_NE(springs.find("best: forces extrapolated to zero cell size from 4 runs"), std::string::npos) << springs;
  const run_folder::Uncertainty u = place.uncertainty();
  const run_folder::Band* band = u.find("H_max");
  ASSERT_NE(band, nullptr);
  const std::size_t line = springs.find("lateral drag,peak,");
  ASSERT_NE(line, std::string::npos) << springs;
  Real best = 0, low = 0, high = 0;
  ASSERT_EQ(std::sscanf(springs.c_str() + line, "lateral drag,peak,N/m,%lf,%lf,,%lf,4", &best, &low, &high), 3) << springs.substr(line, 80);
  EXPECT_NEAR(best, band->converged, 1e-6 * best);
  EXPECT_NEAR(high - low, 2 * band->half_width, 1e-6 * best);
  EXPECT_NE(text_of_file(place.folder / "springs/curves.csv").find("lateral drag,low,"), std::string::npos);
  fs::remove_all(place.folder / "run/uncertainty/cells_1.5");
  const Ended without = place.berm({"export", "run", "-o", "computed"});
  EXPECT_EQ(without.status, 0);
  EXPECT_NE(without.err.find("the springs are as computed, without bands"), std::string::npos) << without.err;
}

// A force that the coarsest elements cannot find equilibrium for would be luck; a folder in the place of a variant that is no run's is not.
TEST_F(Uncertainty, is_left_out_with_the_reason_where_one_of_its_runs_fails)
{
  const Place place(*without_);
  fs::create_directories(place.folder / "run/uncertainty/cells_1.5");
  place.folder.write("run/uncertainty/cells_1.5/notes.txt", "not of a run");
  const Ended ended = place.berm({"run", "--resume", "run", "--uncertainty", "--threads", "1"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.err.find("there is no band: the run cells_1.5 failed"), std::string::npos) << ended.err;
  EXPECT_EQ(place.uncertainty().missing.find("the run cells_1.5 failed"), 0u) << place.uncertainty().missing;
  EXPECT_TRUE(place.uncertainty().quantities.empty());
}

TEST_F(Uncertainty, that_cannot_be_found_is_refused_before_anything_runs)
{
  const Place place;
  const Ended coarse = place.berm({"run", "fem.toml", "-o", "run", "--uncertainty", "--set", "fem.contact_size=\"5 mm\""});
  EXPECT_EQ(coarse.status, 2);
  EXPECT_NE(coarse.err.find("fem.contact_size"), std::string::npos) << coarse.err;
  EXPECT_FALSE(fs::exists(place.folder / "run"));
}

TEST_F(Uncertainty, of_material_points_holds_noise_and_speed)
{
  const Place place;
  place.folder.write("small.toml", test::small_case);
  const Ended ended = place.berm({"run", "small.toml", "-o", "run", "--threads", "1", "--uncertainty", "--set", "mesh.cells=[48, 24]",
                                  "--set", "body.sand.block.spacing=0.8333e-3"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const run_folder::Uncertainty u = place.uncertainty();
  const run_folder::Band* band = u.find("V_end_of_push");
  ASSERT_NE(band, nullptr);
  EXPECT_GT(band->noise, 0);
  EXPECT_GT(band->speed, 0);
  EXPECT_EQ(u.runs.at(2).speed, 2);
  ASSERT_EQ(u.runs.size(), 5u) << "with grains, since this sand has none";
  ASSERT_EQ(u.grains.d50, (std::vector<Real>{0.1e-3, 0.5e-3}));
  const run_folder::GrainNumber& V = u.grains.numbers.front();
  EXPECT_LT(V.with[0], V.with[1]);
  EXPECT_LT(V.with[1], V.without);
}

}  // namespace
}  // namespace berm::commands::this_file
