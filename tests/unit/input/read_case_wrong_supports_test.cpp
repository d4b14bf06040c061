// SPDX-License-Identifier: BSD-3-Clause
// Motions and heads of supports, and K0 by the stress history, that make no sense; and files of motions.
#include "input/read_case.hpp"
#include "os/error.hpp"
#include "samples/refusal.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

using test::refusal_with;

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

/// The good case whose base moves along x by these rows, with more keys.
std::string refusal_of_motion(const std::string& rows, std::vector<std::string> keys = {})
{
  keys.push_back("support.base.motion={" + rows + "}");
  return refusal_with(keys);
}

TEST(Motion, of_a_base_is_read)
{
  const settings::Case c = read_case_text("case.toml", std::string(test::good_case),
                                          {"support.base.motion={stages=[\"drag\"], times=[0, \"20 ms\", 1], x=[0, \"5 cm/s\", 0]}"});
  ASSERT_TRUE(c.support[0].second.motion);
  EXPECT_EQ(c.support[0].second.motion->velocity[0], (std::vector<Real>{0, 0.05, 0}));
  EXPECT_EQ(boundary::velocity_at(*c.support[0].second.motion, 0, 0.01), 0.025);
  EXPECT_EQ(boundary::velocity_at(*c.support[0].second.motion, 1, 0.01), 0);
}

TEST(Motion, that_is_wrong_says_what_is_allowed)
{
  const std::string rows = "times=[0, 1], x=[0, 0.1]", drag = "stages=[\"drag\"], ";
  EXPECT_SAYS(refusal_of_motion(rows), "support.base.motion.stages");
  EXPECT_SAYS(refusal_of_motion("stages=[], " + rows), "support.base.motion.stages: must not be empty");
  EXPECT_SAYS(refusal_of_motion("stages=[\"drg\"], " + rows), "did you mean \"drag\"?");
  EXPECT_SAYS(refusal_of_motion("stages=[\"push\"], " + rows, {"stage.push={name=\"push\", kind=\"geostatic\", until={time=1}}"}),
              "is a geostatic stage, in which the soil comes to rest");
  EXPECT_SAYS(
      refusal_of_motion(drag + rows, {"stage.drag.kind=sweep", "stage.drag.amplitude=0.1", "stage.drag.sweeps=2", "stage.drag.until={}"}),
      "is a sweep, several drags");
  EXPECT_SAYS(refusal_of_motion(drag + rows, {"support.base.stages=[\"push\"]"}), "the support does not act in \"drag\"");
  EXPECT_SAYS(refusal_of_motion(drag + rows, {"support.base.fixed=[\"y\"]"}),
              "support.base.motion.x: the support leaves the soil free along x");
  EXPECT_SAYS(refusal_of_motion(drag + "times=[0, 1], z=[0, 0.1]"), "z: is not a direction in the plane");
  EXPECT_SAYS(refusal_of_motion(drag + "times=[0.5, 1], x=[0, 0.1]"), "begins at 0.5 s: times are measured from the start of each stage");
  EXPECT_SAYS(refusal_of_motion(drag + "times=[0, 1, 1], x=[0, 0.1, 0]"), "cannot jump to another velocity");
  EXPECT_SAYS(refusal_of_motion(drag + "times=[0, 1], x=[0]"), "needs as many velocities as times has times, 2, and has 1");
  EXPECT_SAYS(refusal_of_motion(drag + "times=[0, 1]"), "needs velocities at these times");
  EXPECT_SAYS(refusal_of_motion(drag + "times=[0], x=[0]"), "needs two times at least");
  EXPECT_SAYS(refusal_of_motion("stages=[\"drag\"]"), "needs a table, or times and velocities");
  EXPECT_SAYS(refusal_of_motion(drag + "table=\"quake.csv\", " + rows), "cannot be combined with table");
  EXPECT_SAYS(refusal_of_motion(drag + rows, {"mpm.active_distance=1"}), "motion of supports does not reach inactive soil");
  EXPECT_SAYS(refusal_of_motion(drag + rows, {"method=fem", "stage.push={name=\"push\", kind=\"push\", force=1, until={time=1}}"}),
              "support.base.motion: is for method = \"mpm\"");
}

