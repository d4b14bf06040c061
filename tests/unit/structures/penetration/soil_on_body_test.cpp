// SPDX-License-Identifier: BSD-3-Clause
#include "structures/penetration/soil_on_body.hpp"

#include "mesh/box.hpp"
#include "run_folder/frames.hpp"
#include "samples/frame_particles.hpp"
#include "samples/made_push.hpp"
#include "samples/temporary_folder.hpp"
#include "structures/base/general_measures.hpp"
#include "structures/penetration/penetrometers.hpp"

#include <gtest/gtest.h>

namespace berm::penetration::this_file {
namespace {

/// A footing of R = 0.1 m that is pushed 0.1 m into clay of 5 kN/m3 and s_u = 10 kPa, and a frame at its end: soil in squares of 10 mm, down to 0.2 m below the bed,
/// without the hole above the footing but for its lowest `filled` m.
class Backflow : public testing::Test {
protected:
  record::RunRecord pushed(Real filled)
  {
    MadePush made;
    made.shape = bodies::BoxSettings{{0, 0.05}, {0.2, 0.1}, 0};
    made.pushed_to = 0.1;
    made.q = [](Real z) { return 5e3 * z + 60e3; };
    record::RunRecord run = made.record();
    run.folder = folder_.path();
    std::vector<run_folder::FrameParticle<2>> soil;
    for (int i = 0; i < 30; ++i)
      for (int j = 0; j < 20; ++j) {
        run_folder::FrameParticle<2> p{{}, 0, Vec<2>::Zero(), {}, 0};
        p.particle.x = {side * (i + 0.5), -side * (j + 0.5)};
        p.particle.volume = side * side;
        p.particle.id = static_cast<Index>(soil.size());
        if (i >= 10 || j >= 10 || -p.particle.x[1] > 0.1 - filled) soil.push_back(p);
      }
    run_folder::Frame<2> frame = frame_of(soil);
    frame.time = run.history["time_s"].back();
    run_folder::FrameWriter<2> writer(folder_ / "frames",
                                      mesh::make_box<2>(mesh::BoxMesh{.lower = {0, -0.2}, .size = {0.3, 0.3}, .cells = {3, 3}}));
    writer.write(frame);
    run.quantities = structures::structure_of(run.settings).quantities(run, {});
    return run;
  }

  static constexpr Real side = 0.01;
  TemporaryFolder folder_;
};

TEST_F(Backflow, of_an_open_hole_weighs_nothing)
{
  const record::RunRecord run = pushed(0);
  EXPECT_EQ(backflow_pressure(PenetrationRun(run, footing())), 0);
  EXPECT_NEAR(base::quantity_value(run, "N_c_end_backflow"), 6, 1e-6);
  const std::string words =
      structures::structure_of(run.settings).in_words(run, base::DisplayUnits({{base::body_scale(run), &run.quantities}}));
  EXPECT_NE(words.find("is that beside a hole that stays open, as it does here above the probe."), std::string::npos) << words;
}

TEST_F(Backflow, weighs_what_lies_above_the_base_and_gives_back_as_much_of_the_overburden)
{
  const record::RunRecord run = pushed(0.08);
  EXPECT_NEAR(base::quantity_value(run, "sigma_backflow_end"), 5e3 * 0.08, 1e-3);
  EXPECT_NEAR(base::quantity_value(run, "N_c_end_backflow"), 6.04, 1e-6);
  record::RunRecord deep = run;
  for (run_folder::Quantity& q : deep.quantities)
    if (q.name == "N_c_end_backflow") q.value = 9;
  const std::string words =
      structures::structure_of(deep.settings).in_words(deep, base::DisplayUnits({{base::body_scale(deep), &deep.quantities}}));
  EXPECT_NE(words.find("soil has flowed back over the probe and its weight divided by the area of the body is 400 Pa at the end"),
            std::string::npos)
      << words;
}

TEST_F(Backflow, is_not_known_without_a_frame)
{
  record::RunRecord run = pushed(0);
  run.folder.clear();
  EXPECT_TRUE(std::isnan(backflow_pressure(PenetrationRun(run, footing()))));
}

// A body of 0.2 m with its top at y = -0.4 m: the place above it reaches to y = -0.3 m, 0.05 m to each side.
TEST(SoilAbove, a_body_is_the_part_of_the_squares_that_hold_a_point)
{
  run_folder::SavedSoil soil;
  const auto add = [&](Real x, Real y) { soil.x.push_back(x), soil.y.push_back(y); };
  add(0.3, -0.35), add(0.01, -0.45), add(0.01, -0.25);  // beside it, in the body, above the place
  EXPECT_EQ(soil_above(soil, 0, -0.4, 0.2), 0);
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) add(0.0025 + 0.005 * i, -0.3975 + 0.005 * j);
  EXPECT_NEAR(soil_above(soil, 0, -0.4, 0.2), 0.5, 1e-12) << "of a half of the model, filled half way up";
}

}  // namespace
}  // namespace berm::penetration::this_file
