// SPDX-License-Identifier: BSD-3-Clause
// The built program from outside: commands, run folder, threads, interrupts, vector units.
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include "run_folder/history.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sched.h>

namespace berm::commands::this_file {
namespace {

using Words = std::vector<std::string>;
using Json = nlohmann::json;

/// A folder with the small case as small.toml.
struct Place {
  TemporaryFolder folder;

  Place() { folder.write("small.toml", test::small_case); }
  Ended berm(const Words& arguments, const Words& environment = {}) const { return run_program(folder.path(), arguments, environment); }
  std::string text(const std::string& file) const { return text_of_file(folder / file); }
  Json json(const std::string& file) const { return Json::parse(text(file)); }
};

TEST(Program, tells_its_version_and_its_parameters)
{
  const Place place;
  const Ended version = place.berm({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out.find("berm "), 0u) << version.out;
  const Ended params = place.berm({"params"});
  EXPECT_EQ(params.status, 0);
  for (const char* key : {"friction_angle", "near_size", "gap_closing_steps", "volumetric_projection"})
    EXPECT_NE(params.out.find(key), std::string::npos) << key;
  const Ended markdown = place.berm({"params", "--markdown"});
  EXPECT_EQ(markdown.status, 0);
  EXPECT_EQ(markdown.out, text_of_file(std::filesystem::path(BERM_SOURCE_DIR) / "docs/parameters.md"))
      << "docs/parameters.md is out of date";
  EXPECT_EQ(place.berm({"--help"}).status, 0);
}

TEST(Check, tells_what_a_run_would_take_and_writes_nothing)
{
  const Place place;
  const Ended ended = place.berm({"check", "small.toml", "--threads", "1"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  for (const char* part : {"cells        900", "2700 in body \"sand\"", "time step", "steps        about", "with 1 thread "})
    EXPECT_NE(ended.out.find(part), std::string::npos) << part << " is not in\n" << ended.out;
  EXPECT_EQ(names_in(place.folder.path()), Words{"small.toml"});
}

TEST(Run, fills_its_folder_with_all_that_the_manual_names)
{
  const Place place;
  const Ended ended = place.berm({"run", "small.toml", "--threads", "1"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(names_in(place.folder.path()), (Words{"out/", "small.toml"}));
  EXPECT_EQ(names_in(place.folder / "out"), Words{"small/"});
  const Words files = names_in(place.folder / "out/small");
  for (const char* name : {"case.toml", "resolved.toml", "history.csv", "summary.json", "run.log", "frames/"})
    EXPECT_EQ(std::count(files.begin(), files.end(), name), 1) << name;
  EXPECT_EQ(place.text("out/small/case.toml"), test::small_case);
  const Words frames = names_in(place.folder / "out/small/frames");
  for (const char* name : {"frames.pvd", "mesh.vtu", "particles_0000.vtu", "rigid_0000.vtu"})
    EXPECT_EQ(std::count(frames.begin(), frames.end(), name), 1) << name;
  for (const std::string& name : files) EXPECT_EQ(name.find(".part"), std::string::npos) << "a file was left half written: " << name;
}

TEST(Run, prints_its_key_results_and_keeps_progress_apart)
{
  const Place place;
  const Ended ended = place.berm({"run", "small.toml", "--threads", "1"});
  EXPECT_EQ(ended.out.find("key results\n"), 0u) << ended.out;
  EXPECT_NE(ended.out.find("V_end_of_push"), std::string::npos) << ended.out;
  EXPECT_EQ(ended.err.find("V_end_of_push"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("everything is in out/small"), std::string::npos) << ended.err;
  EXPECT_NE(place.text("out/small/run.log").find("V_end_of_push"), std::string::npos);
}

TEST(Run, of_cases_that_have_one_name_in_two_folders_goes_to_two_folders)
{
  const Place place;
  for (const char* folder : {"one", "two"}) {
    std::filesystem::create_directory(place.folder / folder);
    place.folder.write(std::string(folder) + "/small.toml", test::small_case);
    ASSERT_EQ(place.berm({"run", std::string(folder) + "/small.toml", "--threads", "1"}).status, 0);
    EXPECT_TRUE(std::filesystem::exists(place.folder / "out" / folder / "small/summary.json"));
  }
}

TEST(Program, names_the_nearest_command_and_option)
{
  const Place place;
  const std::pair<Words, const char*> wrong[] = {
      {{"runn", "small.toml"}, "berm: unknown command \"runn\"; did you mean \"run\"?"},
      {{"run", "small.toml", "--thread", "2"}, "berm: unknown option \"--thread\"; did you mean \"--threads\"?"},
      {{"run", "small.toml", "--threads", "two"}, "berm: --threads: "},
      {{}, "berm: a command is needed"}};
  for (const auto& [words, says] : wrong) {
    const Ended ended = place.berm(words);
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.err.find(says), 0u) << ended.err;
  }
  const Ended help = place.berm({"help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.out, place.berm({"--help"}).out);
}

TEST(Run, history_has_the_promised_columns_and_a_row_for_each_interval_and_stage)
{
  const Place place;
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1"}).status, 0);
  std::istringstream history(place.text("out/small/history.csv"));
  std::string line;
  std::getline(history, line);
  EXPECT_EQ(line.find("time_s,stage,u_m,w_m,H_N_m,V_N_m,kinetic_J_m,"), 0u) << line;
  for (const char* column : {",gap_m", ",overlap_m", ",second_impulse_N_m", ",M_Nm_m", ",angle_rad"})
    EXPECT_NE(line.find(column), std::string::npos) << column;
  const auto columns = std::count(line.begin(), line.end(), ',');
  double last = -1;
  std::string stage, stages;
  int rows = 0;
  for (; std::getline(history, line); ++rows) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
    const double time = std::stod(line);
    EXPECT_GT(time, last);
    EXPECT_LT(time - last, last < 0 ? 2 : 0.05e-3 + 2 * 15e-6);  // the interval and a step of 15 us on either side
    last = time;
    const std::string name = line.substr(line.find(',') + 1, line.find(',', line.find(',') + 1) - line.find(',') - 1);
    if (name != stage) stages += name + " ";
    stage = name;
  }
  EXPECT_EQ(stages, "rest push drag ");
  EXPECT_GT(rows, 90);
}

TEST(Run, history_has_extents_and_angular_momentum_of_a_body_and_motion_and_stress_at_a_watched_point)
{
  const Place place;
  place.folder.write("small.toml", test::small_case + "[watch.deep]\nbody = \"sand\"\npoint = [0.0006, 0.0006]\n"
                                                      "[[body.sand.initial_velocity]]\namplitude = [0.1, -0.2]\n");
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1"}).status, 0);
  const run_folder::History history = run_folder::read_history(place.folder / "out/small/history.csv");
  const auto first = [&](const char* column) { return history[column].at(0); };
  // Particles are 4/3 mm apart in 120 mm x 40 mm.
  constexpr Real half = 0.0006666667, digits = 1e-9;
  EXPECT_NEAR(first("sand_xmin_m"), half, digits);
  EXPECT_NEAR(first("sand_xmax_m"), 0.12 - half, digits);
  EXPECT_NEAR(first("sand_ymin_m"), half, digits);
  EXPECT_NEAR(first("sand_ymax_m"), 0.04 - half, digits);
  EXPECT_NEAR(first("sand_Lz_N_s"), 0, digits);
  EXPECT_NEAR(first("deep_vx_m_s"), 0.1, digits);
  EXPECT_NEAR(first("deep_vy_m_s"), -0.2, digits);
  // The weight of the sand above the point, and K0 of it sideways.
  const Real vertical = -877 * 50 * standard_gravity * (0.04 - 0.0006);
  EXPECT_NEAR(first("deep_syy_Pa") / vertical, 1, 1e-6);
  EXPECT_NEAR(first("deep_sxx_Pa") / vertical, 0.43, 1e-6);
  EXPECT_NEAR(first("deep_szz_Pa") / vertical, 0.43, 1e-6);
  EXPECT_EQ(first("deep_sxy_Pa"), 0);
}

TEST(Run, summary_has_the_promised_form)
{
  const Place place;
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1", "-o", "results"}).status, 0);
  const Json summary = place.json("results/summary.json");
  const std::string answer = summary["text"]["answer"];  // the report's sentences, without its tags
  EXPECT_TRUE(answer.find("V = ") != std::string::npos && answer.find('<') == std::string::npos) << answer;
  EXPECT_TRUE(summary["quantities"].contains(std::string(summary["text"]["key_number"]))) << summary["text"];
  for (const char* name : {"V_at_w_0.1D", "V_at_w_0.1D_over_gammaD2", "H_at_u_0.1D"}) {
    ASSERT_TRUE(summary["quantities"].contains(name)) << name;
    EXPECT_TRUE(summary["quantities"][name]["value"].is_number());
    EXPECT_TRUE(summary["quantities"][name]["unit"].is_string());
  }
  EXPECT_EQ(summary["quantities"]["V_at_w_0.1D"]["unit"], "N/m");
  const double scale = 877 * 50 * 9.80665 * 0.02 * 0.02;
  EXPECT_NEAR(summary["quantities"]["V_at_w_0.1D_over_gammaD2"]["value"].get<double>() * scale,
              summary["quantities"]["V_at_w_0.1D"]["value"].get<double>(), 1e-9);
  EXPECT_NE(summary["text"]["machine"].get<std::string>().find("processor"), std::string::npos) << summary["text"];
  EXPECT_EQ(summary["text"]["date"].get<std::string>().size(), std::string("2026-01-31T12:00:00Z").size()) << summary["text"];
  for (const char* name : {"particle_steps_per_s", "wall_s", "processors_s", "steps_s", "rows_s", "frames_s", "checkpoints_s", "beside_s"})
    EXPECT_GT(summary["timing"][name].get<double>(), 0) << name;
  const double parts = summary["timing"]["steps_s"].get<double>() + summary["timing"]["rows_s"].get<double>() +
                       summary["timing"]["frames_s"].get<double>() + summary["timing"]["checkpoints_s"].get<double>();
  EXPECT_LE(parts, summary["timing"]["wall_s"].get<double>()) << "no time is in two parts";
  EXPECT_EQ(summary["timing"]["threads"], 1);
  EXPECT_EQ(summary["timing"]["particles"], 2700);
  EXPECT_EQ(summary["checks"]["finished"], true);
  EXPECT_LT(summary["checks"]["momentum_error"].get<double>(), 1e-12);
}

TEST(Run, writes_the_same_history_and_frames_byte_for_byte_with_one_and_two_threads)
{
  const Place place;
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1", "-o", "one"}).status, 0);
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "2", "-o", "two"}, {"OMP_WAIT_POLICY=passive"}).status, 0);
  EXPECT_EQ(place.json("two/summary.json")["timing"]["threads"], 2);
  EXPECT_GT(place.text("one/history.csv").size(), 1000u);
  EXPECT_TRUE(place.text("one/history.csv") == place.text("two/history.csv"));
  int frames = 0;
  for (const auto& file : std::filesystem::directory_iterator(place.folder / "one/frames")) {
    const std::string name = "/frames/" + file.path().filename().string();
    EXPECT_TRUE(place.text("one" + name) == place.text("two" + name)) << name;
    ++frames;
  }
  EXPECT_GT(frames, 6);
}

TEST(Run, has_all_processors_also_where_the_environment_binds_threads)
{
  const Place place;
  const auto threads = [&](const Words& environment) {
    EXPECT_EQ(place.berm({"run", "small.toml", "--force", "-o", "all"}, environment).status, 0);
    return place.json("all/summary.json")["timing"]["threads"];
  };
  const Json all = threads({});
  EXPECT_EQ(threads({"OMP_PROC_BIND=true"}), all);
  EXPECT_EQ(threads({"OMP_PROC_BIND=close", "OMP_PLACES=threads", "OMP_WAIT_POLICY=passive"}), all);
  cpu_set_t allowed;
  ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
  int first = 0;
  while (!CPU_ISSET(first, &allowed)) ++first;
  EXPECT_EQ(threads({"OMP_PLACES={" + std::to_string(first) + "}"}), 1) << "those that the places name, no others";
}

TEST(Run, of_resolved_toml_writes_the_same_history_byte_for_byte)
{
  const Place place;
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1", "-o", "one", "--set", "material.sand.friction_angle=30 deg"}).status, 0);
  ASSERT_EQ(place.berm({"run", "one/resolved.toml", "--threads", "1", "-o", "two"}).status, 0);
  EXPECT_GT(place.text("one/history.csv").size(), 1000u);
  EXPECT_TRUE(place.text("one/history.csv") == place.text("two/history.csv"));
  EXPECT_EQ(place.text("one/resolved.toml"), place.text("two/resolved.toml"));
}

TEST(Run, with_a_report_table_writes_the_same_history_and_notes_where_it_comes_from)
{
  const Place place;
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1", "-o", "one"}).status, 0);
  place.folder.write("signed.toml", test::small_case + "\n[report]\nproject = \"P\"\nchecker = \"C\"\nnote = \"checked\"\n");
  const Ended ended = place.berm({"run", "signed.toml", "--threads", "1", "-o", "two"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_GT(place.text("one/history.csv").size(), 1000u);
  EXPECT_TRUE(place.text("one/history.csv") == place.text("two/history.csv"));
  EXPECT_TRUE(place.text("one/frames/particles_0001.vtu") == place.text("two/frames/particles_0001.vtu"));
  const Json one = place.json("one/origin.json"), two = place.json("two/origin.json");
  EXPECT_EQ(one["sessions"][0]["program_sha256"], two["sessions"][0]["program_sha256"]);
  EXPECT_NE(one["input_sha256"]["case.toml"], two["input_sha256"]["case.toml"]);
}

TEST(Run, takes_an_override)
{
  const Place place;
  const Words shorter = {"run",       "small.toml",
                         "--threads", "1",
                         "--set",     "stage.push.until.embedment=1 mm",
                         "--set",     "stage.drag.until.displacement=0.1 mm",
                         "--set",     "mpm.courant=0.5"};
  ASSERT_EQ(place.berm(shorter).status, 0);
  EXPECT_NEAR(place.json("out/small/summary.json")["quantities"]["w_end_of_push"]["value"].get<double>(), 1e-3, 15e-6);
}

TEST(Run, of_several_cases_fills_folders_named_like_their_files)
{
  const Place place;
  place.folder.write("other.toml", test::small_case);
  ASSERT_EQ(place.berm({"run", "small.toml", "other.toml", "--threads", "1", "-o", "results"}).status, 0);
  EXPECT_EQ(names_in(place.folder.path()), (Words{"other.toml", "results/", "small.toml"}));
  EXPECT_EQ(names_in(place.folder / "results"), (Words{"other/", "small/"}));
  EXPECT_TRUE(place.text("results/other/history.csv") == place.text("results/small/history.csv"));
}

TEST(Run, into_the_folder_of_an_earlier_run_is_refused_and_replaces_it_by_force)
{
  const Place place;
  Words arguments = {"run", "small.toml", "--threads", "1", "-o", "results"};
  ASSERT_EQ(place.berm(arguments).status, 0);
  const std::string first = place.text("results/history.csv"), log = place.text("results/run.log");
  const auto files = names_in(place.folder / "results");
  const Ended refused = place.berm(arguments);
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.err, "berm: results holds the results of a run: replace them with --force, or name another folder with -o\n");
  EXPECT_EQ(place.text("results/run.log"), log);
  arguments.emplace_back("--force");
  ASSERT_EQ(place.berm(arguments).status, 0);
  EXPECT_TRUE(place.text("results/history.csv") == first);
  EXPECT_EQ(names_in(place.folder / "results"), files);
}

TEST(Run, that_cannot_write_ends_with_status_1_and_the_reason)
{
  const Place place;
  place.folder.write("file", "");
  std::filesystem::create_directory(place.folder / "mine");
  place.folder.write("mine/notes.txt", "not of a run");
  const std::pair<const char*, const char*> refused[] = {{"file", "it is not a folder"},
                                                         {"file/inside", "Not a directory"},
                                                         {"/proc/berm", "No such file or directory"},
                                                         {"mine", "not of a run"}};
  for (const auto& [folder, reason] : refused) {
    const Ended ended = place.berm({"run", "small.toml", "--threads", "1", "-o", folder});
    EXPECT_EQ(ended.status, 1) << folder;
    EXPECT_EQ(ended.err.find(std::string("berm: cannot use ") + folder), 0u) << ended.err;
    EXPECT_NE(ended.err.find(reason), std::string::npos) << ended.err;
    EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << ended.err;
  }
  EXPECT_EQ(names_in(place.folder / "mine"), Words{"notes.txt"});
}

TEST(Run, that_fails_ends_with_status_1_and_says_where_when_and_what_to_do)
{
  // Without a base the soil falls out of the mesh.
  const Place place;
  std::string text = test::small_case;
  text.replace(text.find("boundary = \"bottom\"\nfixed = [\"x\", \"y\"]"), 38, "boundary = \"bottom\"\nfixed = [\"x\"]");
  place.folder.write("small.toml", text);
  const Ended ended = place.berm({"run", "small.toml", "--threads", "1", "-o", "results"});
  EXPECT_EQ(ended.status, 1);
  for (const char* part : {"berm: particle ", "body \"sand\"", "left the mesh at (", "t = ", "make the mesh larger"})
    EXPECT_NE(ended.err.find(part), std::string::npos) << part << " is not in: " << ended.err;
  EXPECT_NE(place.text("results/run.log").find("left the mesh"), std::string::npos);
}

TEST(Run, whose_answer_is_invalid_says_so_beside_its_numbers_and_with_strict_ends_with_status_1)
{
  const Place place;
  const Words run = {
      "run", "small.toml", "--threads", "1", "--set", "mpm.max_volume_ratio=1.0001", "--set", "material.sand.dilation_angle=0.26"};
  const Ended ended = place.berm(run);
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.err.find("berm: warning: the answer is invalid: soil at its largest volume"), std::string::npos) << ended.err;
  EXPECT_EQ(ended.out.find("key results; (!) the answer is invalid: soil at its largest volume"), 0u) << ended.out;
  std::istringstream lines(ended.out);
  for (std::string line; std::getline(lines, line) && !line.empty();) EXPECT_NE(line.find("(!)"), std::string::npos) << line;
  EXPECT_EQ(place.json("out/small/summary.json")["invalid"].size(), 1u);
  EXPECT_NE(place.text("out/small/run.log").find("the answer is invalid"), std::string::npos);
  Words strict = run;
  strict.insert(strict.end(), {"--strict", "--force"});
  const Ended failed = place.berm(strict);
  EXPECT_EQ(failed.status, 1);
  EXPECT_NE(failed.err.find("berm: out/small: the answer is invalid: "), std::string::npos) << failed.err;
  EXPECT_EQ(place.berm({"run", "small.toml", "--threads", "1", "--strict", "-o", "sound"}).status, 0);
  EXPECT_EQ(place.json("sound/summary.json")["invalid"].size(), 0u);
}

TEST(Run, of_a_bed_at_rest_is_not_made_invalid_by_what_is_left_of_its_stress)
{
  constexpr const char* bed = R"(
gravity = [0, -10]
[mesh]
kind = "box"
lower = [0, -2]
size = [1, 2]
cells = [5, 10]
[material.sand]
law = "mohr_coulomb"
density = 1000
young_modulus = 20e6
poisson_ratio = 0.3
friction_angle = 0.5236
[body.bed]
material = "sand"
regions = ["box"]
particles_per_cell = 4
k0 = 1
[support.left]
boundary = "left"
fixed = ["x"]
[support.right]
boundary = "right"
fixed = ["x"]
[support.base]
boundary = "bottom"
fixed = ["x", "y"]
[[stage]]
name = "rest"
kind = "geostatic"
damping = 0.7
)";
  const TemporaryFolder folder;
  folder.write("bed.toml", bed);
  const Ended ended = run_program(folder.path(), {"run", "bed.toml", "-o", "out", "--strict"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err.find("invalid"), std::string::npos) << "its work is 1 mJ, its elastic energy 8 J: " << ended.err;
}

TEST(Run, that_is_interrupted_keeps_whole_files_and_ends_with_status_75)
{
  for (const int signal : {SIGINT, SIGTERM}) {
    const Place place;
    Program program(place.folder.path(), {"run", "small.toml", "--threads", "1", "-o", "results", "--set", "stage.rest.until.time=100 s"});
    ASSERT_TRUE(wait_until([&] { return place.text("results/history.csv").size() > 2000; }));
    program.signal(signal);
    const Ended ended = program.wait();
    EXPECT_EQ(ended.status, 75);
    EXPECT_NE(ended.err.find("stopped at t = "), std::string::npos) << ended.err;
    EXPECT_EQ(place.json("results/summary.json")["checks"]["finished"], false);
    const std::string history = place.text("results/history.csv");
    ASSERT_EQ(history.back(), '\n');
    std::istringstream lines(history);
    std::string header, line;
    std::getline(lines, header);
    while (std::getline(lines, line))
      EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(header.begin(), header.end(), ',')) << line;
    for (const std::string& name : names_in(place.folder / "results")) EXPECT_EQ(name.find(".part"), std::string::npos) << name;
  }
}

TEST(Run, that_is_interrupted_leaves_the_cases_behind_it_alone)
{
  const Place place;
  place.folder.write("other.toml", test::small_case);
  Program program(place.folder.path(),
                  {"run", "small.toml", "other.toml", "--threads", "1", "-o", "results", "--set", "stage.rest.until.time=100 s"});
  ASSERT_TRUE(wait_until([&] { return place.text("results/small/history.csv").size() > 2000; }));
  program.signal(SIGINT);
  EXPECT_EQ(program.wait().status, 75);
  EXPECT_EQ(names_in(place.folder / "results"), Words{"small/"});
}

TEST(VectorUnits, the_engine_for_the_plainest_processor_finds_the_same_forces)
{
  const std::filesystem::path libraries = std::filesystem::path(BERM_PROGRAM).parent_path() / "lib";
  if (!exists(libraries / "libberm_engine.so") || !exists(libraries / "glibc-hwcaps"))
    GTEST_SKIP() << "the engine is built for one vector unit";
  const std::string plainest = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-AVX512F";
  const Place place;
  const Ended loaded = place.berm({"--version"}, {plainest, "LD_DEBUG=libs"});
  EXPECT_NE(loaded.err.find("lib/libberm_engine.so"), std::string::npos);
  EXPECT_EQ(loaded.err.find("calling init: " + (libraries / "glibc-hwcaps").string()), std::string::npos)
      << "another engine than the plainest was loaded";

  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1", "-o", "best"}).status, 0);
  ASSERT_EQ(place.berm({"run", "small.toml", "--threads", "1", "-o", "plainest"}, {plainest}).status, 0);
  const Json best = place.json("best/summary.json")["quantities"], other = place.json("plainest/summary.json")["quantities"];
  // Last bits differ, and yielding soil makes more of them: forces agree as far as an engineer can tell.
  for (const char* name : {"V_at_w_0.05D", "V_at_w_0.1D"})
    EXPECT_NEAR(other[name]["value"].get<double>() / best[name]["value"].get<double>(), 1, 0.05) << name;
}

}  // namespace
}  // namespace berm::commands::this_file
