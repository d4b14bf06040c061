// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"
#include "os/error.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

/// A quarter of a ball that is pushed into a bed in space.
constexpr const char* quarter = R"(geometry = "space"
symmetry = ["x", "z"]
gravity = [0, "-1 gravity", 0]
[mesh]
kind = "seabed"
length = "1 m"
width = "1 m"
left = 0
back = 0
depth = "1 m"
headroom = "0.5 m"
near_size = "50 mm"
near_left = 0
near_right = "0.3 m"
near_back = 0
near_front = "0.3 m"
near_depth = "0.3 m"
near_height = "0.1 m"
[material.sand]
law = "mohr_coulomb"
density = "1800 kg/m^3"
young_modulus = "7 MPa"
poisson_ratio = 0.3
friction_angle = "35 deg"
[body.bed]
material = "sand"
regions = ["near", "bed"]
[rigid.ball]
shape = "sphere"
center = [0, "0.2 m", 0]
diameter = "0.4 m"
mass = "100 kg"
[[stage]]
name = "push"
kind = "push"
velocity = "0.1 m/s"
until = {embedment = "80 mm"}
)";

/// The message that refuses the case after these overrides; empty where it is taken.
std::string refusal_of(const std::vector<std::string>& overrides, const std::string& text = quarter)
{
  try {
    read_case_text("case.toml", text, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The same body in a stage that drives one of its freedoms.
std::string driven(const std::string& freedom)
{
  const std::string text = quarter;
  return text.substr(0, text.find("[[stage]]")) + "[[stage]]\nname = \"push\"\nkind = \"drive\"\nuntil = {time = 1}\ndrive = {" + freedom +
         " = {velocity = 1}}\n";
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(Symmetry, a_quarter_is_taken_that_moves_within_its_planes)
{
  EXPECT_EQ(refusal_of({}), "");
  EXPECT_EQ(refusal_of({"symmetry=[\"z\"]", "stage.push.kind=drag"}), "");
}

TEST(Symmetry, what_its_planes_do_not_mirror_is_refused_with_what_to_change)
{
  EXPECT_SAYS(refusal_of({"symmetry=[\"y\"]"}), "symmetry: \"y\" is not an axis with a plane of symmetry across it");
  EXPECT_SAYS(refusal_of({"symmetry=[\"z\", \"z\"]"}), "symmetry: names \"z\" twice");
  EXPECT_SAYS(refusal_of({"gravity=[0, -9, 1]"}), "gravity: is inclined to the plane of symmetry: its z must be 0");
  EXPECT_SAYS(refusal_of({"mesh.slope=0.1"}), "mesh: a bed with a slope, a trench or a step is not its own mirror image across x");
  EXPECT_SAYS(refusal_of({"stage.push.kind=drag"}), "moves across the plane of symmetry: leave \"x\" out of symmetry");
  EXPECT_SAYS(refusal_of({"body.bed.initial_angular_velocity=1"}), "a rotation about z is not its own mirror image across x");
  EXPECT_EQ(refusal_of({}, driven("y")), "");
  EXPECT_SAYS(refusal_of({}, driven("z")), "drive.z: moves across the plane of symmetry");
  EXPECT_SAYS(refusal_of({}, driven("rotation_y")), "only a rotation about x is its own mirror image");
}

}  // namespace
}  // namespace berm::input::this_file
