// SPDX-License-Identifier: BSD-3-Clause
#include "sample_sea.hpp"
#include "sea/sea_answer.hpp"

#include <gtest/gtest.h>

namespace berm::sea::this_file {
namespace {

TEST(SeaAnswer, has_the_loads_and_the_utilisation_of_f109)
{
  SeaCase c = sample_sea();
  c.current = Current{.velocity = 0.5, .height = 3, .direction = pi / 2, .roughness = 4e-5};
  c.bed.safety_factor = 1.3;
  const SeaAnswer a = answer_of(c);
  const Real V = formulas::current_on_pipe(0.5, 3, 4e-5, pi / 2, 0.25).value, U = a.design.velocity.value;
  const Real K = U * a.design.period.value / 0.25;
  const formulas::PeakLoads peak = formulas::f109_peak_loads(K, V / U);
  const Real pressure = 0.5 * 1025 * 0.25 * (U + V) * (U + V);
  EXPECT_NEAR(a.horizontal, (1 - 1.4 * 0.04) * peak.horizontal.value * pressure, 1e-9);
  EXPECT_NEAR(a.vertical, 0.7 * peak.vertical.value * pressure, 1e-9);
  const Utilisation used = absolute_stability(c, a);
  EXPECT_NEAR(used.lateral, 1.3 * (a.horizontal + 0.6 * a.vertical) / (0.6 * 400 + a.passive), 1e-12);
  EXPECT_NEAR(used.vertical, 1.3 * a.vertical / 400, 1e-12);
}

TEST(SeaAnswer, has_passive_resistance_on_sand_as_far_as_lift_leaves_weight)
{
  SeaCase c = sample_sea();
  c.pipe.weight = 4000;
  const SeaAnswer heavy = answer_of(c);
  ASSERT_LT(heavy.vertical, 4000);
  const Real on_bed = 4000 - heavy.vertical, k = 9e3 * 0.25 * 0.25 / on_bed;
  EXPECT_NEAR(heavy.passive, on_bed * (5 * k - 0.15 * k * k) * std::pow(0.04, 1.25), 1e-9);
  c.pipe.weight = 10;
  EXPECT_EQ(answer_of(c).passive, 0);
  c.bed.unit_weight.reset();
  EXPECT_EQ(answer_of(c).passive, 0);
  EXPECT_TRUE(std::isnan(answer_of(c).stable_weight.value)) << "the tables are of sand";
}

TEST(SeaAnswer, has_the_embedment_of_its_weight_where_none_is_given)
{
  SeaCase c = sample_sea();
  c.pipe.embedment.reset();
  EXPECT_NEAR(answer_of(c).embedment, 0.037 * 0.25 * std::pow(400 / (9e3 * 0.0625), 2. / 3), 1e-12);
  c.bed.unit_weight.reset();
  EXPECT_EQ(answer_of(c).embedment, 0);
}

TEST(SeaAnswer, of_waves_along_the_pipe_is_what_their_spreading_leaves)
{
  SeaCase c = sample_sea();
  c.sea.direction = 0;
  c.sea.spreading = 2;
  EXPECT_NEAR(answer_of(c).waves.velocity / answer_of(sample_sea()).waves.velocity, 0.5, 1e-12);
}

TEST(SeaAnswer, tells_whether_the_sea_moves_the_sand)
{
  SeaCase c = sample_sea();
  EXPECT_FALSE(answer_of(c).shields) << "without a grain size";
  c.bed.grain_size = 0.3e-3;
  const SeaAnswer storm = answer_of(c);
  EXPECT_GT(storm.shields->value, storm.critical_shields->value);
  const formulas::SeabedWaves waves = formulas::waves_at_seabed(*c.spectrum, c.sea.depth);
  EXPECT_EQ(storm.shields->value, formulas::shields_parameter({.velocity = waves.velocity, .period = waves.period}, 0.3e-3).value);
  c.sea.direction = 0;
  c.sea.spreading = 2;
  EXPECT_EQ(answer_of(c).shields->value, storm.shields->value) << "of all directions";
}

TEST(LoadClasses, hold_all_waves_of_all_realisations)
{
  SeaCase c = sample_sea();
  c.record.seeds = 3;
  const SeaAnswer a = answer_of(c);
  Real cycles = 0;
  for (const LoadClass& of : load_classes(a)) cycles += of.cycles;
  std::size_t waves = 0;
  for (const auto& of : a.waves_of_record) waves += of.size();
  EXPECT_NEAR(cycles * 3, static_cast<Real>(waves), 1e-9);
  EXPECT_NEAR(cycles, 3600 / a.waves.period, 0.15 * cycles) << "as many as the velocity has";
}

}  // namespace
}  // namespace berm::sea::this_file
