// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"
#include "os/error.hpp"
#include "samples/wrong_inputs.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

/// What refuses the good case with an active distance and these keys; "" where nothing does.
std::string refusal_with(std::vector<std::string> keys, const std::string& more = "")
{
  keys.emplace(keys.begin(), "mpm.active_distance=1.6 m");
  try {
    read_case_text("case.toml", std::string(test::good_case) + more, keys);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expect_refusal(const std::vector<std::string>& keys, const std::string& says, const std::string& more = "")
{
  const std::string refusal = refusal_with(keys, more);
  EXPECT_NE(refusal.find("mpm.active_distance"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find(says), std::string::npos) << "no `" << says << "` in: " << refusal;
}

TEST(ActiveDistance, is_absent_or_a_length)
{
  EXPECT_EQ(read_case_text("case.toml", std::string(test::good_case)).mpm.active_distance, std::nullopt);
  EXPECT_EQ(read_case_text("case.toml", std::string(test::good_case), {"mpm.active_distance=1.6 m"}).mpm.active_distance, 1.6);
  EXPECT_NE(refusal_with({"mpm.active_distance=0"}).find("must be more than 0 m"), std::string::npos);
}

TEST(ActiveDistance, is_refused_where_something_else_than_a_rigid_body_with_bounds_moves_soil)
{
  expect_refusal({"gravity_ramp=0.1 s"}, "gravity_ramp");
  expect_refusal({}, "tractions", "[traction.load]\nboundary = \"top\"\npressure = \"1 kPa\"\n");
  expect_refusal({"contact.pipe_on_bed.scheme=usf"}, "usf");
  expect_refusal({"body.bed.initial_angular_velocity=1 rad/s"}, "velocity of [body.bed]");
  expect_refusal({"material.sand.water.drainage=consolidation", "material.sand.water.permeability=1e-5 m/s",
                  "material.sand.water.porosity=0.4", "material.sand.inertia_density=2000 kg/m^3",
                  "contact.pipe_on_bed.scheme=musl_coupled"},
                 "water that flows");
}

TEST(ActiveDistance, is_refused_without_a_body_that_soil_can_be_far_from)
{
  std::string text(test::good_case);
  const auto replace = [&](const std::string& from, const std::string& to) { text.replace(text.find(from), from.size(), to); };
  replace("shape = \"circle\"\ncenter = [1.0, \"1.4 m\"]\ndiameter = \"0.8 m\"",
          "shape = \"half_plane\"\npoint = [1.0, 1.0]\nnormal = [0, -1]");
  try {
    read_case_text("case.toml", text, {"mpm.active_distance=1 m"});
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("needs a rigid body with bounds"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace berm::input::this_file
