// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/read_case.hpp"
#include "os/error.hpp"

namespace berm {

/// A footing of 1 m on a bed of cells of 0.2 m, by finite elements. `soil`: its material, random field and body, which is named soil; `interface`: keys of the contact.
struct RandomFooting {
  std::string soil, interface;

  settings::Case with(const std::vector<std::string>& overrides) const
  {
    return input::read_case_text("case.toml", bed + soil + "[contact.base]\nbody = \"soil\"\nrigid = \"footing\"\n" + interface, overrides);
  }

  /// The error of such a case, empty where there is none.
  std::string refusal(const std::vector<std::string>& overrides) const
  {
    try {
      with(overrides);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  static inline const std::string bed = R"(method = "fem"
[mesh]
kind = "seabed"
left = "2 m"
length = "4 m"
depth = "2 m"
headroom = "0.4 m"
near_size = "0.2 m"
near_left = "-0.6 m"
near_right = "0.6 m"
near_depth = "0.4 m"
near_height = "0.2 m"
growth = 0.5
[rigid.footing]
shape = "box"
center = ["0 m", "0.25 m"]
size = ["1 m", "0.5 m"]
[support.base]
boundary = "base"
fixed = ["x", "y"]
[[stage]]
name = "push"
kind = "push"
velocity = "40 mm/s"
until.embedment = "20 mm"
)";
};

/// On sand of 32 degrees, one property of which varies: `field` is its random_field.
inline RandomFooting footing_on_random_sand(const std::string& field)
{
  return {R"([material.sand]
law = "mohr_coulomb"
density = "900 kg/m^3"
inertia_density = "1900 kg/m^3"
young_modulus = "10 MPa"
poisson_ratio = 0.3
cohesion = "1 kPa"
friction_angle = "32 deg"
dilation_angle = "20 deg"
[body.soil]
material = "sand"
regions = ["near", "bed"]
k0 = 0.5
)" + field,
          "friction_angle = \"20 deg\"\n"};
}

}  // namespace berm
