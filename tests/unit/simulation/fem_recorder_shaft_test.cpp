// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"
#include "run_folder/history.hpp"
#include "samples/program.hpp"
#include "simulation/simulate.hpp"

#include <gtest/gtest.h>
#include <numbers>
#include <spdlog/sinks/ostream_sink.h>
#include <sstream>

namespace berm::simulation::this_file {
namespace {

constexpr const char* pile_in_clay = R"(
gravity = [0, 0]
method = "fem"
geometry = "axisymmetric"
fem.contact_size = "0.1 m"
[mesh]
kind = "seabed"
length = "3 m"
left = 0
depth = "3 m"
headroom = "0.5 m"
near_size = "0.2 m"
near_left = 0
near_right = "1 m"
near_depth = "1.5 m"
near_height = "0.3 m"
growth = 0.3
[material.clay]
law = "clay"
density = 1000
undrained_strength = "2 kPa"
rigidity_index = 200
poisson_ratio = 0.49
[body.clay]
material = "clay"
regions = ["near", "bed"]
[rigid.pile]
shape = "box"
size = ["1 m", "1.2 m"]
center = [0, "-0.4 m"]
mass = "1 kg"
[contact.skin]
body = "clay"
rigid = "pile"
friction_angle = 0
adhesion = "0.5 kPa"
tension = "unlimited"
[support.base]
boundary = "base"
fixed = ["x", "y"]
[support.right]
boundary = "right"
fixed = ["x"]
[[stage]]
name = "rest"
kind = "geostatic"
[[stage]]
name = "load"
kind = "push"
velocity = "10 mm/s"
until.embedment = "1.02 m"
)";

TEST(ShaftOfElements, takes_the_adhesion_of_the_side_and_nothing_of_the_base)
{
  TemporaryFolder folder;
  folder.write("case.toml", pile_in_clay);
  std::ostringstream messages;
  Context context(
      1, [] { return false; }, std::make_shared<spdlog::sinks::ostream_sink_mt>(messages));
  ASSERT_TRUE(run_case({input::read_case(folder / "case.toml"), folder / "case.toml", folder / "run", false}, context));
  const run_folder::History history = run_folder::read_history(folder / "run/history.csv");
  const Real shaft = history["V_shaft_N"].back();
  // A side of 1 m at a radius of 0.5 m. Of the last side of an element, 0.1 m, the sixth that belongs to its corner counts to the base.
  const Real whole = 2 * std::numbers::pi * 0.5 * 1 * 500;
  EXPECT_NEAR(shaft, whole * (1 - 0.1 / 6), 0.003 * whole);
}

}  // namespace
}  // namespace berm::simulation::this_file
