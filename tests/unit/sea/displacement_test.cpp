// SPDX-License-Identifier: BSD-3-Clause
#include "sea/displacement.hpp"

#include "os/error.hpp"
#include "sample_sea.hpp"
#include "samples/macro_element_parameters.hpp"
#include "samples/temporary_folder.hpp"
#include "sea/displacement_report.hpp"

#include <gtest/gtest.h>

namespace berm::sea::this_file {
namespace {

/// A cable on soft soil, in two seeds of ten minutes.
SeaCase on_soil()
{
  SeaCase c = sample_sea();
  c.sea.duration = 600;
  c.record.seeds = 2;
  c.soil = Soil{.macro_element = "made", .laying_force = {}, .runs = {}};
  c.macro_element = macro_element::sample_parameters();
  c.macro_element->diameter = c.pipe.diameter;
  c.macro_element->backbone_factor = 2500, c.macro_element->peak_ratio = 0.12;
  return c;
}

TEST(LoadHistory, has_the_largest_waves_one_after_the_other_between_ramps)
{
  const SeaCase c = sample_sea();
  LoadRecord record;
  record.step = 0.5;
  for (int row = 0; row < 10; ++row) record.velocity.push_back(row), record.H.push_back(10 * row), record.V.push_back(100 + row);
  const std::vector<WaveRow> rows = load_history_of(c, record, {{1, 3, 0, 0}, {6, 7, 0, 0}});
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0].velocity, 0);
  EXPECT_EQ(rows[0].V, 400);
  EXPECT_NEAR(rows[1].time, 5, 1e-12) << "half a period of 10 s";
  EXPECT_EQ(rows[1].velocity, 1);
  EXPECT_EQ(rows[3].velocity, 6);
  EXPECT_EQ(rows[3].H, 60);
  EXPECT_NEAR(rows[3].time, 6, 1e-12);
  EXPECT_EQ(rows[4].velocity, 0);
}

TEST(Displacements, are_of_each_seed_and_of_its_largest_waves)
{
  const SeaCase c = on_soil();
  const SeaAnswer a = answer_of(c);
  const Displacements moved = displacements_of(c, a).value();
  ASSERT_EQ(moved.seeds.size(), 2u);
  ASSERT_EQ(moved.waves.size(), 2u);
  EXPECT_EQ(moved.seeds[0].u.size(), a.records[0].velocity.size());
  EXPECT_NE(numbers_of(moved.seeds[0], 0.25).largest, numbers_of(moved.seeds[1], 0.25).largest);
  SeaCase heavy = c;
  heavy.pipe.weight = 8000;
  heavy.macro_element->backbone_factor = 50e3, heavy.macro_element->peak_ratio = 0.5;
  EXPECT_LT(numbers_of(displacements_of(heavy, answer_of(heavy))->seeds[0], 0.25).largest, 0.02 * numbers_of(moved.seeds[0], 0.25).largest);
  EXPECT_FALSE(displacements_of(sample_sea(), answer_of(sample_sea()))) << "no soil, no displacement";
}

TEST(Displacements, have_numbers_of_all_seeds)
{
  SeaCase c = on_soil();
  Displacements moved;
  moved.seeds = {{{0, 1}, {0, 0.1}, {0.01, 0.03}}, {{0, 1}, {0.2, -0.1}, {0.01, 0.05}}};
  moved.waves = {{{0, 1}, {0, 0.07}, {0.01, 0.02}}, {{0, 1}, {0, 0.08}, {0.01, 0.02}}};
  const MovedPipe n = moved_pipe(c, moved);
  EXPECT_NEAR(n.largest.mean, 0.2, 1e-12);
  EXPECT_NEAR(n.largest.deviation, 0.2 / std::sqrt(2.), 1e-12);
  EXPECT_NEAR(n.largest_of_all, 0.3, 1e-12);
  EXPECT_NEAR(n.end.mean, -0.1, 1e-12);
  EXPECT_NEAR(n.embedment.mean, 0.04, 1e-12);
  EXPECT_NEAR(n.waves_of_first.largest, 0.07, 1e-12);
  const TemporaryFolder folder;
  const std::string section = displacement_section(c, moved, folder.path());
  EXPECT_NE(section.find("<td>seed 2, all</td><td class=\"number\">0.3</td><td class=\"number\">1.2</td>"), std::string::npos)
      << section.substr(section.find("<table"));
  EXPECT_TRUE(std::filesystem::exists(folder / "track.png"));
}

TEST(RunBeside, is_of_the_waves_of_its_seed)
{
  const SeaCase c = on_soil();
  const SeaAnswer a = answer_of(c);
  const std::vector<settings::StageSettings> waves = {stage_of_waves(c, a, 0), stage_of_waves(c, a, 1)};
  record::RunRecord run;
  run.name = "made";
  run.folder = "out/made";
  settings::StageSettings stage = waves[1];
  stage.name = "storm";
  for (Real& value : stage.loads.of("water")) value *= 1 + 1e-6;  // digits of a file
  stage.load_times.back() = 2;                                    // its record ends with the run's
  auto short_waves = waves;
  short_waves[1].load_times.back() = 2;
  run.settings.stage = {stage};
  bodies::RigidSettings pipe;
  pipe.shape = bodies::CircleSettings{{0, 0.1}, 0.25};
  pipe.mass = 206;
  run.settings.rigid = {{"pipe", pipe}};
  run.history.columns = {{"time_s", "", "", "", ""}, {"u_m", "", "", "", ""}, {"w_m", "", "", "", ""}};
  run.history.values = {{3, 4, 5}, {0.1, 0.2, 0.4}, {0.01, 0.02, 0.03}};
  run.history.stage = {"lay", "storm", "storm"};
  const RunBeside beside = run_beside(run, short_waves, 206, 0.25);
  EXPECT_EQ(beside.seed, 2);
  EXPECT_EQ(beside.track.time, (std::vector<Real>{0, 1, 2})) << "from the end of the stage before";
  EXPECT_EQ(beside.track.u, (std::vector<Real>{0.1, 0.2, 0.4}));
  EXPECT_THROW(run_beside(run, short_waves, 300, 0.25), RunError) << "another pipe";
  run.settings.stage[0].water->drag *= 1.1;
  EXPECT_THROW(run_beside(run, short_waves, 206, 0.25), RunError) << "other coefficients";
  run.settings.stage[0].water->drag /= 1.1;
  run.settings.stage[0].load_times.back() = short_waves[1].load_times.back() = 3;
  EXPECT_THROW(run_beside(run, short_waves, 206, 0.25), RunError) << "it has not come to the end";
  run.settings.stage[0].loads.of("water")[5] += 0.1;
  EXPECT_THROW(run_beside(run, short_waves, 206, 0.25), RunError) << "another sea";
  run.settings.stage[0].water.reset();
  EXPECT_THROW(run_beside(run, short_waves, 206, 0.25), RunError);
}

}  // namespace
}  // namespace berm::sea::this_file
