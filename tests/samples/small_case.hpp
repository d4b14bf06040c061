// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm::test {

/// A pipe on sand, coarse and driven fast: a tenth of a second of computing. Rest, push by 2 mm, drag by 2 mm.
constexpr const char* small_case = R"(title = "a pipe on sand, small and coarse"
gravity = [0, "-50 gravity"]
surface = "40 mm"

[mesh]
kind = "box"
size = ["120 mm", "60 mm"]
cells = [30, 15]

[material.sand]
law = "mohr_coulomb"
density = "877 kg/m^3"
young_modulus = "7 MPa"
poisson_ratio = 0.25
friction_angle = "35 deg"

[body.sand]
material = "sand"
damping = 0.05
k0 = 0.43

[body.sand.block]
center = ["60 mm", "20 mm"]
size = ["120 mm", "40 mm"]
spacing = "1.3333333 mm"

[rigid.pipe]
shape = "circle"
center = ["50 mm", "50 mm"]
diameter = "20 mm"
mass = "1 kg/m"

[contact.skin]
body = "sand"
rigid = "pipe"
friction_angle = "23 deg"

[support.base]
boundary = "bottom"
fixed = ["x", "y"]
[support.left]
boundary = "left"
fixed = ["x"]
[support.right]
boundary = "right"
fixed = ["x"]

[[stage]]
name = "rest"
kind = "geostatic"
damping = 0.7
until.time = "1 ms"

[[stage]]
name = "push"
kind = "push"
velocity = "1 m/s"
ramp = "0.5 ms"
until.embedment = "2 mm"

[[stage]]
name = "drag"
kind = "drag"
velocity = "1 m/s"
ramp = "0.5 ms"
until.displacement = "2 mm"

[output]
history_time = "0.05 ms"
frame_travel = "1 mm"
)";

}  // namespace berm::test
