// SPDX-License-Identifier: BSD-3-Clause
// Rigid bodies thinner than two cells that drag the soil behind them along: of which cases this is said, and of which it is not.
#include "samples/program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace berm::sanity::this_file {
namespace {

constexpr const char* soil = R"([material.soft]
law = "linear_elastic"
density = "1600 kg/m^3"
young_modulus = "1 MPa"
poisson_ratio = 0
[support.right]
boundary = "right"
fixed = ["x"]
[support.left]
boundary = "left"
fixed = ["x"]
[support.base]
boundary = "bottom"
fixed = ["y"]
)";
constexpr const char* box = R"([body.soil]
material = "soft"
regions = ["box"]
[contact.a]
body = "soil"
rigid = "wall"
friction_angle = 0
)";
constexpr const char* plane = "surface = \"0.5 m\"\n[mesh]\nkind = \"box\"\nsize = [\"2 m\", \"1 m\"]\ncells = [40, 20]\n";
constexpr const char* space =
    "geometry = \"space\"\nsurface = \"0.5 m\"\n[mesh]\nkind = \"box\"\nsize = [\"1 m\", \"0.5 m\", \"0.5 m\"]\ncells = [10, 5, 5]\n";
constexpr const char* half_full = R"([body.soil]
material = "soft"
block.center = ["1 m", "0.25 m"]
block.size = ["2 m", "0.5 m"]
block.spacing = "16.6666666 mm"
[contact.a]
body = "soil"
rigid = "wall"
friction_angle = 0
)";
constexpr const char* two_soils = R"([body.front]
material = "soft"
block.center = ["1.501 m", "0.25 m"]
block.size = ["0.998 m", "0.5 m"]
block.spacing = "16.6333333 mm"
[body.behind]
material = "soft"
block.center = ["0.749 m", "0.25 m"]
block.size = ["0.498 m", "0.5 m"]
block.spacing = "16.6 mm"
[contact.a]
body = "front"
rigid = "wall"
friction_angle = 0
[contact.b]
body = "behind"
rigid = "wall"
friction_angle = 0
[contact.c]
body = "front"
other_body = "behind"
friction_angle = 0
)";

std::string wall_of(const char* center, const char* size, const char* more = "")
{
  return fmt::format("[rigid.wall]\nshape = \"box\"\nmass = 100\ncenter = {}\nsize = {}\n{}\n", center, size, more);
}
std::string moved(const char* kind, const char* until, const char* more = "")
{
  return fmt::format("[[stage]]\nname = \"{0}\"\nkind = \"{0}\"\nvelocity = \"0.05 m/s\"\nramp = \"0.1 s\"\nuntil.{1}\n{2}\n", kind, until,
                     more);
}

/// What check says of thin bodies, and whether it refuses.
struct Said {
  std::string line;
  bool refused;
};
Said said_of(const std::string& text)
{
  TemporaryFolder folder;
  folder.write("case.toml", "title = \"a wall\"\n" + text);
  const Ended ended = run_program(folder.path(), {"check", "case.toml", "--threads", "1"});
  std::istringstream lines(ended.err);
  for (std::string line; std::getline(lines, line);)
    if (line.find(" thick at ") != std::string::npos) return {line, ended.status == 2};
  EXPECT_EQ(ended.status, 0) << ended.err;
  return {"", false};
}
void expect_refused(const std::string& text, const std::vector<std::string>& parts)
{
  const Said said = said_of(text);
  EXPECT_TRUE(said.refused) << said.line;
  EXPECT_NE(said.line.find("case.toml:"), std::string::npos) << said.line;
  for (const std::string& part : parts) EXPECT_NE(said.line.find(part), std::string::npos) << part << " in " << said.line;
}

const std::string drag = moved("drag", "displacement = \"0.02 m\"", "vertical = \"fixed\"");

TEST(ThinBodies, in_soil_of_one_body_are_refused_with_thickness_cells_and_what_to_change)
{
  expect_refused(std::string(plane) + soil + box + wall_of("[\"1 m\", \"0.5 m\"]", "[\"4 mm\", \"0.6 m\"]") + drag,
                 {"rigid.wall: is 4 mm thick at x = ", "0.08 cells of 50 mm", "[body.soil]", "cells there 2 mm or smaller",
                  "body 0.1 m thick or more", "a body of soil on each side"});
}

// Contact reaches a cell: a cell on each side of a body of two cells has no node in common with the other. 5 % less is still two cells.
TEST(ThinBodies, of_two_cells_and_of_three_are_not_doubted)
{
  const auto wall = [](const char* size) { return std::string(plane) + soil + box + wall_of("[\"1.013 m\", \"0.5 m\"]", size) + drag; };
  for (const char* size : {"[\"96 mm\", \"0.6 m\"]", "[\"0.1 m\", \"0.6 m\"]", "[\"0.15 m\", \"0.6 m\"]"})
    EXPECT_EQ(said_of(wall(size)).line, "");
  expect_refused(wall("[\"90 mm\", \"0.6 m\"]"), {"1.8 cells of 50 mm"});
}

TEST(ThinBodies, may_move_edgeways_and_stand_between_two_bodies_of_soil)
{
  const std::string wall = wall_of("[\"1 m\", \"0.5 m\"]", "[\"4 mm\", \"0.6 m\"]");
  EXPECT_EQ(said_of(std::string(plane) + soil + box + wall + moved("push", "time = \"3 s\"")).line, "");
  EXPECT_EQ(said_of(std::string(plane) + soil + two_soils + wall_of("[\"1 m\", \"0.25 m\"]", "[\"4 mm\", \"0.6 m\"]") + drag).line, "");
}

