// SPDX-License-Identifier: BSD-3-Clause
// What a case of a pipeline must say, and what it is told where it does not.
#include "samples/error_of.hpp"
#include "samples/pipeline_case.hpp"

#include "input/write_case.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

/// A change to the sample and what the refusal must say.
struct Wrong {
  std::vector<std::string> set;
  std::string key, says;
};

TEST(ReadPipeline, is_refused_with_its_key_where_it_makes_no_sense)
{
  const std::vector<Wrong> wrong = {
      {{"pipeline.wall=\"15 mm\""}, "pipeline", "either wall and young_modulus, or bending_stiffness and axial_stiffness"},
      {{"pipeline.bending_stiffness=\"-1 N m^2\""}, "pipeline.bending_stiffness", "more than 0"},
      {{"pipeline.axial_stiffness=0"}, "pipeline.axial_stiffness", "more than 0"},
      {{"pipeline.submerged_weight=\"0 N/m\""}, "pipeline.submerged_weight", "more than 0"},
      {{"pipeline.submerged_weight=1e300"}, "pipeline.submerged_weight", "no line has"},
      {{"pipeline.mass=1e-300"}, "pipeline.mass", "no line has"},
      {{"pipeline.submerged_weight=\"1.5 kN\""}, "pipeline.submerged_weight", "N/m"},
      {{"pipeline.mass=\"-3 kg/m\""}, "pipeline.mass", "more than 0"},
      {{"pipeline.lay_tension=\"-1 kN\""}, "pipeline.lay_tension", ""},
      {{"pipeline.poisson_ratio=0.6"}, "pipeline.poisson_ratio", "0.5"},
      {{"pipeline.expansion=-1e-5"}, "pipeline.expansion", ""},
      {{"pipeline.half=\"whole\""}, "pipeline.half", "symmetric"},
      {{"pipeline.half=\"none\""}, "pipeline.imperfection", "pipeline.route"},
      {{"pipeline.end=\"spring\""}, "pipeline.end_stiffness", "is needed"},
      {{"pipeline.end_stiffness=\"1 N/m\""}, "pipeline.end_stiffness", "nothing else"},
      {{"pipeline.end=\"anchored\"", "stage.current.pipeline.pull=\"1 kN\""}, "pipeline.pull", "anchored"},
      {{"pipeline.route={x=[0, 1], y=[0, 0]}"}, "pipeline.route", "cannot be combined with"},
      {{"pipeline.imperfection.amplitude=0", "pipeline.route={x=[0, 1], y=[0]}"}, "pipeline.route.y", "as many"},
      {{"pipeline.imperfection.amplitude=0", "pipeline.route={x=[0, 1, 1], y=[0, 0, 0]}"}, "pipeline.route.x", "ascend"},
      {{"pipeline.imperfection.amplitude=0", "pipeline.route={x=[1, 2], y=[0, 0]}"}, "pipeline.route.x", "begin at 0"},
      {{"pipeline.slices.as_spring=\"sometimes\""}, "pipeline.slices.as_spring", "never"},
      {{"pipeline.soil=[{to=\"1 m\", set=[\"material.clay.cohesion=1\"]}]"}, "pipeline.soil[0].from", "above 0"},
      {{"pipeline.soil=[{from=\"2 m\", to=\"9 m\", set=[\"material.clay.cohesion=1\"]}]"}, "pipeline.soil[0].to", "beyond the last"},
      {{"pipeline.soil=[{from=\"1 m\", to=\"1 m\", set=[\"mesh.near_size=1\"]}]"}, "pipeline.soil[0].set", "material and contact"},
      {{"pipeline.slices.as_spring=\"always\""}, "pipeline.slices.as_spring", "lateral resistance"},
      {{"pipeline.slices.as_spring=\"always\"", "pipeline.far_soil.friction=1",
        "pipeline.soil=[{from=1, to=1, set=[\"material.clay.cohesion=1\"]}]"},
       "pipeline.soil",
       "always springs"},
      {{"pipeline.imperfection.amplitude=0", "pipeline.route={x=[0], y=[0]}"}, "pipeline.route.x", "needs 2"},
      {{"pipeline.imperfection.amplitude=0", "pipeline.half=\"antisymmetric\"", "pipeline.route={x=[0, 9], y=[1, 0]}"},
       "pipeline.route.y",
       "begin at 0"},
      {{"stage.current.repeat_from=\"lay\""}, "repeat_from", "without `repeat`"},
      {{"stage.unload.repeat=2", "stage.unload.repeat_from=\"current\""}, "repeat_from", "not a stage before"},
      {{"pipeline.end=\"pinned\""}, "pipeline.end", "anchored"},
      {{"pipeline.length=\"2 m\""}, "pipeline.length", "to the last slice"},
      {{"pipeline.length=\"inf m\""}, "pipeline.length", ""},
      {{"pipeline.slices.to=\"2 m\""}, "pipeline.slices.to", "fewer than four slices"},
      {{"pipeline.slices={to=\"3 m\"}"}, "pipeline.slices", "needs one of these: spacing (with to), at, or count"},
      {{"pipeline.slices.count=8"}, "pipeline.slices", "needs one of these"},
      {{"pipeline.slices={spacing=\"1 m\"}"}, "pipeline.slices.to", "is needed with spacing"},
      {{"pipeline.slices={count=3, to=\"3 m\"}"}, "pipeline.slices.count", "less than 4"},
      {{"pipeline.slices={count=1001, to=\"3 m\"}"}, "pipeline.slices.count", "1000"},
      {{"pipeline.slices={count=8, to=\"4 m\"}"}, "pipeline.length", "to the last slice"},
      {{"pipeline.slices={count=8, to=\"3 m\"}"}, "pipeline.slices.count", "have no lateral resistance"},
      {{"pipeline.slices={at=[0, 1, 2]}"}, "pipeline.slices.at", "has 3 positions"},
      {{"pipeline.slices={at=[1, 1.5, 2, 3]}"}, "pipeline.slices.at", "must begin at 0"},
      {{"pipeline.slices={at=[0, 2, 1, 3]}"}, "pipeline.slices.at", "1 m follows 2 m"},
      {{"pipeline.slices={at=[0, 1, 2, 4]}"}, "pipeline.length", "to the last slice"},
      {{"pipeline.slices={at=[0, 1, 2, 3], to=3}"}, "pipeline.slices.to", "leave it out"},
      {{"pipeline.slices.spacing=0"}, "pipeline.slices.spacing", "more than 0"},
      {{"pipeline.slices.spacing=\"1 mm\""}, "pipeline.slices.spacing", "more than 1000 slices"},
      {{"pipeline.imperfection.amplitude=0"}, "pipeline.imperfection.amplitude", "does not buckle"},
      {{"pipeline.imperfection.length=\"7 m\""}, "pipeline.imperfection.length", "less than twice"},
      {{"pipeline.far_soil.friction=-1"}, "pipeline.far_soil.friction", ""},
      {{"pipeline.far_soil.axial_mobilisation=0"}, "pipeline.far_soil.axial_mobilisation", "more than 0"},
      {{"pipeline.vertical_damping=\"-1 1/s\""}, "pipeline.vertical_damping", ""},
      {{"pipeline.slice.spacing=1"}, "pipeline.slice", "slices"},
      {{"stage.current.pipeline.temperature=\"30 K\""}, "stage.current.pipeline.temperature", "needs pipeline.expansion"},
      {{"stage.current.pipeline.pressure=\"10 MPa\""}, "stage.current.pipeline.pressure", "needs the wall"},
      {{"stage.current.pipeline.weight=\"-1 N/m\""}, "stage.current.pipeline.weight", "more than 0"},
      {{"stage.lay.pipeline.lateral=\"1 N/m\""}, "stage.lay.pipeline", "is for kind = \"pipeline\""},
      {{"stage.lay.kind=\"pipeline\""}, "stage.lay.force", "only a push or a drag"},
      {{"stage.current.kind=\"free\""}, "stage.current.pipeline", "is for kind"},
      {{"stage.current.until.displacement=\"1 m\""}, "stage.current.until", "is a time"},
      {{"stage.current.velocity=\"1 m/s\""}, "stage.current.velocity", "only a push or a drag"},
      {{"stage.current.drive.x.velocity=\"1 m/s\""}, "stage.current.drive.x", "kind = \"drive\""},
      {{"pipeline.slices.to=\"3.3 m\"", "pipeline.length=\"4 m\""}, "pipeline.slices.to", "multiple"},
      {{"pipeline.imperfection.length=\"3 m\""}, "pipeline.imperfection.length", "four spacings"},
      {{"pipeline.lay_tension=\"1 kN\""}, "pipeline.lay_tension", "hold it"},
      {{"rigid.pipe.rotation=\"free\""}, "rigid.pipe.rotation", "fixed"},
      {{"stage.current.ramp=\"3 s\""}, "stage.current.ramp", "before the stage does"},
      {{"gravity=[1, -9.81]"}, "pipeline", "gravity along -y"},
      {{"method=\"fem\""}, "", "mpm"},
      {{"rigid.pipe.mass=0"}, "", "mass"},
      {{"safety.factor=1.5"}, "pipeline", "factor of safety"},
  };
  for (const Wrong& one : wrong) {
    const std::string error = test::error_of<InputError>([&] { test::line_case(one.set); });
    EXPECT_TRUE(error.starts_with("line.toml:") || error.starts_with("--set ")) << one.set[0] << ": " << error;
    EXPECT_NE(error.find(one.key), std::string::npos) << one.set[0] << ": " << error;
    EXPECT_NE(error.find(one.says), std::string::npos) << one.set[0] << ": " << error;
  }
}

