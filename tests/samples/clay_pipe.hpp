// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/read_case.hpp"

namespace berm {

/// A smooth pipe of 1 m, 0.4 D deep in weightless clay with s_u = 10 kPa, in so few elements that a probe takes a quarter of a second.
inline constexpr const char* coarse_clay = R"(method = "fem"
[mesh]
kind = "seabed"
length = "4 m"
depth = "1.6 m"
headroom = "0.5 m"
near_size = "0.2 m"
near_left = "-0.7 m"
near_right = "0.7 m"
near_depth = "0.6 m"
near_height = "0.2 m"
growth = 0.4
[fem]
contact_size = "0.1 m"
[material.clay]
law = "mohr_coulomb"
density = "1800 kg/m^3"
young_modulus = "20 MPa"
poisson_ratio = 0.45
cohesion = "10 kPa"
friction_angle = "0 deg"
[body.clay]
material = "clay"
regions = ["near", "bed"]
[rigid.pipe]
shape = "circle"
center = [0, "0.1 m"]
diameter = "1 m"
[contact.skin]
body = "clay"
rigid = "pipe"
friction_angle = 0
[support.left]
boundary = "left"
fixed = ["x"]
[support.right]
boundary = "right"
fixed = ["x"]
[support.base]
boundary = "base"
fixed = ["x", "y"]
[[stage]]
name = "rest"
kind = "geostatic"
until.time = "1 s"
[[stage]]
name = "drag"
kind = "drag"
velocity = "-0.1 m/s"
ramp = "0.2 s"
vertical = "fixed"
until.time = "1 s"
)";

inline settings::Case clay(const std::vector<std::string>& set = {})
{
  return input::read_case_text("clay.toml", coarse_clay, set);
}

}  // namespace berm