TEST(ThinBodies, that_begin_in_the_air_are_refused_where_they_are_dragged_after_a_push)
{
  const std::string wall = wall_of("[\"1 m\", \"0.66 m\"]", "[\"20 mm\", \"0.3 m\"]"), push = moved("push", "embedment = \"0.25 m\"");
  const std::string begin = std::string(plane) + soil + half_full + wall + push;
  EXPECT_EQ(said_of(begin).line, "");
  expect_refused(begin + drag, {"rigid.wall", "0.4 cells of 50 mm"});
}

// A plate on the bed leaves a hole above it, a plate in the bed has soil there.
TEST(ThinBodies, are_refused_below_soil_and_not_below_the_hole_that_they_have_made)
{
  const std::string push = moved("push", "time = \"3 s\"");
  const auto plate = [&](const char* center) {
    return std::string(plane) + soil + half_full + wall_of(center, "[\"0.6 m\", \"20 mm\"]") + push;
  };
  EXPECT_EQ(said_of(plate("[\"1 m\", \"0.51 m\"]")).line, "");
  expect_refused(plate("[\"1 m\", \"0.3 m\"]"), {"20 mm thick"});
}

TEST(ThinBodies, of_every_shape_are_refused)
{
  const std::string begin = std::string(plane) + soil + box, name = "[rigid.wall]\nmass = 100\n";
  expect_refused(begin + name + "shape = \"circle\"\ncenter = [1, 0.5]\ndiameter = \"60 mm\"\n" + drag, {"60 mm thick"});
  expect_refused(begin + name + "shape = \"polygon\"\nx = [0.9, 1, 1, 0.9]\ny = [0.2, 0.2, 0.26, 0.26]\n" + moved("push", "time = \"3 s\""),
                 {"60 mm thick", "1.2 cells"});
  expect_refused("geometry = \"axisymmetric\"\n" + begin + name +
                     "shape = \"profile\"\nx = [0, 0.5, 0.5, 0]\ny = [0.4, 0.4, 0.46, 0.46]\n" + moved("push", "time = \"3 s\""),
                 {"60 mm thick", "1.2 cells"});
}

// Around an axis the two sides of a pile are a diameter apart, and the soil of one side is that of the other.
TEST(ThinBodies, around_the_axis_are_not_those_of_a_small_radius)
{
  EXPECT_EQ(said_of("geometry = \"axisymmetric\"\n" + std::string(plane) + soil + box +
                    "[rigid.wall]\nmass = 100\nshape = \"profile\"\nx = [0, 0.04, 0.04, 0]\ny = [0.4, 0.4, 2, 2]\n" +
                    moved("push", "time = \"3 s\""))
                .line,
            "");
}

TEST(ThinBodies, in_space_are_refused_as_in_the_plane)
{
  const std::string begin = std::string(space) + soil + box;
  const auto wall = [&](const char* size, const char* more) { return begin + wall_of("[0.5, 0.25, 0.25]", size, more) + drag; };
  expect_refused(wall("[\"50 mm\", \"0.3 m\", \"0.3 m\"]", ""), {"50 mm thick", "0.5 cells of 100 mm"});
  expect_refused(wall("[\"0.3 m\", \"0.3 m\", \"50 mm\"]", "tilt = [0, \"30 deg\", 0]"), {"50 mm thick"});
  EXPECT_EQ(said_of(wall("[\"0.3 m\", \"0.3 m\", \"50 mm\"]", "")).line, "");
  EXPECT_EQ(said_of(wall("[\"0.2 m\", \"0.3 m\", \"0.3 m\"]", "")).line, "");
  expect_refused(begin +
                     "[rigid.wall]\nmass = 9\nshape = \"cylinder\"\ncenter = [0.5, 0.25, 0.25]\naxis = [0, 1, 0]\ndiameter = \"0.12 "
                     "m\"\nlength = \"0.3 m\"\n" +
                     drag,
                 {"0.12 m thick"});
}

// How deep a force pushes is not known before the run.
TEST(ThinBodies, that_a_force_pushes_in_are_warned_of)
{
  const std::string fluke = wall_of("[\"1 m\", \"0.66 m\"]", "[\"20 mm\", \"0.3 m\"]");
  const std::string push = "[[stage]]\nname = \"sink\"\nkind = \"push\"\nforce = \"10 N/m\"\nuntil.time = \"0.1 s\"\n";
  const Said said = said_of(std::string(plane) + soil + half_full + fluke + push + drag);
  EXPECT_FALSE(said.refused);
  EXPECT_NE(said.line.find("may sink in"), std::string::npos) << said.line;
}

TEST(ThinBodies, that_are_held_in_soil_are_warned_of)
{
  const std::string wait = "[[stage]]\nname = \"wait\"\nkind = \"free\"\nuntil.time = \"0.1 s\"\n";
  const auto wall = [&](const char* width) { return std::string(plane) + soil + box + wall_of("[\"1.013 m\", \"0.5 m\"]", width) + wait; };
  const Said said = said_of(wall("[\"50 mm\", \"0.6 m\"]"));
  EXPECT_FALSE(said.refused);
  EXPECT_NE(said.line.find("1 cells of 50 mm"), std::string::npos) << said.line;
  EXPECT_EQ(said_of(wall("[\"0.1 m\", \"0.6 m\"]")).line, "");
}

}  // namespace
}  // namespace berm::sanity::this_file
