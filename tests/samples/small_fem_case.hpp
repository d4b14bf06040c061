// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm::test {

/// A pipe in clay, half of it below the surface: coarse, less than a second of computing. Rest, push to 60 N/m, drag by 0.4 mm.
constexpr const char* small_fem_case = R"(title = "a pipe in clay, small and coarse"
method = "fem"

[mesh]
kind = "seabed"
length = "200 mm"
depth = "80 mm"
headroom = "20 mm"
near_size = "8 mm"
near_left = "-20 mm"
near_right = "20 mm"
near_depth = "20 mm"
near_height = "10 mm"
growth = 0.3
far_size = "20 mm"

[fem]
contact_size = "4 mm"

[material.clay]
law = "mohr_coulomb"
density = "800 kg/m^3"
young_modulus = "1 MPa"
poisson_ratio = 0.45
cohesion = "1 kPa"
friction_angle = 0

[body.clay]
material = "clay"
regions = ["near", "bed"]

[rigid.pipe]
shape = "circle"
center = [0, 0]
diameter = "20 mm"
mass = 1

[contact.skin]
body = "clay"
rigid = "pipe"
friction_angle = 0
adhesion = "500 Pa"

[support.base]
boundary = "base"
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
until.time = "1 ms"

[[stage]]
name = "push"
kind = "push"
velocity = "1 m/s"
until.force = 60

[[stage]]
name = "drag"
kind = "drag"
velocity = "1 m/s"
until.displacement = "0.4 mm"

[watch.deep]
body = "clay"
point = [0, "-50 mm"]
)";

}  // namespace berm::test