class MotionFile : public testing::Test {
protected:
  settings::Case read(const std::string& text)
  {
    folder_.write("quake.csv", text);
    std::string text_of_case(test::good_case);
    text_of_case += "\n[support.base.motion]\ntable = \"quake.csv\"\nstages = [\"drag\"]\n";
    folder_.write("case.toml", text_of_case);
    return read_case(folder_.path() / "case.toml", {});
  }
  std::string refusal(const std::string& text)
  {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
};

TEST_F(MotionFile, has_columns_with_their_units)
{
  const boundary::MotionSettings motion = *read("# a quake\ntime_s;x_cm_s;y_m_s\n0;0;0\n0.5;10;-0.02\n").support[0].second.motion;
  EXPECT_EQ(motion.times, (std::vector<Real>{0, 0.5}));
  EXPECT_EQ(motion.velocity[0], (std::vector<Real>{0, 0.1}));
  EXPECT_EQ(motion.velocity[1], (std::vector<Real>{0, -0.02}));
  EXPECT_TRUE(motion.table.empty()) << "a resolved case needs no file";
}

TEST_F(MotionFile, that_is_wrong_is_refused_with_its_line)
{
  EXPECT_SAYS(refusal("time_s,x_m\n0,0\n1,0\n"),
              "quake.csv:1: \"x_m\" has no unit of a velocity, such as \"0.1 m/s\" or \"20 mm/s\": write \"x_m_s\"");
  EXPECT_SAYS(refusal("time_s,z_m_s\n0,0\n1,0\n"), "\"z_m_s\" is not a column of this motion");
  EXPECT_SAYS(refusal("0,0\n1,0\n"), "the first line must name the columns: time_s,x_m_s,y_m_s");
  EXPECT_SAYS(refusal("time_s,x_m_s\n0.1,0\n1,0\n"), "quake.csv:2: begins at 0.1 s");
  EXPECT_SAYS(refusal("time_s,x_m_s\n0,0\n1,0\n1,1\n"), "quake.csv:4: times must ascend");
  EXPECT_SAYS(refusal("time_s,x_m_s\n0,0\n"), "has one line of numbers");
}

/// The good case in soil whose water flows.
std::string refusal_in_water(std::vector<std::string> keys)
{
  for (const char* key : {"drainage=consolidation", "permeability=1e-4 m/s", "porosity=0.4"})
    keys.push_back(std::string("material.sand.water.") + key);
  keys.insert(keys.end(), {"material.sand.density=900", "material.sand.inertia_density=1900"});
  return refusal_with(keys);
}

TEST(Head, of_a_drained_support_in_soil_whose_water_flows_is_read)
{
  EXPECT_EQ(refusal_in_water({"support.base.drained=true", "support.base.head=0.2 m", "support.base.ramp=1 s"}), "");
}

TEST(Head, that_is_wrong_says_what_is_allowed)
{
  EXPECT_SAYS(refusal_with({"support.base.drained=true", "support.base.head=0.2"}), "no soil has water that flows");
  EXPECT_SAYS(refusal_in_water({"support.base.head=0.2"}),
              "support.base.head: is of water that crosses the boundary: it needs drained = true");
  EXPECT_SAYS(refusal_in_water({"support.base.drained=true", "support.base.ramp=1"}), "support.base.ramp: is for a head");
  EXPECT_SAYS(refusal_in_water({"support.base.drained=true", "support.base.head=0.2",
                                "support.closed={boundary=\"bottom\", fixed=[\"x\"], stages=[\"drag\"]}"}),
              "[support.closed] holds the same boundary in the same stage and lets no water through");
  EXPECT_SAYS(refusal_in_water({"support.base.drained=true", "support.base.head=0.2", "stage.drag.kind=free",
                                "stage.drag={name=\"drag\", kind=\"free\", until={consolidation=0.5}}"}),
              "so a degree of consolidation is never reached");
}

TEST(K0ByHistory, needs_a_friction_angle_and_stands_alone)
{
  EXPECT_EQ(refusal_with({"body.bed.k0_ocr=4"}), "");
  EXPECT_SAYS(refusal_with({"body.bed.k0_ocr=0.5"}), "body.bed.k0_ocr");
  EXPECT_SAYS(refusal_with({"body.bed.k0=0.5", "body.bed.k0_ocr=4"}), "is given by one of k0, k0_ocr and k0_pop");
  EXPECT_SAYS(refusal_with({"body.bed.k0_pop=30 kPa", "body.bed.material=rubber"}),
              "K0 follows from it by the friction angle, and [material.rubber] with the law \"linear_elastic\" has none: give k0");
  EXPECT_SAYS(refusal_with({"body.bed.soil_layer=[{top=1, material=\"sand\", k0_ocr=2}]"}), "needs body.bed.k0");
  EXPECT_SAYS(refusal_with({"body.bed.k0_ocr=2", "body.bed.region_material={box=\"sand\"}"}), "give the soils by soil_layer");
}

}  // namespace
}  // namespace berm::input::this_file
