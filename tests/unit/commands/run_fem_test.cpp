// SPDX-License-Identifier: BSD-3-Clause
// The built program on a case of finite elements, from outside.
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include "run_folder/history.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/structures.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm::commands::this_file {
namespace {

using Words = std::vector<std::string>;

/// A folder with the small case as small.toml.
struct Place {
  TemporaryFolder folder;

  Place() { folder.write("small.toml", test::small_fem_case); }
  Ended berm(const Words& arguments) const { return run_program(folder.path(), arguments); }
};

TEST(FemCheck, tells_elements_nodes_and_time_and_writes_nothing)
{
  const Place place;
  const Ended ended = place.berm({"check", "small.toml", "--threads", "1"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  for (const char* part : {"elements ", "nodes ", "contact ", "points", "  memory       about ", " MiB at most",
                           " with 1 thread of a free machine (", " s an iteration)"})
    EXPECT_NE(ended.out.find(part), std::string::npos) << part << " is not in\n" << ended.out;
  EXPECT_EQ(names_in(place.folder.path()), Words{"small.toml"});
}

TEST(FemRun, without_a_checkpoint_begins_at_the_start_and_ends_with_the_same_bytes)
{
  const Place place;
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1", "-o", "results"}).status, 0);
  // As a run leaves it that was killed: rows and frames that are not wanted any more, no summary.
  std::filesystem::copy(place.folder / "results", place.folder / "killed", std::filesystem::copy_options::recursive);
  std::filesystem::remove(place.folder / "killed/summary.json");
  std::filesystem::create_directory(place.folder / "killed/checkpoint");
  place.folder.write("killed/checkpoint/case_file.txt", (place.folder / "small.toml").string());
  place.folder.write("killed/history.csv", place.folder.read("results/history.csv") + "0.1,drag,1");
  place.folder.write("killed/frames/soil_0009.vtu", "half a fr");
  const Ended ended = place.berm({"run", "--resume", "killed", "--threads", "1"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("there is no checkpoint in killed: begins at the start"), std::string::npos) << ended.err;
  EXPECT_TRUE(place.folder.read("results/history.csv") == place.folder.read("killed/history.csv"));
  EXPECT_EQ(names_in(place.folder / "results"), names_in(place.folder / "killed"));
  EXPECT_EQ(names_in(place.folder / "results/frames"), names_in(place.folder / "killed/frames"));
  for (const std::string& name : names_in(place.folder / "results/frames"))
    EXPECT_TRUE(place.folder.read("results/frames/" + name) == place.folder.read("killed/frames/" + name)) << name;
}

TEST(RunBoth, runs_a_case_by_both_methods_and_writes_one_page)
{
  const Place place;
  const Ended ended = place.berm({"run", "small.toml", "--both", "--threads", "1", "-o", "out", "--set", "mesh.near_size=10 mm", "--set",
                                  "body.clay.particles_per_cell=4", "--set", "stage.push.until.force=20"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(names_in(place.folder / "out"), (Words{"fem/", "mpm/", "report.html"}));
  EXPECT_NE(place.folder.read("out/mpm/resolved.toml").find("method = \"mpm\""), std::string::npos);
  EXPECT_NE(place.folder.read("out/fem/resolved.toml").find("large_deformation = true"), std::string::npos);
  const std::string page = place.folder.read("out/report.html");
  EXPECT_NE(page.find("finite elements, large deformations, remeshed"), std::string::npos);
  EXPECT_NE(page.find("material point method"), std::string::npos);
  EXPECT_NE(page.find("<p id=\"reliable-method\">"), std::string::npos);
  EXPECT_NE(page.find("<h3>Two methods</h3>"), std::string::npos);
  EXPECT_NE(page.find("\"title\":\"Ground at the ends of stages\""), std::string::npos);
  const Ended again = place.berm({"run", "small.toml", "--both", "-o", "out"});
  EXPECT_EQ(again.status, 2) << "it replaces no results unasked";
}

TEST(FemRun, measures_forces_by_the_soil_of_the_region_below_the_pipe_as_the_report_does)
{
  const Place place;
  const Ended ended = place.berm({"run", "small.toml", "--threads", "1", "-o", "results", "--set",
                                  "material.heavy={law=\"mohr_coulomb\", density=\"1600 kg/m^3\", young_modulus=\"1 MPa\", "
                                  "poisson_ratio=0.45, friction_angle=0, cohesion=\"1 kPa\"}",
                                  "--set", "body.clay.region_material={near=\"heavy\"}", "--set", "gravity=[0, -10]"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const record::RunRecord run = structures::read_run(place.folder / "results");
  const base::BodyScale of_report = base::body_scale(run);
  EXPECT_GT(of_report.unit_weight, 0);
  EXPECT_NEAR(of_report.unit_weight, 2 * base::body_scale(run.settings).unit_weight, 1e-9 * of_report.unit_weight);
  const run_folder::Quantity *V = run.quantity("V_end_of_push"), *bare = run.quantity("V_end_of_push_over_gammaD2");
  ASSERT_TRUE(V != nullptr && bare != nullptr);
  EXPECT_NEAR(bare->value, V->value / (of_report.unit_weight * 0.02 * 0.02), 1e-6 * bare->value) << "as far as summary.json has digits";
}

TEST(FemRun, fills_its_folder_with_all_that_the_manual_names)
{
  const Place place;
  const Ended ended = place.berm({"run", "small.toml", "--threads", "1", "-o", "results"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Words files = names_in(place.folder / "results");
  for (const char* name : {"case.toml", "resolved.toml", "history.csv", "summary.json", "run.log", "mesh.geo", "mesh.msh", "frames/"})
    EXPECT_EQ(std::count(files.begin(), files.end(), name), 1) << name;
  for (const std::string& name : files) EXPECT_EQ(name.find(".part"), std::string::npos) << "a file was left half written: " << name;
  // The first state, and the ends of the three stages.
  const Words frames = names_in(place.folder / "results/frames");
  for (const char* name : {"frames.pvd", "soil_0000.vtu", "soil_0003.vtu", "rigid_0000.vtu"})
    EXPECT_EQ(std::count(frames.begin(), frames.end(), name), 1) << name << " of " << testing::PrintToString(frames);
  EXPECT_EQ(std::count(frames.begin(), frames.end(), "soil_0004.vtu"), 0);
  EXPECT_NE(text_of_file(place.folder / "results/frames/frames.pvd").find("soil_0003.vtu"), std::string::npos);
}

TEST(FemRun, history_has_only_what_the_method_knows_and_a_row_for_each_increment)
{
  const Place place;
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1", "-o", "results"}).status, 0);
  const std::string text = text_of_file(place.folder / "results/history.csv"), header = text.substr(0, text.find('\n'));
  EXPECT_EQ(header, "time_s,stage,u_m,w_m,H_N_m,V_N_m,internal_J_m,friction_J_m,external_J_m,energy_error_J_m,"
                    "overlap_m,M_Nm_m,angle_rad,iterations,unbalance,overstress,strength_lag,deep_ux_m,deep_uy_m,"
                    "deep_sxx_Pa,deep_syy_Pa,deep_szz_Pa,deep_sxy_Pa");
  const run_folder::History history = run_folder::read_history(place.folder / "results/history.csv");
  const auto& w = history["w_m"];
  const auto& u = history["u_m"];
  EXPECT_NEAR(w.front(), 0.01, 1e-15);
  EXPECT_NEAR(u.back(), 0.0004, 1e-15);
  // The push ends within 1e-4 of its force; the drag holds it within the unbalance that is allowed, of all contact forces.
  EXPECT_NEAR(history["V_N_m"].back(), 60, 0.1);
  EXPECT_GT(history["H_N_m"].back(), 0);
  EXPECT_FALSE(history.has("kinetic_J_m"));
  for (std::size_t row = 1; row < w.size(); ++row) EXPECT_LE(history["unbalance"][row], 1e-3);
}

TEST(FemRun, summary_has_nodes_elements_increments_and_iterations)
{
  const Place place;
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1", "-o", "results"}).status, 0);
  const auto summary = nlohmann::json::parse(text_of_file(place.folder / "results/summary.json"));
  for (const char* name : {"wall_s", "threads", "nodes", "cells", "steps", "iterations"})
    EXPECT_GT(summary["timing"][name].get<double>(), 0) << name;
  EXPECT_GE(summary["timing"]["iterations"], summary["timing"]["steps"]);
  EXPECT_EQ(summary["checks"]["finished"], true);
  EXPECT_EQ(summary["checks"]["friction_work_is_loss"], true);
  EXPECT_LE(summary["checks"]["largest_unbalance"].get<double>(), 1e-3);
  EXPECT_LT(summary["checks"]["energy_error"].get<double>(), 5e-3);
  for (const char* name : {"V_end_of_push", "w_end_of_push"}) EXPECT_TRUE(summary["quantities"].contains(name)) << name;
  // All that is there is in history.csv.
  const run_folder::History history = run_folder::read_history(place.folder / "results/history.csv");
  EXPECT_EQ(summary["timing"]["steps"].get<std::size_t>() + 1, history["w_m"].size());
}

TEST(FemRun, of_resolved_toml_writes_the_same_history_byte_for_byte)
{
  const Place place;
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1", "-o", "one"}).status, 0);
  const Ended again = place.berm({"run", "one/resolved.toml", "--threads", "1", "-o", "two"});
  ASSERT_EQ(again.status, 0);
  EXPECT_EQ(again.err.find("is not used"), std::string::npos) << "nobody wrote the keys of the other method: " << again.err;
  EXPECT_NE(place.berm({"check", "one/resolved.toml", "--set", "output.history_time=1"}).err.find("--set output.history_time: is not used"),
            std::string::npos);
  EXPECT_GT(text_of_file(place.folder / "one/history.csv").size(), 1000u);
  EXPECT_TRUE(text_of_file(place.folder / "one/history.csv") == text_of_file(place.folder / "two/history.csv"));
}

TEST(FemRun, of_several_cases_runs_them_side_by_side_with_the_results_of_single_runs)
{
  const Place place;
  place.folder.write("other.toml", test::small_fem_case);
  const std::string set = "stage.drag.until.displacement=\"0.2 mm\"";
  const Ended both = place.berm({"run", "small.toml", "other.toml", "--threads", "2", "-o", "both", "--set", set});
  ASSERT_EQ(both.status, 0) << both.err;
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1", "-o", "alone", "--set", set}).status, 0);
  const std::string alone = text_of_file(place.folder / "alone/history.csv");
  for (const char* name : {"both/small", "both/other"}) EXPECT_EQ(text_of_file(place.folder / name / "history.csv"), alone) << name;
  EXPECT_EQ(names_in(place.folder / "both"), (Words{"other/", "small/"}));
  for (const char* name : {"both/small", "both/other"}) {
    EXPECT_NE(both.err.find(std::string("everything is in ") + name), std::string::npos) << both.err;
    EXPECT_NE(text_of_file(place.folder / name / "run.log").find(", 1 thread"), std::string::npos) << "one after the other";
  }
}

TEST(FemRun, that_fails_ends_with_status_1_and_keeps_what_it_had)
{
  // Forces do not balance to less than rounding.
  const Place place;
  const Ended ended = place.berm({"run", "small.toml", "--threads", "1", "-o", "results", "--set", "fem.tolerance=1e-17"});
  EXPECT_EQ(ended.status, 1);
  for (const char* part : {"berm: stage \"push\": no equilibrium at t = ", "fem.relaxation"})
    EXPECT_NE(ended.err.find(part), std::string::npos) << part << " is not in: " << ended.err;
  EXPECT_EQ(nlohmann::json::parse(text_of_file(place.folder / "results/summary.json"))["checks"]["finished"], false);
  EXPECT_NE(text_of_file(place.folder / "results/run.log").find("no equilibrium"), std::string::npos);
}

TEST(FemRun, whose_soil_moves_by_more_than_the_model_is_large_fails)
{
  const Place place;
  place.folder.write("soft.toml", R"(method = "fem"
gravity = [0, "-10 m/s^2"]
mesh = {kind = "box", size = [1, 1], cells = [2, 2]}
material.mud = {law = "linear_elastic", density = 1000, young_modulus = 1e-6, poisson_ratio = 0.3}
body.mud = {material = "mud", regions = ["box"]}
support.base = {boundary = "bottom", fixed = ["x", "y"]}
[[stage]]
name = "rest"
kind = "free"
until.time = "1 s"
)");
  const Ended ended = place.berm({"run", "soft.toml", "-o", "results"});
  EXPECT_EQ(ended.status, 1);
  for (const char* part : {"the soil at (", "and the mesh is 1 m wide and 1 m high: it is too soft or too weak"})
    EXPECT_NE(ended.err.find(part), std::string::npos) << part << " is not in: " << ended.err;
}

/// A wrong case: the small one with these words replaced, and what berm says of it.
struct Wrong {
  std::string name, from, to;
  Words says;
};

void PrintTo(const Wrong& wrong, std::ostream* out)
{
  *out << wrong.name;
}

class FemWrongInputs : public testing::TestWithParam<Wrong> {};

TEST_P(FemWrongInputs, end_run_and_check_with_status_2_one_line_and_nothing_written)
{
  const Wrong& wrong = GetParam();
  std::string text = test::small_fem_case;
  const auto at = text.find(wrong.from);
  ASSERT_NE(at, std::string::npos) << wrong.from;
  text.replace(at, wrong.from.size(), wrong.to);
  TemporaryFolder folder;
  folder.write("case.toml", text);
  for (const Words& arguments : {Words{"run", "case.toml", "-o", "results"}, Words{"check", "case.toml"}}) {
    const Ended ended = run_program(folder.path(), arguments);
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(ended.err.find("berm: "), 0u) << ended.err;
    EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << "more or less than one line: " << ended.err;
    for (const std::string& part : wrong.says)
      EXPECT_NE(ended.err.find(part), std::string::npos) << "no `" << part << "` in: " << ended.err;
    EXPECT_EQ(names_in(folder.path()), Words{"case.toml"}) << "something was written";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Table, FemWrongInputs,
    testing::Values(Wrong{"misspelt_method", "\"fem\"", "\"fme\"", {"method", "\"fem\""}},
                    Wrong{"free_rigid_body", "mass = ", "motion = \"free\"\nmass = ", {"rigid.pipe.motion", "cannot be \"free\""}},
                    Wrong{"contact_of_two_bodies",
                          "regions = [\"near\", \"bed\"]",
                          "regions = [\"bed\"]\n[body.near]\nmaterial = \"clay\"\nregions = [\"near\"]\n"
                          "[contact.inner]\nbody = \"clay\"\nother_body = \"near\"\nfriction_angle = 0",
                          {"contact.inner.other_body", "rigid body only"}},
                    Wrong{"disk",
                          "regions = [\"near\", \"bed\"]",
                          "[body.clay.disk]\ncenter = [0, \"-40 mm\"]\ndiameter = \"20 mm\"\nspacing = \"2 mm\"",
                          {"body.clay.disk", "must fill regions"}},
                    Wrong{"pipe_above_the_surface", "center = [0, 0]", "center = [0, \"15 mm\"]", {"rigid.pipe"}},
                    Wrong{"pipe_without_mass_under_a_force", "mass = 1\n", "", {"stage", "[rigid.pipe]", "needs a mass"}},
                    Wrong{"push_without_drive", "velocity = \"1 m/s\"\n", "", {"stage", "needs either velocity or force"}},
                    Wrong{"drive_without_contact",
                          "[contact.skin]\nbody = \"clay\"\nrigid = \"pipe\"\nfriction_angle = 0\nadhesion = \"500 Pa\"\n",
                          "",
                          {"stage.push", "a contact joins with the soil", "rigid.pipe"}},
                    Wrong{"no_tolerance", "[fem]\n", "[fem]\ntolerance = 0\n", {"fem.tolerance"}}),
    [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace berm::commands::this_file
