// SPDX-License-Identifier: BSD-3-Clause
// Fills, excavations, boundaries that absorb, pressures that grow and real times that make no sense.
#include "input/read_case.hpp"
#include "os/error.hpp"
#include "samples/refusal.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

using test::refusal_with;

#define EXPECT_GROUND_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

std::string fill_with(const std::string& keys)
{
  return "body.bed.fill=[{name=\"berm\", material=\"sand\", " + keys + "}]";
}

const std::string square = "x=[0, 1, 1, 0], y=[0, 0, 1, 1]";

TEST(Ground, fill_in_a_stage_is_read)
{
  EXPECT_EQ(refusal_with({fill_with("stage=\"drag\", " + square)}), "");
  EXPECT_EQ(refusal_with({fill_with("stage=\"drag\", lifts=5, duration=\"2 s\", k0=0.5, " + square)}), "");
}

TEST(Ground, wrong_fills_say_what_is_allowed)
{
  EXPECT_GROUND_SAYS(refusal_with({fill_with("stage=\"drg\", " + square)}), "did you mean \"drag\"?");
  EXPECT_GROUND_SAYS(refusal_with({fill_with("stage=\"drag\"")}), "body.bed.fill.berm.x");
  EXPECT_GROUND_SAYS(refusal_with({fill_with("stage=\"drag\", x=[0, 1], y=[0, 1]")}), "needs three corners or more");
  EXPECT_GROUND_SAYS(refusal_with({fill_with("stage=\"drag\", x=[0, 1, 1, 0], y=[0, 1, 0, 1]")}), "must not cross");
  EXPECT_GROUND_SAYS(refusal_with({fill_with("stage=\"drag\", lifts=0, " + square)}), "lifts");
  EXPECT_GROUND_SAYS(refusal_with({fill_with("stage=\"drag\", duration=1, " + square)}), "give it lifts");
  EXPECT_GROUND_SAYS(refusal_with({fill_with("stage=\"drag\", lifts=2, duration=21, " + square)}), "is longer than stage \"drag\", 20 s");
  EXPECT_GROUND_SAYS(refusal_with({fill_with("stage=\"drag\", z_range=[0, 1], " + square)}), "is for space");
  EXPECT_GROUND_SAYS(refusal_with({"body.bed.fill=[{name=\"berm\", material=\"rubber\", stage=\"drag\", " + square + "}]"}),
                     "need one law");
  EXPECT_GROUND_SAYS(refusal_with({"body.bed.fill=[{name=\"tip\", material=\"sand\", stage=\"drag\", " + square + "}]"}),
                     "columns of the history begin with");
  EXPECT_GROUND_SAYS(refusal_with({"body.bed.fill=[{name=\"rock, 2 m\", material=\"sand\", stage=\"drag\", " + square + "}]"}),
                     "without comma, dot or quotes");
  EXPECT_GROUND_SAYS(refusal_with({fill_with("stage=\"drag\", " + square), "mpm.active_distance=1"}), "mpm.active_distance");
  EXPECT_GROUND_SAYS(refusal_with({fill_with("stage=\"drag\", k0=0.5, " + square), "gravity=[\"-1 gravity\", 0]"}), "for gravity along -y");
}

TEST(Ground, two_works_of_one_name_are_refused)
{
  EXPECT_GROUND_SAYS(
      refusal_with({fill_with("stage=\"drag\", " + square), "body.bed.excavation=[{name=\"berm\", stage=\"push\", " + square + "}]"}),
      "another fill or excavation has the name \"berm\"");
}

TEST(Ground, boundary_that_absorbs_needs_rest_first)
{
  EXPECT_GROUND_SAYS(refusal_with({"support.base.absorbs=true"}), "support.base.absorbs: needs a geostatic stage first");
  EXPECT_GROUND_SAYS(
      refusal_with({"support.base.absorbs=true", "gravity=[0, 0]", "support.again={boundary=\"bottom\", fixed=[\"x\"], absorbs=true}"}),
      "[support.base] absorbs the same waves at this boundary");
  EXPECT_EQ(refusal_with({"support.base.absorbs=true", "stage.push.kind=geostatic", "stage.push.until={time=1}"}).find("absorbs"),
            std::string::npos);
}

/// The message that refuses the good case with this load on its left side.
std::string refusal_of_load(const std::string& keys)
{
  try {
    std::string text(test::good_case);
    text += "\n[traction.water]\nboundary = \"left\"\n";
    text += keys;
    read_case_text("case.toml", text, {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Ground, pressure_that_grows_needs_a_level_and_a_pressure)
{
  EXPECT_EQ(refusal_of_load("pressure = 0\npressure_gradient = \"9.81 kPa/m\"\nlevel = 1\n"), "");
  EXPECT_GROUND_SAYS(refusal_of_load("pressure = 0\npressure_gradient = \"9.81 kPa/m\"\n"), "give both level and pressure_gradient");
  EXPECT_GROUND_SAYS(refusal_of_load("pressure = 0\npressure_gradient = \"-9.81 kPa/m\"\nlevel = 1\n"), "pressure_gradient");
  EXPECT_GROUND_SAYS(refusal_of_load("stress = [0, -1]\npressure_gradient = 9810\nlevel = 1\n"), "belongs to a pressure");
}

/// The good case in soil whose water flows, which rests for 30 days of its own instead of the drag.
settings::Case resting_with(std::vector<std::string> keys)
{
  std::string text(test::good_case);
  const std::size_t drag = text.find("[[stage]]\nname = \"drag\""), end = text.find("[watch.tip]");
  text.replace(drag, end - drag, "[[stage]]\nname = \"wait\"\nkind = \"free\"\nuntil.real_time = \"30 days\"\n\n");
  for (const char* key : {"drainage=consolidation", "permeability=1e-4 m/s", "porosity=0.4"})
    keys.push_back(std::string("material.sand.water.") + key);
  keys.insert(keys.end(), {"material.sand.density=900", "material.sand.inertia_density=1900"});
  return read_case_text("case.toml", text, keys);
}

TEST(Ground, real_time_lasts_by_the_ratio_of_the_permeabilities)
{
  const settings::Case c = resting_with({"material.sand.water.real_permeability=1e-9 m/s"});
  ASSERT_TRUE(c.stage[1].until.time);
  EXPECT_NEAR(*c.stage[1].until.time, 30 * 86400 * 1e-5, 1e-9);
}

TEST(Ground, real_time_needs_the_real_permeability)
{
  try {
    resting_with({});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_GROUND_SAYS(std::string(error.what()), "needs water.real_permeability");
  }
}

}  // namespace
}  // namespace berm::input::this_file
