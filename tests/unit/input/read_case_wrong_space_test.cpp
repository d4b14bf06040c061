// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"
#include "os/error.hpp"
#include "samples/small_cases.hpp"
#include "samples/wrong_inputs.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

/// A key with a value that is for another geometry, and what the message says.
struct WrongGeometry {
  const char* name;
  std::string override;
  std::vector<std::string> says;
};

void PrintTo(const WrongGeometry& wrong, std::ostream* stream)
{
  *stream << wrong.name;
}

std::string message_for(const std::string& text, const std::string& override)
{
  try {
    read_case_text("case.toml", text, {override});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expect_one_line(const std::string& message, const std::vector<std::string>& says)
{
  EXPECT_TRUE(message.starts_with("--set ") || message.starts_with("case.toml:")) << message;
  for (const std::string& part : says) EXPECT_NE(message.find(part), std::string::npos) << "no `" << part << "` in: " << message;
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
}

class WrongInSpace : public testing::TestWithParam<WrongGeometry> {};

TEST_P(WrongInSpace, is_refused_in_one_line_with_key_and_what_is_allowed)
{
  expect_one_line(message_for(test::small_space_case, GetParam().override), GetParam().says);
}

const std::string three = "needs 3 numbers, one per direction, and has 2";
const WrongGeometry in_space[] = {
    {"gravity_of_two", "gravity=[0, -9.81]", {"gravity", three}},
    {"center_of_two", "rigid.pipe.center=[0, 0.08]", {"rigid.pipe.center", three}},
    {"axis_of_two", "rigid.pipe.axis=[1, 0]", {"rigid.pipe.axis", "needs 3 numbers"}},
    {"velocity_of_two", "body.sand.initial_velocity=[{amplitude=[0, 1]}]", {"body.sand.initial_velocity[0].amplitude", three}},
    {"gravity_of_four", "gravity=[0, -9.81, 0, 0]", {"gravity", "and has 4"}},
    {"mass_per_metre", "rigid.pipe.mass=5 kg/m", {"rigid.pipe.mass", "wrong dimension", "expected a mass"}},
    {"inertia_per_metre", "rigid.pipe.moment_of_inertia=5 kg m", {"rigid.pipe.moment_of_inertia", "kg m^2"}},
    {"force_per_metre",
     "stage.push.until.force=4 kN/m",
     {"stage.push.until.force", "wrong dimension", "expected a force, such as \"500 N\""}},
    {"moment_per_metre", "stage.drag.drive.rotation_x.moment=4 N m/m", {"rotation_x.moment", "wrong dimension"}},
    {"rotation_of_the_plane", "stage.drag.drive.rotation.velocity=1", {"rotation", "is not a degree of freedom in space"}},
    {"direction_that_is_none", "support.base.fixed=[\"w\"]", {"support.base.fixed", "\"w\" is not a direction (allowed: x, y, z)"}},
    {"width_of_nothing", "mesh.width=0 m", {"mesh.width", "must be more than 0 m"}},
    {"plane_of_symmetry_across_gravity", "symmetry=[\"y\"]", {"symmetry", "not an axis with a plane of symmetry", "allowed: x, z"}},
    {"misspelt_key_of_space", "mesh.near_fornt=0.1 m", {"mesh.near_fornt", "near_front"}},
};
INSTANTIATE_TEST_SUITE_P(Table, WrongInSpace, testing::ValuesIn(in_space), [](const auto& row) { return std::string(row.param.name); });

class WrongInThePlane : public testing::TestWithParam<WrongGeometry> {};

TEST_P(WrongInThePlane, keys_of_space_are_refused)
{
  for (const char* geometry : {"plane_strain", "axisymmetric"}) {
    SCOPED_TRACE(geometry);
    std::string text(test::good_case);
    const auto replace = [&](const std::string& from, const std::string& to) { text.replace(text.find(from), from.size(), to); };
    if (geometry == std::string("axisymmetric")) {
      replace("gravity = [0", "geometry = \"axisymmetric\"\ngravity = [0");
      replace("center = [1.0, \"1.4 m\"]", "center = [0, \"1.4 m\"]");
      replace("mass = \"430 kg/m\"", "mass = \"430 kg\"");
      replace("kind = \"drag\"\nvelocity", "kind = \"push\"\nvelocity");
    }
    ASSERT_EQ(message_for(text, "title=a ball"), "");
    expect_one_line(message_for(text, GetParam().override), GetParam().says);
  }
}

const WrongGeometry of_space[] = {
    {"symmetry", "symmetry=[\"x\"]", {"symmetry", "are for geometry = \"space\""}},
    {"gravity_of_three", "gravity=[0, -9.81, 0]", {"gravity", "needs 2 numbers"}},
    {"center_of_three", "rigid.pipe.center=[0, 1.4, 0]", {"rigid.pipe.center", "needs 2 numbers"}},
    {"direction_z", "support.base.fixed=[\"x\", \"y\", \"z\"]", {"support.base.fixed", "(allowed: x, y)"}},
};
INSTANTIATE_TEST_SUITE_P(Table, WrongInThePlane, testing::ValuesIn(of_space), [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace berm::input::this_file
