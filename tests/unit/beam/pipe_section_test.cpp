// SPDX-License-Identifier: BSD-3-Clause
#include "beam/pipe_section.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::beam::this_file {
namespace {

// A 16 inch pipe: numbers by hand.
const Pipe pipe = {0.4, 0.015, 206e9, 0.3, 1.17e-5, 7850, 800, 1025};

TEST(PipeSection, has_the_stiffness_mass_and_weight_of_a_thick_ring)
{
  const Section section = section_of(pipe);
  const Real area = pi / 4 * (0.4 * 0.4 - 0.37 * 0.37), inertia = pi / 64 * (std::pow(0.4, 4) - std::pow(0.37, 4));
  EXPECT_NEAR(section.bending_stiffness, 206e9 * inertia, 1e-9 * 206e9 * inertia);
  EXPECT_NEAR(section.axial_stiffness, 206e9 * area, 1e-9 * 206e9 * area);
  const Real own = 7850 * area + 800 * pi / 4 * 0.37 * 0.37, water = 1025 * pi / 4 * 0.4 * 0.4;
  EXPECT_NEAR(section.axial_mass, own, 1e-9 * own);
  EXPECT_NEAR(section.mass, own + water, 1e-9 * own);
  EXPECT_NEAR(section.submerged_weight, 9.80665 * (own - water), 1e-6 * own);
  EXPECT_EQ(section.radius, 0.2);
}

/// The effective force of a pipe of thick wall that cannot get longer, by summing its stresses (Lame 1852) over rings: sigma_z = nu (sigma_r + sigma_theta) - E alpha dT, less the pressure on the content.
Real compression_by_rings(Real warmer, Real pressure)
{
  const Real a = pipe.outer_diameter / 2 - pipe.wall, b = pipe.outer_diameter / 2;
  constexpr int rings = 2000;
  Real force = -pressure * pipe.inner_area();
  for (int i = 0; i < rings; ++i) {
    const Real r = a + (b - a) * (i + 0.5) / rings, even = pressure * a * a / (b * b - a * a), varying = even * b * b / (r * r);
    const Real stress = pipe.poisson_ratio * ((even - varying) + (even + varying)) - pipe.young_modulus * pipe.expansion * warmer;
    force += stress * 2 * pi * r * (b - a) / rings;
  }
  return -force;
}

TEST(PipeSection, that_cannot_get_longer_is_compressed_by_heat_and_pressure_as_its_stresses_add_up)
{
  for (const auto& [warmer, pressure] : {std::pair{35., 0.}, std::pair{0., 10e6}, std::pair{60., 25e6}}) {
    const Real expected = compression_by_rings(warmer, pressure);
    EXPECT_NEAR(constrained_force(pipe, warmer, pressure, 0), expected, 1e-6 * expected);
    EXPECT_NEAR(constrained_force(pipe, warmer, pressure, 50e3), expected - 50e3, 1e-6 * expected);
  }
}

}  // namespace
}  // namespace berm::beam::this_file
