// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"
#include "input/write_case.hpp"
#include "os/error.hpp"
#include "samples/wrong_inputs.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

/// The good case around an axis: a ball is pushed.
std::string good_ball()
{
  std::string text(test::good_case);
  const auto replace = [&](const std::string& from, const std::string& to) { text.replace(text.find(from), from.size(), to); };
  replace("gravity = [0", "geometry = \"axisymmetric\"\ngravity = [0");
  replace("center = [1.0, \"1.4 m\"]", "center = [0, \"1.4 m\"]");
  replace("mass = \"430 kg/m\"", "mass = \"430 kg\"");
  replace("kind = \"drag\"\nvelocity", "kind = \"push\"\nvelocity");
  return text;
}

/// The message that refuses that case after these overrides; empty where it is taken.
std::string refusal_of_ball(const std::vector<std::string>& overrides, const std::string& text = good_ball())
{
  try {
    read_case_text("case.toml", text, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string with(std::string from, const std::string& to)
{
  std::string text = good_ball();
  text.replace(text.find(from), from.size(), to);
  return text;
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(Geometry, is_a_closed_list)
{
  EXPECT_SAYS(refusal_of_ball({"geometry=axisymetric"}), "did you mean \"axisymmetric\"");
  EXPECT_SAYS(refusal_of_ball({"geometry=disk"}), "allowed: plane_strain, axisymmetric, space");
}

TEST(Axisymmetric, case_is_taken_with_whole_masses_and_forces)
{
  EXPECT_EQ(refusal_of_ball({}), "");
  EXPECT_SAYS(refusal_of_ball({"rigid.pipe.mass=430 kg/m"}), "rigid.pipe.mass");
  EXPECT_EQ(refusal_of_ball({"stage.push.until.force=4 kN"}), "");
  EXPECT_SAYS(refusal_of_ball({"stage.push.until.force=4 kN/m"}),
              "stage.push.until.force: \"4 kN/m\" has the wrong dimension; expected a force, such as \"500 N\"");
  const std::string once = resolved_toml(read_case_text("case.toml", good_ball()));
  EXPECT_SAYS(once, "geometry = \"axisymmetric\"");
  EXPECT_EQ(resolved_toml(read_case_text("resolved.toml", once)), once);
}

TEST(Axisymmetric, motion_is_along_the_axis_only)
{
  EXPECT_SAYS(refusal_of_ball({}, with("kind = \"push\"\nvelocity = \"0.1 m/s\"\nramp", "kind = \"drag\"\nvelocity = \"0.1 m/s\"\nramp")),
              "stage.drag.kind: a body around the axis moves along it only");
  const std::string drive = with("kind = \"push\"\nvelocity = \"0.1 m/s\"\nramp", "kind = \"drive\"\ndrive.x.velocity = 0.1\nramp");
  EXPECT_SAYS(refusal_of_ball({}, drive), "stage.drag.drive.x: is a degree of freedom around an axis for a wall only");
  EXPECT_SAYS(refusal_of_ball({"rigid.pipe.rotation=free"}), "rigid.pipe.rotation");
  EXPECT_SAYS(refusal_of_ball({"gravity=[1, -9.81]"}), "gravity: around an axis");
  EXPECT_SAYS(refusal_of_ball({"body.bed.initial_angular_velocity=1"}), "body.bed.initial_angular_velocity");
}

TEST(Axisymmetric, bodies_are_their_own_mirror_image_or_beside_the_axis)
{
  EXPECT_SAYS(refusal_of_ball({"rigid.pipe.center=[0.2, 1.4]"}), "rigid.pipe: the body must be its own mirror image");
  EXPECT_EQ(refusal_of_ball({"rigid.pipe.center=[0.5, 1.4]"}), "");  // a ring
  const auto shape = [](const std::string& keys) {
    return with("shape = \"circle\"\ncenter = [0, \"1.4 m\"]\ndiameter = \"0.8 m\"", keys);
  };
  EXPECT_EQ(refusal_of_ball({}, shape("shape = \"box\"\ncenter = [0, 1.4]\nsize = [1, 0.5]")), "");
  EXPECT_SAYS(refusal_of_ball({}, shape("shape = \"box\"\ncenter = [0.1, 1.4]\nsize = [1, 0.5]")), "mirror image");
  EXPECT_SAYS(refusal_of_ball({}, shape("shape = \"polygon\"\nx = [0, 1, 0]\ny = [1, 2, 2]")), "shape = \"profile\"");
  EXPECT_EQ(refusal_of_ball({}, shape("shape = \"profile\"\nx = [0, 0.5, 0.5, 0]\ny = [1, 1.4, 3, 3]")), "");
  EXPECT_SAYS(refusal_of_ball({}, shape("shape = \"profile\"\nx = [0.1, 0.5, 0.5, 0]\ny = [1, 1.4, 3, 3]")),
              "must begin and end at the axis");
  EXPECT_SAYS(refusal_of_ball({}, shape("shape = \"profile\"\nx = [0, -0.5, 0.5, 0]\ny = [1, 1.4, 3, 3]")), "more than 0");
  EXPECT_SAYS(refusal_of_ball({}, shape("shape = \"profile\"\nx = [0, 0.5, 0.5, 0]\ny = [1, 1.4, 3, 3]\ncorner_radius = 2")),
              "corner_radius: is too large");
}

TEST(Axisymmetric, what_is_not_made_for_it_is_refused)
{
  EXPECT_SAYS(refusal_of_ball({"initial_state=gravity_loading", "body.bed.k0=0.5"}), "initial_state: around an axis the ground is level");
}

}  // namespace
}  // namespace berm::input::this_file
