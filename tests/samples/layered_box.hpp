// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/read_case.hpp"

namespace berm::test {

/// A box of 2 m by 1 m on squares of 0.25 m: sand on clay from 0.3 m down, and a pipe of 0.7 m that lies on it and is pushed by 0.1 m and dragged by 0.5 m.
constexpr const char* layered_box_text = R"(title = "sand on clay"
gravity = [0, "-1 gravity"]
surface = "1 m"
[mesh]
kind = "box"
size = ["2 m", "1 m"]
cells = [8, 4]
[material.sand]
law = "mohr_coulomb"
density = "900 kg/m^3"
young_modulus = "7 MPa"
poisson_ratio = 0.25
friction_angle = "35 deg"
[material.clay]
law = "mohr_coulomb"
density = "600 kg/m^3"
young_modulus = "1 MPa"
poisson_ratio = 0.45
friction_angle = "0 deg"
cohesion = "2 kPa"
[body.bed]
material = "sand"
soil_layer = [{top = "0.3 m", material = "clay"}]
regions = ["box"]
k0 = 0.5
[rigid.pipe]
shape = "circle"
center = ["0.7 m", "1.35 m"]
diameter = "0.7 m"
mass = "100 kg/m"
[contact.skin]
body = "bed"
rigid = "pipe"
friction_angle = "20 deg"
[support.base]
boundary = "bottom"
fixed = ["x", "y"]
[support.left]
boundary = "left"
fixed = ["x"]
stages = ["rest"]
[[stage]]
name = "rest"
kind = "geostatic"
until.time = "1 ms"
[[stage]]
name = "push"
kind = "push"
velocity = "1 m/s"
until.embedment = "0.1 m"
[[stage]]
name = "drag"
kind = "drag"
velocity = "1 m/s"
until.displacement = "0.5 m"
)";

inline settings::Case layered_box(const std::vector<std::string>& changes = {}, const std::string& more = "")
{
  return input::read_case_text("case.toml", layered_box_text + more, changes);
}

}  // namespace berm::test