TEST(ReadPipeline, keeps_what_it_says_and_has_defaults_for_the_rest)
{
  const settings::Case c = test::line_case();
  ASSERT_TRUE(c.pipeline);
  EXPECT_EQ(places_of(c.pipeline->slices), (std::vector<Real>{0, 1, 2, 3}));
  EXPECT_EQ(c.pipeline->half, settings::LineHalf::symmetric);
  EXPECT_EQ(c.pipeline->far_soil.axial_mobilisation, 2e-3);
  EXPECT_EQ(c.stage.back().kind, settings::StageKind::pipeline);
  EXPECT_EQ(c.stage.back().pipeline.lateral, 1000);
}

TEST(ReadPipeline, gives_slices_places_and_writes_them_out)
{
  const settings::Case c = test::line_case({"pipeline.slices={count=7, to=\"3 m\"}", "pipeline.far_soil.friction=0.5"});
  const std::vector<Real> places = places_of(c.pipeline->slices);
  ASSERT_EQ(places.size(), 7U);
  EXPECT_EQ(places.back(), 3);
  EXPECT_EQ(places_of(read_case_text("resolved.toml", resolved_toml(c)).pipeline->slices), places);
}

// Stages are lay, unload, sweep, sweep_1 and current; repeated, the sweep is the fifth.
TEST(ReadPipeline, of_a_case_with_repetitions_is_refused_where_the_stage_is_written)
{
  std::string text = test::small_line_case;
  const std::string current = "[[stage]]\nname = \"current\"";
  text.insert(text.find(current), "[[stage]]\nname = \"sweep\"\nkind = \"sweep\"\nvelocity = 0.1\namplitude = 0.1\nsweeps = 2\n"
                                  "[[stage]]\nname = \"sweep_1\"\nkind = \"push\"\nforce = 1500\nuntil.time = 1\n");
  const std::size_t line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("name = \"sweep\"")), '\n') + 1;
  const std::string error = test::error_of<InputError>([&] { read_case_text("line.toml", text, {"stage.lay.repeat=3"}); });
  EXPECT_TRUE(error.starts_with("line.toml:" + std::to_string(line) + ": stage.sweep.name: the drags of \"sweep\" are called sweep_1"))
      << error;
}

}  // namespace
}  // namespace berm::input::this_file
