// SPDX-License-Identifier: BSD-3-Clause
// What a cable does on a slope and in its trench, in words.
#include "structures/driven/report.hpp"

#include "samples/made_run_in_water.hpp"
#include "structures/base/answer.hpp"

#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

std::string words_of(const record::RunRecord& run)
{
  return results_in_words(DrivenRun(run), base::DisplayUnits({{base::body_scale(run), &run.quantities}}));
}

/// Dragged by a diameter under V = 800 N/m: H = 270 N/m from the start, and 400 N/m against the soil that it has heaped up at the end.
std::string words_on(Real slope)
{
  MadeRun made;
  made.dragged = 0.02;
  made.H = [](Real u) { return u < 0.01 ? 270 : 270 + 13000 * (u - 0.01); };
  record::RunRecord run = made.record();
  std::get<mesh::SeabedMesh>(run.settings.mesh).slope = slope;
  return words_of(run);
}

// By hand: T = 270 cos 8 - 800 sin 8 = 156 N/m, N = 800 cos 8 + 270 sin 8 = 830 N/m, tan 8 = 0.141; downhill T = 270 cos 8 + 800 sin 8 = 379 N/m.
TEST(InWords, a_drag_on_a_slope_says_what_the_soil_holds_it_by_along_the_ground_and_whether_it_stays)
{
  EXPECT_EQ(words_on(0).find("Along the ground"), std::string::npos);
  const std::string uphill = words_on(8 * degree), downhill = words_on(-8 * degree), steep = words_on(12 * degree);
  EXPECT_NE(uphill.find("which rises by 8° along its path, the soil resistance is T = 0.156 kN/m"), std::string::npos) << uphill;
  EXPECT_NE(uphill.find("when it begins to slide (H cos 8° − V sin 8°): 0.188 times the force N = 0.83 kN/m"), std::string::npos) << uphill;
  EXPECT_NE(uphill.find("pulls it down the slope with 0.141 times N, less than that: it stays"), std::string::npos) << uphill;
  EXPECT_NE(downhill.find("which falls by 8° along its path, the soil resistance is T = 0.379 kN/m"), std::string::npos) << downhill;
  EXPECT_NE(downhill.find("when it begins to slide (H cos 8° + V sin 8°): 0.502 times"), std::string::npos) << downhill;
  EXPECT_NE(steep.find("more than that: it slides"), std::string::npos) << steep;
}

/// The pipe in soil with water, which rests, and is lifted from w = 2.5 D then.
TEST(InWords, a_lift_out_of_the_soil_says_how_far_it_has_consolidated_and_what_it_takes_to_pull_it_out)
{
  record::RunRecord run = MadeRunInWater{}.record();
  const Real D = 0.02;
  run.settings.stage.push_back(MadeRun::stage_of("lift", settings::StageKind::push));
  run.settings.stage.back().velocity = -0.1;
  run_folder::History& h = run.history;
  for (Real& w : h.values[2]) w += 2.4 * D;
  const Real begin = h.values[0].back(), w = h.values[2].back();
  for (int k = 1; k <= 250; ++k) {
    const Real part = 0.002 * k, row[] = {begin + k, 0, w - part * D, 0, part < 0.05 ? 500 - 2.8e4 * part : -900, 0, 0.75};
    for (int column = 0; column < 7; ++column) h.values[column].push_back(row[column]);
    h.stage.emplace_back("lift");
  }
  run.quantities = structures::structure_of(run.settings).quantities(run, {});
  const std::string words = words_of(run);
  EXPECT_NE(words.find("when 75 % of the excess pore pressure of \"rest\" has dissipated, the pipe mobilises an uplift resistance of"),
            std::string::npos)
      << words;
  const base::DisplayUnits shown({{base::body_scale(run), &run.quantities}});
  const std::string tables = key_results({DrivenRun(run)}, shown), log = base::log_table(run.quantities, base::body_scale(run));
  EXPECT_NE(tables.find("Uplift resistance R by the travel upwards"), std::string::npos) << tables;
  EXPECT_EQ(log.find("lift.V_end "), std::string::npos) << log;
  EXPECT_NE(log.find("lift.R_end "), std::string::npos) << log;
  EXPECT_NE(words.find("Available uplift resistance, excluding the submerged weight: 0.9 kN/m"), std::string::npos) << words;
}

}  // namespace
}  // namespace berm::driven::this_file
