// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm::test {

/// Half of a short pipe on a seabed in space, coarse and driven fast: a second of computing. Pushed by 15 mm, then dragged by 30 mm along z: its weight may sink it,
/// and it may turn about its axis.
constexpr const char* small_space_case = R"(title = "a pipe with ends on a small seabed in space"
geometry = "space"
symmetry = ["x"]
gravity = [0, "-1 gravity", 0]
initial_state = "gravity_loading"

[mesh]
kind = "seabed"
left = 0
length = "0.3 m"
back = "0.2 m"
width = "0.4 m"
depth = "0.25 m"
headroom = "0.1 m"
near_size = "40 mm"
near_left = 0
near_right = "0.16 m"
near_back = "-0.1 m"
near_front = "0.1 m"
near_depth = "80 mm"
near_height = "40 mm"
growth = 0.4
far_size = "0.1 m"

[material.clay]
law = "mohr_coulomb"
density = "1600 kg/m^3"
young_modulus = "500 kPa"
poisson_ratio = 0.45
cohesion = "2 kPa"
friction_angle = 0

[body.sand]
material = "clay"
regions = ["near", "bed"]
particles_per_cell = 1
k0 = 0.8
damping = 0.05

[rigid.pipe]
shape = "cylinder"
center = [0, "80 mm", 0]
axis = [1, 0, 0]
diameter = "0.16 m"
length = "0.2 m"
mass = "5 kg"

[contact.skin]
body = "sand"
rigid = "pipe"
friction_angle = 0
adhesion = "1 kPa"

[support.base]
boundary = "base"
fixed = ["x", "y", "z"]
[support.right]
boundary = "right"
fixed = ["x"]
[support.front]
boundary = "front"
fixed = ["z"]
[support.back]
boundary = "back"
fixed = ["z"]

[[stage]]
name = "push"
kind = "push"
velocity = "0.25 m/s"
ramp = "4 ms"
until.embedment = "15 mm"

[[stage]]
name = "drag"
kind = "drive"
ramp = "4 ms"
drive = {z.velocity = "0.25 m/s", y.free = true, rotation_x.free = true}
until.displacement = "30 mm"

[output]
history_time = "2 ms"
frame_travel = "10 mm"
)";

}  // namespace berm::test
