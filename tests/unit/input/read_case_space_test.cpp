// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"
#include "os/error.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

/// A case in space with this body; what stands in `drive` drives it.
std::string space_case(const std::string& shape, const std::string& drive = "drive.y.velocity = 0.1")
{
  return R"(geometry = "space"
[mesh]
kind = "box"
size = [1, 1, 1]
cells = [4, 4, 4]
[material.clay]
law = "linear_elastic"
density = 1500
young_modulus = 1e6
poisson_ratio = 0.3
[body.bed]
material = "clay"
regions = ["box"]
[[stage]]
name = "drive"
kind = "drive"
until.time = 1
)" + drive +
         R"(
[rigid.body]
mass = "5 kg"
)" + shape +
         "\n";
}

/// The message that refuses a text; empty where it is taken.
std::string refusal_in_space(const std::string& text)
{
  try {
    read_case_text((std::filesystem::path(testing::TempDir()) / "case.toml").string(), text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const char* const cylinder = "shape = \"cylinder\"\ncenter = [0, 0, 0]\naxis = [0, 1, 0]\ndiameter = 1\nlength = 2\n";
const char* const box = "shape = \"box\"\ncenter = [0, 0, 0]\nsize = [1, 2, 3]\n";
const char* const profile = "shape = \"profile\"\nx = [0, 0.2, 0.2, 0]\ny = [-0.2, 0, 1, 1]\n";

TEST(ShapesInSpace, are_taken)
{
  for (const char* more : {"", "ends = \"round\"\n", "corner_radius = \"1 cm\"\n"})
    EXPECT_EQ(refusal_in_space(space_case(std::string(cylinder) + more)), "") << more;
  for (const char* more : {"", "tilt = [\"10 deg\", 0, \"20 deg\"]\n", "corner_radius = 0.5\n"})
    EXPECT_EQ(refusal_in_space(space_case(std::string(box) + more)), "") << more;
  for (const char* more : {"", "position = [1, \"2 m\", 3]\naxis = [0, 1, 1]\n", "corner_radius = \"1 cm\"\n"})
    EXPECT_EQ(refusal_in_space(space_case(std::string(profile) + more)), "") << more;
  EXPECT_EQ(refusal_in_space(space_case("shape = \"profile\"\nx = [0.4, 0.5, 0.5, 0.4]\ny = [0, 0, 1, 1]")), "");  // a ring
  EXPECT_EQ(refusal_in_space(space_case("shape = \"circle\"\ncenter = [0, 0, 0]\ndiameter = 1")), "");             // endless along z
}

TEST(ShapesInSpace, are_refused_with_place_key_and_what_to_change)
{
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  const std::pair<std::string, std::string> rows[] = {
      {with(cylinder, "[0, 1, 0]", "[0, 0, 0]"), "rigid.body.axis: must not be zero"},
      {with(cylinder, "[0, 1, 0]", "[0, 1]"), "rigid.body.axis: needs 3 numbers"},
      {with(cylinder, "length = 2", "length = 0"), "rigid.body.length"},
      {with(cylinder, "length = 2", ""), "rigid.body.length"},
      {with(cylinder, "length = 2", "length = 0.5\nends = \"round\""), "with round ends must be the diameter or more"},
      {with(cylinder, "length = 2", "length = 2\nends = \"round\"\ncorner_radius = 0.1"), "is for flat ends"},
      {with(cylinder, "length = 2", "length = 0.2\ncorner_radius = 0.2"), "half the diameter and half the length at most"},
      {with(cylinder, "length = 2", "length = 2\nends = \"pointed\""), "allowed: flat, round"},
      {std::string(box) + "angle = 0.1\n", "tilt = [about x, about y, about z]"},
      {std::string(box) + "tilt = [1, 2]\n", "rigid.body.tilt: needs 3 numbers"},
      {std::string(box) + "corner_radius = 0.6\n", "must be half the shortest side at most"},
      {std::string(profile) + "axis = [0, 0, 0]\n", "rigid.body.axis: must not be zero"},
      {std::string(profile) + "position = [0]\n", "rigid.body.position: needs 3 numbers"},
      {with(profile, "[0, 0.2, 0.2, 0]", "[0, 0.2, 0.2, 0.1]"), "must begin and end at the axis x = 0, or lie off it all around"},
      {"shape = \"surface\"\n", "rigid.body.file"},
      {"shape = \"surface\"\nfile = \"nowhere.stl\"\n", "nowhere.stl: there is no such file"},
      {"shape = \"surface\"\nfile = \"nowhere.stl\"\nscale = 0\n", "rigid.body.scale"},
      {"shape = \"sphere\"\ncenter = [0, 0, 0]\ndiameter = 0\n", "rigid.body.diameter"}};
  for (const auto& [shape, says] : rows) {
    const std::string message = refusal_in_space(space_case(shape));
    EXPECT_NE(message.find("case.toml:"), std::string::npos) << message;
    EXPECT_NE(message.find(says), std::string::npos) << message << "\ninstead of " << says;
  }
}

TEST(ShapesInSpace, that_are_solids_are_refused_in_the_plane)
{
  const auto in_plane = [](const std::string& shape) {
    std::string text = space_case(shape);
    text.replace(text.find("geometry = \"space\""), 18, "");
    text.replace(text.find("size = [1, 1, 1]\ncells = [4, 4, 4]"), 34, "size = [1, 1]\ncells = [4, 4]");
    text.replace(text.find("5 kg"), 4, "5 kg/m");
    return refusal_in_space(text);
  };
  EXPECT_NE(in_plane(cylinder).find("use shape = \"circle\""), std::string::npos) << in_plane(cylinder);
  EXPECT_NE(in_plane("shape = \"profile\"\nx = [0.4, 0.5, 0.5, 0.4]\ny = [0, 0, 1, 1]").find("is for axisymmetry and space"),
            std::string::npos);
  EXPECT_NE(in_plane(std::string(profile) + "axis = [0, 1, 0]").find("in the plane the axis is x = 0"), std::string::npos);
}

TEST(SurfaceOfAFile, is_looked_for_beside_the_case_and_refused_with_its_fault_and_the_line_of_the_key)
{
  std::ofstream(std::filesystem::path(testing::TempDir()) / "open.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string message = refusal_in_space(space_case("shape = \"surface\"\nfile = \"open.obj\""));
  EXPECT_NE(message.find("case.toml:22: rigid.body.file: "), std::string::npos) << message;
  EXPECT_NE(message.find("open.obj is not closed: 3 edges with one triangle, such as at (0.5, 0, 0) m"), std::string::npos) << message;
  std::ofstream(std::filesystem::path(testing::TempDir()) / "tet.obj")
      << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  EXPECT_EQ(refusal_in_space(space_case("shape = \"surface\"\nfile = \"tet.obj\"\nscale = \"1 mm\"")), "");
}

TEST(DrivesInSpace, are_velocity_force_free_held_or_spring_and_one_of_them)
{
  for (const char* drive :
       {"drive.x.spring = \"1 kN/m\"", "drive.x.free = true", "drive = {x.force = \"5 N\", x.spring = 10}",
        "drive.z.hold = true\ndrive.z.spring = 3", "drive.rotation_x.spring = \"2 kN m/rad\"", "drive.rotation_z.free = true",
        "drive.rotation_y.moment = \"3 N m\"", "drive.x.velocity = 1\ndrive.point = [0, \"4 m\", 0]"})
    EXPECT_EQ(refusal_in_space(space_case(box, drive)), "") << drive;
  const std::pair<const char*, const char*> rows[] = {
      {"drive.x.velocity = 1\ndrive.x.spring = 2", "stage.drive.drive.x.spring: cannot be combined with what is prescribed"},
      {"drive.rotation_x.fixed = true\ndrive.rotation_x.spring = 2", "cannot be combined with what is prescribed"},
      {"drive.x.free = true\ndrive.x.force = 2", "is driven in one way only"},
      {"drive.rotation.spring = 2", "is not a degree of freedom in space"},
      {"drive.x.spring = -1", "drive.x.spring"},
      {"drive.x.velocity = 1\ndrive.point = [0, 4]", "stage.drive.drive.point: needs three coordinates"},
      {"drive.x.spring = 1\ndrive.point = [0, 4, 0]", "cannot be combined with springs"},
      {"drive.x.spring = \"1 kN\"", "wrong dimension"}};
  for (const auto& [drive, says] : rows)
    EXPECT_NE(refusal_in_space(space_case(box, drive)).find(says), std::string::npos) << refusal_in_space(space_case(box, drive));
}

TEST(DrivesInSpace, of_a_push_are_its_rotations_only)
{
  const auto pushed = [](const std::string& drive) {
    std::string text = space_case(box, "velocity = 0.1\n" + drive);
    return refusal_in_space(text.replace(text.find("\"drive\"\nuntil"), 7, "\"push\""));
  };
  EXPECT_EQ(pushed("drive.rotation_z.spring = 2"), "");
  EXPECT_NE(pushed("drive.point = [0, 4, 0]").find("is for kind = \"drive\""), std::string::npos);
  EXPECT_NE(pushed("drive.z.spring = 2").find("a push or a drag has velocity, force and vertical"), std::string::npos);
}

}  // namespace
}  // namespace berm::input::this_file
