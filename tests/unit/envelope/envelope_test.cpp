// SPDX-License-Identifier: BSD-3-Clause
#include "envelope/envelope_table.hpp"
#include "samples/clay_pipe.hpp"
#include "samples/history_columns.hpp"
#include "samples/program.hpp"
#include "samples/refused_probes.hpp"

#include <gtest/gtest.h>

namespace berm::envelope::this_file {
namespace {

using test::refusal_of;

TEST(EnvelopeProbes, go_down_then_ever_flatter_to_45_degrees_upwards_and_swipe)
{
  const std::vector<Probe> probes = choose_probes(clay(), {4, 0.1});
  ASSERT_EQ(probes.size(), 5u);
  const std::vector<Real> angles = {90, 45, 0, -45};
  for (std::size_t k = 0; k < angles.size(); ++k) EXPECT_EQ(probes[k].angle, angles[k]);
  EXPECT_EQ(probes[0].name, "down");
  EXPECT_EQ(probes[2].name, "direction_0");
  EXPECT_EQ(probes[4].kind, ProbeKind::swipe);
}

TEST(EnvelopeProbes, keep_the_stages_before_the_first_drive_and_take_its_speed_and_ramp)
{
  for (const Probe& probe : choose_probes(clay(), {4, 0.1})) {
    const std::vector<settings::StageSettings>& stages = probe.settings.stage;
    EXPECT_EQ(stages[0].name, "rest");
    ASSERT_EQ(stages.size(), probe.kind == ProbeKind::swipe ? 3u : 2u);
    for (std::size_t k = 1; k < stages.size(); ++k) {
      const settings::StageSettings& s = stages[k];
      EXPECT_NEAR(std::hypot(*s.velocity, s.vertical_velocity.value_or(0)), 0.1, 1e-15);
      EXPECT_EQ(s.ramp, 0.2);
      EXPECT_NEAR(*s.until.time, 1.1, 1e-15);  // 0.1 D at 0.1 m/s, and half the ramp
    }
    EXPECT_EQ(stages.back().name, probe.stage);
    if (probe.kind == ProbeKind::direction && probe.angle != 90) {
      EXPECT_NEAR(*stages[1].vertical_velocity / *stages[1].velocity, std::tan(probe.angle * pi / 180), 1e-12);
    }
  }
}

TEST(EnvelopeProbes, find_another_name_where_a_stage_has_theirs)
{
  const settings::Case c = clay({"stage.rest.name=probe"});
  EXPECT_EQ(choose_probes(c, {})[1].stage, "probe_probe");
}

TEST(EnvelopeProbes, are_refused_where_there_is_no_pipe_in_the_bed_or_no_speed)
{
  EXPECT_EQ(refusal_of(clay()), "");
  EXPECT_NE(refusal_of(clay({"rigid.pipe.center=[0, 0.6]"})).find("lies 0.1 m above the bed"), std::string::npos);
  EXPECT_NE(refusal_of(clay({"rigid.pipe.center=[-1.6, 0]"})).find("beyond a wall"), std::string::npos);
  settings::Case square = clay();
  square.rigid[0].second.shape = bodies::BoxSettings{{0, 0}, {1, 1}};
  EXPECT_NE(refusal_of(square).find("rigid.pipe.shape: an envelope is that of a pipe"), std::string::npos);
  settings::Case space = clay();
  space.geometry = settings::Geometry::space;
  space.rigid[0].second.shape = bodies::CircleSettings{{0, 0.1, 0}, 1};
  EXPECT_NE(refusal_of(space).find("plane_strain"), std::string::npos);
  settings::Case by_force = clay();
  by_force.stage[1].velocity.reset();
  EXPECT_NE(refusal_of(by_force).find("by velocity"), std::string::npos);
  by_force.stage.pop_back();
  EXPECT_NE(refusal_of(by_force).find("by velocity"), std::string::npos);
}

/// A probe of finite elements, and a history with one row of rest at (V, H) = (5, 0) and these rows of the probe.
Probe probe_of(ProbeKind kind, Real angle)
{
  Probe probe{"probe", kind, angle, {}, "probe"};
  probe.settings.method = settings::Method::fem;
  return probe;
}

run_folder::History history_of(const std::vector<Real>& u, const std::vector<Real>& w, const std::vector<Real>& V,
                               const std::vector<Real>& H)
{
  run_folder::History history;
  history.columns = columns_named({"u_m", "w_m", "V_N_m", "H_N_m", "overstress"});
  history.values = {u, w, V, H, std::vector<Real>(u.size(), 1e-7)};
  history.values[0].insert(history.values[0].begin(), 0);
  history.values[1].insert(history.values[1].begin(), 1);
  history.values[2].insert(history.values[2].begin(), 5);
  history.values[3].insert(history.values[3].begin(), 0);
  history.values[4].insert(history.values[4].begin(), 0);
  history.stage.assign(u.size() + 1, "probe");
  history.stage[0] = "rest";
  return history;
}

TEST(EnvelopeTable, takes_the_last_forces_of_a_probe_and_their_growth_along_its_motion)
{
  // Travel 4 m along 3:4; the resistance at 3/4 of it is 0.8 x 40 + 0.6 x 20 = 44, at the end 0.8 x 50 + 0.6 x 30 = 58.
  const Real angle = std::atan2(4., 3.) * 180 / pi;
  const run_folder::History history = history_of({0.6, 1.2, 1.8, 2.4}, {1.8, 2.6, 3.4, 4.2}, {10, 30, 40, 50}, {0, 10, 20, 30});
  const ProbeResult result = result_of(probe_of(ProbeKind::direction, angle), history, {1});
  EXPECT_EQ(result.end.V, 50);
  EXPECT_EQ(result.end.H, 30);
  EXPECT_EQ(result.end.w, 4.2);
  EXPECT_NEAR(result.growth, 1 - 44. / 58, 1e-12);
  EXPECT_EQ(result.overstress, 1e-7);
  EXPECT_TRUE(std::isnan(result.unbalance)) << "the history has no such column";
  EXPECT_TRUE(result.path.empty());
}

TEST(EnvelopeTable, keeps_the_whole_path_of_a_swipe_from_where_the_push_ended)
{
  const ProbeResult result = result_of(probe_of(ProbeKind::swipe, nan), history_of({1, 2, 3}, {1, 1, 1}, {4, 3, 2}, {1, 2, 3}), {1});
  ASSERT_EQ(result.path.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(result.path[k].V, 5 - static_cast<Real>(k));
    EXPECT_EQ(result.path[k].H, static_cast<Real>(k));
  }
}

EnvelopeRow row_of(Real angle, Real V, Real H)
{
  EnvelopeRow row{probe_of(ProbeKind::direction, angle), "finished", {}};
  row.result.end = {V, H, 0.5};
  return row;
}

TEST(EnvelopeTable, scales_by_the_probe_that_goes_down_and_by_the_largest_H)
{
  EnvelopeRow failed = row_of(20, 0, 0);
  failed.state = "failed";
  failed.result = {};
  const std::string csv = envelope_csv({row_of(90, 8, 1), failed, row_of(0, 4, 2)});
  EXPECT_EQ(csv, "probe,kind,angle_deg,V_N_m,H_N_m,V_over_Vmax,H_over_Hmax,w_m,growth,unbalance,overstress,state\n"
                 "probe,direction,90,8,1,1,0.5,0.5,,,,finished\n"
                 "probe,direction,20,,,,,,,,,failed\n"
                 "probe,direction,0,4,2,0.5,1,0.5,,,,finished\n");
}

TEST(EnvelopeTable, takes_the_largest_H_from_the_path_of_a_swipe_too)
{
  EnvelopeRow swipe = row_of(nan, 1, 2);
  swipe.result.path = {{4, 1, 0.5}, {3, 5, 0.5}, {1, 2, 0.5}};
  const EnvelopeExtremes extremes = extremes_of({row_of(90, 8, 1), row_of(0, 4, 3), swipe});
  EXPECT_EQ(extremes.V_max, 8);
  EXPECT_EQ(extremes.H_max, 5);
  EXPECT_EQ(extremes.V_at_H_max, 3);
}

class EnvelopeCommand : public testing::Test {
protected:
  void SetUp() override { folder_.write("clay.toml", coarse_clay); }
  Ended envelope(std::vector<std::string> words) const
  {
    words.insert(words.begin(), "envelope");
    return run_program(folder_.path(), words, {with_pictures()});
  }
  TemporaryFolder folder_;
};

TEST_F(EnvelopeCommand, finds_the_loads_of_a_smooth_pipe_in_clay_and_runs_nothing_twice)
{
  const std::vector<std::string> words = {"clay.toml", "-o", "found", "--points", "2", "--threads", "2"};
  const Ended ended = envelope(words);
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(names_in(folder_ / "found/runs"),
            (std::vector<std::string>{"direction_-45.toml", "direction_-45/", "down.toml", "down/", "swipe.toml", "swipe/"}));
  const std::string csv = text_of_file(folder_ / "found/envelope.csv");
  const auto number = [&](const std::string& after) { return std::stod(csv.substr(csv.find(after) + after.size())); };
  // Slip lines give 39.5 kN/m; elements of D/10 carry up to 10 % more, and never less.
  EXPECT_NEAR(number("\ndown,direction,90,"), 41.5e3, 2e3) << csv;
  EXPECT_NE(csv.find("\nswipe,path,"), std::string::npos);
  for (const char* file : {"summary.json", "envelope.png"}) EXPECT_TRUE(std::filesystem::exists(folder_ / "found" / file)) << file;
  EXPECT_NE(ended.out.find("Merifield"), std::string::npos) << ended.out;

  const Ended again = envelope(words);
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.err.find("3 of 3 probes have their result already"), std::string::npos) << again.err;
  EXPECT_EQ(text_of_file(folder_ / "found/envelope.csv"), csv);
}

TEST_F(EnvelopeCommand, goes_on_where_a_signal_stopped_it)
{
  const std::vector<std::string> words = {"envelope", "clay.toml", "-o", "found", "--points", "4", "--threads", "1"};
  Program program(folder_.path(), words);
  EXPECT_TRUE(wait_until([&] { return std::filesystem::exists(folder_ / "found/runs/down/summary.json"); }));
  program.signal(SIGINT);
  const Ended stopped = program.wait();
  EXPECT_EQ(stopped.status, 75);
  EXPECT_NE(stopped.out.find("\nof the probes that are done: Vmax "), std::string::npos) << stopped.out;
  EXPECT_NE(stopped.err.find("the same command continues from there"), std::string::npos) << stopped.err;
  EXPECT_NE(text_of_file(folder_ / "found/envelope.csv").find(",interrupted\n"), std::string::npos);
  EXPECT_EQ(run_program(folder_.path(), words).status, 0);
  EXPECT_EQ(text_of_file(folder_ / "found/envelope.csv").find(",interrupted\n"), std::string::npos);
}

TEST_F(EnvelopeCommand, that_is_queued_says_that_nothing_is_known_yet)
{
  const Ended queued = envelope({"clay.toml", "-o", "found", "--points", "2", "--no-wait", "--runner", "cp {jobs} later"});
  EXPECT_EQ(queued.status, 75) << queued.err;
  EXPECT_EQ(queued.out.find("nan"), std::string::npos) << queued.out;
  EXPECT_NE(queued.out.find("Vmax and Hmax are not known before the probes that look for them are done\n"), std::string::npos)
      << queued.out;
}

TEST_F(EnvelopeCommand, refuses_what_is_no_pipe_in_a_bed_with_one_line_and_writes_nothing)
{
  const auto before = names_in(folder_.path());
  for (const char* set : {"rigid.pipe.center=[0, 0.6]", "support.left.boundary=west"}) {
    const Ended ended = envelope({"clay.toml", "-o", "found", "--set", set});
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << ended.err;
    EXPECT_EQ(names_in(folder_.path()), before);
  }
  // What is found only where the first probe is built has a place, too.
  std::string text = coarse_clay;
  text.replace(text.find("near_left = "), 12, "near_left = 9 # ");
  folder_.write("clay.toml", text);
  const Ended built = envelope({"clay.toml", "-o", "found"});
  EXPECT_EQ(built.status, 2);
  EXPECT_EQ(built.err.find("berm: clay.toml:"), 0u) << built.err;
}

}  // namespace
}  // namespace berm::envelope::this_file
