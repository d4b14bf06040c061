// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/read_case.hpp"

namespace berm {

/// A strip footing of 1 m that sticks to weightless clay with s_u = 10 kPa, in so few elements that a probe takes a second.
inline constexpr const char* coarse_footing = R"(method = "fem"
[mesh]
kind = "seabed"
length = "5 m"
depth = "1.5 m"
headroom = "0.2 m"
near_size = "0.1 m"
near_left = "-0.6 m"
near_right = "0.6 m"
near_depth = "0.2 m"
near_height = "0.1 m"
growth = 0.4
far_size = "0.5 m"
[fem]
contact_size = "50 mm"
[material.clay]
law = "mohr_coulomb"
density = "1800 kg/m^3"
young_modulus = "20 MPa"
poisson_ratio = 0.49
cohesion = "10 kPa"
friction_angle = "0 deg"
[body.clay]
material = "clay"
regions = ["near", "bed"]
[rigid.footing]
shape = "box"
center = [0, "0.25 m"]
size = ["1 m", "0.5 m"]
[contact.base]
body = "clay"
rigid = "footing"
friction_angle = "0 deg"
scheme = "tied"
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
name = "push"
kind = "push"
velocity = "0.1 m/s"
until.time = "1 s"
)";

inline settings::Case footing(const std::vector<std::string>& set = {})
{
  return input::read_case_text("footing.toml", coarse_footing, set);
}

/// The same as a half of a square footing in space, the plane of symmetry across z.
inline settings::Case footing_in_space(const std::vector<std::string>& set = {})
{
  std::vector<std::string> all = {"method=mpm",
                                  "geometry=space",
                                  "symmetry=[\"z\"]",
                                  "mesh.back=0",
                                  "mesh.width=2",
                                  "mesh.near_back=0",
                                  "mesh.near_front=0.6",
                                  "rigid.footing.center=[0, 0.25, 0]",
                                  "rigid.footing.size=[1, 0.5, 1]",
                                  "rigid.footing.mass=500",
                                  "support.base.fixed=[\"x\",\"y\",\"z\"]"};
  all.insert(all.end(), set.begin(), set.end());
  return footing(all);
}

}  // namespace berm
