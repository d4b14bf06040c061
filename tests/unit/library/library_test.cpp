// SPDX-License-Identifier: BSD-3-Clause
// berm as a library, by nothing but its public header.
#include "samples/error_of.hpp"
#include "samples/program.hpp"
#include "samples/small_cases.hpp"

#include <berm/berm.hpp>

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

using OneRun = Run;  // the fixture has a Run of its own

class Library : public testing::Test {
protected:
  Library()
  {
    folder_.write("case.toml", test::small_case);
    folder_.write("fem.toml", test::small_fem_case);
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  RunOptions into(const std::string& name) const
  {
    RunOptions options;
    options.folder = path(name);
    return options;
  }
  void expect_same_run(const std::string& one, const std::string& other) const
  {
    EXPECT_FALSE(folder_.read(one + "/history.csv").empty());
    EXPECT_TRUE(folder_.read(one + "/history.csv") == folder_.read(other + "/history.csv"));
    const auto frames = names_in(folder_ / (one + "/frames"));
    EXPECT_EQ(frames, names_in(folder_ / (other + "/frames")));
    for (const std::string& name : frames)
      EXPECT_TRUE(folder_.read(one + "/frames/" + name) == folder_.read(other + "/frames/" + name)) << name;
  }

  TemporaryFolder folder_;
};

/// The number of a block, component and lane.
template <class Number = double>
Number number(const ParticleField& field, std::size_t block, std::size_t component, std::size_t lane)
{
  Number found;
  std::memcpy(&found,
              static_cast<const char*>(field.data) + block * field.block_stride + component * field.component_stride + lane * sizeof found,
              sizeof found);
  return found;
}

const ParticleField& field_of(const std::vector<ParticleField>& fields, const std::string& name)
{
  for (const ParticleField& field : fields)
    if (field.name == name) return field;
  throw std::out_of_range(name);
}

double mass_of(const std::vector<ParticleField>& fields)
{
  const ParticleField& mass = field_of(fields, "mass");
  double sum = 0;
  for (std::size_t b = 0; b < mass.blocks; ++b)
    for (std::size_t lane = 0; lane < mass.lanes; ++lane) sum += number(mass, b, 0, lane);
  return sum;
}

TEST_F(Library, steps_both_methods_to_the_bytes_of_the_program)
{
  for (const std::string name : {"case", "fem"}) {
    ASSERT_EQ(run_program(folder_.path(), {"run", name + ".toml", "-o", name + "_program", "--threads", "1"}).status, 0);
    OneRun run(path(name + ".toml"), into(name + "_library"));
    while (run.step()) {
    }
    EXPECT_TRUE(run.finished());
    expect_same_run(name + "_program", name + "_library");
    EXPECT_TRUE(std::filesystem::exists(folder_ / (name + "_library/summary.json")));
  }
}

TEST_F(Library, gives_each_row_of_the_history_as_the_file_has_it)
{
  OneRun run(path("case.toml"), into("run"));
  std::string text = "time_s,stage";
  ASSERT_EQ(run.columns().at(0).name, "time_s");
  for (std::size_t k = 1; k < run.columns().size(); ++k) text += "," + run.columns()[k].name;
  int rows = 0;
  double last_time = -1;
  do {
    EXPECT_EQ(run.row().size(), run.columns().size());
    EXPECT_GT(run.row()[0], last_time);
    last_time = run.row()[0];
    ++rows;
  } while (run.step_to_row());
  const std::string history = folder_.read("run/history.csv");
  EXPECT_EQ(history.substr(0, history.find('\n')), text);
  EXPECT_EQ(std::count(history.begin(), history.end(), '\n'), rows + 2)
      << "the header, and the row of the last step, after which nothing goes on";
}

TEST_F(Library, shows_particles_where_they_lie)
{
  OneRun run(path("case.toml"));
  ASSERT_EQ(run.bodies(), std::vector<std::string>{"sand"});
  const std::vector<ParticleField> before = run.particles("sand");
  const ParticleField& position = field_of(before, "position");
  EXPECT_EQ(position.components, 2U);
  EXPECT_EQ(field_of(before, "stress").components, 4U);
  EXPECT_EQ(field_of(before, "stress").unit, "Pa");
  EXPECT_TRUE(field_of(before, "id").is_integer);
  const double mass = mass_of(before);
  EXPECT_NEAR(mass, 0.12 * 0.04 * 877, 1e-9 * mass) << "volume times density";
  run.step(200);
  const std::vector<ParticleField> after = run.particles("sand");
  EXPECT_EQ(field_of(after, "position").data, position.data);
  EXPECT_NEAR(mass_of(after), mass, 1e-12 * mass);
  // A particle moved since its memory was asked for, and the view from before the steps shows it.
  double fastest = 0;
  const ParticleField& velocity = field_of(before, "velocity");
  for (std::size_t b = 0; b < velocity.blocks; ++b)
    for (std::size_t lane = 0; lane < velocity.lanes; ++lane) fastest = std::max(fastest, std::abs(number(velocity, b, 1, lane)));
  EXPECT_GT(fastest, 0);
  EXPECT_NE(test::error_of<InputError>([&] { run.particles("snad"); }).find("no body \"snad\""), std::string::npos);
}

TEST_F(Library, shows_rigid_bodies_as_the_history_has_them)
{
  OneRun run(path("case.toml"));
  run.step(100);
  while (run.stage() != "drag") run.step_to_row();
  run.step_to_row();
  ASSERT_EQ(run.rigid_bodies().size(), 1U);
  const RigidBodyNow pipe = run.rigid_bodies()[0];
  EXPECT_EQ(pipe.name, "pipe");
  const auto value = [&](const std::string& name) {
    for (std::size_t k = 0; k < run.columns().size(); ++k)
      if (run.columns()[k].name == name) return run.row()[k];
    throw std::out_of_range(name);
  };
  EXPECT_EQ(value("time_s"), run.time());
  EXPECT_EQ(value("u_m"), pipe.displacement[0]);
  EXPECT_NEAR(pipe.centre[0], 0.05 + pipe.displacement[0], 1e-15);
  EXPECT_GT(pipe.force[1], 0) << "the soil carries the pipe";
}

TEST_F(Library, keeps_nothing_without_a_folder)
{
  const auto before = names_in(folder_.path());
  OneRun run(path("case.toml"));
  run.step(10);
  EXPECT_FALSE(run.ended());
  EXPECT_EQ(run.steps(), 10);
  run.finish();
  EXPECT_TRUE(run.finished());
  EXPECT_EQ(names_in(folder_.path()), before);
}

TEST_F(Library, resumes_a_run_that_was_stopped_to_the_same_bytes)
{
  OneRun(path("case.toml"), into("whole")).finish();
  {
    OneRun run(path("case.toml"), into("parts"));
    run.step(150);
    run.stop();
    EXPECT_TRUE(run.ended());
    EXPECT_FALSE(run.finished());
    EXPECT_FALSE(run.step()) << "nothing is left to do";
  }
  EXPECT_NE(test::error_of<InputError>([&] { OneRun(path("case.toml"), into("parts")); }).find("holds a run"), std::string::npos);
  OneRun run = OneRun::resume(path("parts"));
  EXPECT_GE(run.steps(), 150);
  run.finish();
  EXPECT_TRUE(run.finished());
  expect_same_run("whole", "parts");
  EXPECT_NE(test::error_of<InputError>([&] { OneRun::resume(path("parts")); }).find("is finished"), std::string::npos);
}

/// E = 7 MPa and nu = 0.25 as a law of the program's own, which counts its calls.
int elastic(berm_law_increment* increment, int* calls)
{
  ++*calls;
  const double g = 7e6 / 2.5, lambda = 7e6 * 0.25 / (1.25 * 0.5);
  const double volume = increment->strain[0] + increment->strain[1] + increment->strain[2];
  for (int k = 0; k < 6; ++k) increment->stress[k] += k < 3 ? lambda * volume + 2 * g * increment->strain[k] : g * increment->strain[k];
  return berm_law_done;
}

std::string case_with_law()
{
  std::string text = test::small_case;
  const std::string sand = "law = \"mohr_coulomb\"", angle = "friction_angle = \"35 deg\"\n";
  text.replace(text.find(sand), sand.size(), "law = \"user\"\nlibrary = \"none.so\"\ncan_yield = false");
  text.replace(text.find(angle), angle.size(), "");
  return text;
}

TEST_F(Library, calls_a_law_of_the_program_in_place_of_the_library_that_the_case_names)
{
  std::string of_berm = test::small_case;
  const std::string sand = "law = \"mohr_coulomb\"", angle = "friction_angle = \"35 deg\"\n";
  of_berm.replace(of_berm.find(sand), sand.size(), "law = \"linear_elastic\"");
  of_berm.replace(of_berm.find(angle), angle.size(), "");
  folder_.write("own.toml", case_with_law());
  folder_.write("elastic.toml", of_berm);
  int calls = 0;
  RunOptions options;
  options.laws["sand"] = [&](berm_law_increment* increment) { return elastic(increment, &calls); };
  {
    OneRun run(path("own.toml"), options);
    const int at_start = calls;
    run.step(50);
    EXPECT_GT(calls - at_start, 50 * 1000) << "a call for each particle and step";
    const double own = run.rigid_bodies()[0].force[1];
    EXPECT_TRUE(std::isfinite(own));
  }
  const auto row_after_steps = [&](const std::string& name, const RunOptions& with) {
    OneRun run(path(name), with);
    while (run.stage() != "drag") run.step_to_row();
    return run.row();
  };
  const std::vector<double> own = row_after_steps("own.toml", options), built_in = row_after_steps("elastic.toml", {});
  ASSERT_EQ(own.size(), built_in.size());
  EXPECT_NEAR(own[4], built_in[4], 1e-6 * std::abs(built_in[4])) << "the same law in other operations: round-off in some hundred steps";
}

TEST_F(Library, refuses_laws_that_nothing_asks_for_and_tells_of_those_that_fail)
{
  folder_.write("own.toml", case_with_law());
  RunOptions options;
  options.laws["clay"] = [](berm_law_increment*) { return int(berm_law_done); };
  EXPECT_NE(test::error_of<InputError>([&] { OneRun(path("own.toml"), options); }).find("material.clay"), std::string::npos);
  options.laws.clear();
  EXPECT_NE(test::error_of<InputError>([&] { OneRun(path("own.toml"), options); }).find("none.so"), std::string::npos)
      << "the library of the case is missing";
  int calls = 0;
  options.laws["sand"] = [&](berm_law_increment* increment) { return calls > 20000 ? int(berm_law_failed) : elastic(increment, &calls); };
  OneRun run(path("own.toml"), options);
  EXPECT_NE(test::error_of<RunError>([&] { run.finish(); }).find("reports failure"), std::string::npos);
  EXPECT_TRUE(run.ended());
  EXPECT_FALSE(run.finished());
}

TEST_F(Library, says_what_is_wrong_with_a_case)
{
  std::string text = test::small_case;
  text.replace(text.find("young_modulus"), 13, "young_modulos");
  folder_.write("wrong.toml", text);
  const std::string error = test::error_of<InputError>([&] { OneRun(path("wrong.toml")); });
  EXPECT_NE(error.find("wrong.toml:14"), std::string::npos) << error;
  EXPECT_NE(error.find("young_modulus"), std::string::npos) << error;
  RunOptions options;
  options.set = {"stage.drag.velocity=-"};
  EXPECT_FALSE(test::error_of<InputError>([&] { OneRun(path("case.toml"), options); }).empty());
  for (const int threads : {-1, 1025}) {
    RunOptions wrong;
    wrong.threads = threads;
    EXPECT_NE(test::error_of<InputError>([&] { OneRun(path("case.toml"), wrong); }).find("threads: " + std::to_string(threads)),
              std::string::npos);
  }
  OneRun run(path("case.toml"));
  EXPECT_FALSE(test::error_of<InputError>([&] { run.step(-1); }).empty());
}

TEST_F(Library, hands_messages_to_the_program)
{
  std::vector<std::string> messages;
  RunOptions options;
  options.message = [&](const std::string& line) { messages.push_back(line); };
  OneRun(path("case.toml"), options).finish();
  EXPECT_TRUE(std::any_of(messages.begin(), messages.end(),
                          [](const std::string& line) { return line.find("particles, 1 thread") != std::string::npos; }));
}

}  // namespace
}  // namespace berm::this_file
