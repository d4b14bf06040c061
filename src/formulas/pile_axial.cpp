// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/pile_axial.hpp"

#include "formulas/points.hpp"

#include <array>

namespace berm::formulas {
namespace {

constexpr Source clay{Label::fit, "API RP 2GEO, clay", "s_u/sigma_v <= 3"};
constexpr Source sand{Label::fit, "API RP 2A-WSD (2000), sand", "15 <= delta <= 35 deg"};

constexpr std::array angles{15., 20., 25., 30., 35.};  // deg

bool is_of_sand(Real interface_angle)
{
  return within(interface_angle, angles.front() * degree, angles.back() * degree);
}

}  // namespace

Formula api_clay_friction(Real strength, Real overburden)
{
  if (!(overburden > 0)) return formula(nan, clay, false);
  const Real psi = strength / overburden, alpha = std::min(0.5 * std::pow(psi, psi > 1 ? -0.25 : -0.5), Real(1));
  return formula(alpha * strength, clay, strength > 0 && psi <= 3);
}

Formula api_sand_friction(Real overburden, Real interface_angle, bool closed)
{
  constexpr std::array most{47.8e3, 67e3, 81.3e3, 95.7e3, 114.8e3};
  const Real friction = (closed ? 1 : 0.8) * overburden * std::tan(interface_angle);
  return formula(std::min(friction, along_points(angles, most, interface_angle / degree)), sand, is_of_sand(interface_angle));
}

Formula api_clay_base(Real strength)
{
  return formula(9 * strength, clay, strength > 0);
}

Formula api_sand_base(Real overburden, Real interface_angle)
{
  constexpr std::array N_q{8., 12., 20., 40., 50.}, most{1.9e6, 2.9e6, 4.8e6, 9.6e6, 12e6};
  const Real delta = interface_angle / degree;
  return formula(std::min(along_points(angles, N_q, delta) * overburden, along_points(angles, most, delta)), sand,
                 is_of_sand(interface_angle));
}

Real api_clay_friction_share(Real displacement, Real diameter)
{
  constexpr std::array over_D{0., 0.0016, 0.0031, 0.0057, 0.008, 0.01, 0.02}, share{0., 0.3, 0.5, 0.75, 0.9, 1., 0.9};
  return along_points(over_D, share, displacement / diameter);
}

Real api_sand_friction_share(Real displacement)
{
  constexpr Real inch = 0.0254;
  return std::min(displacement / (0.1 * inch), Real(1));
}

Real api_base_share(Real displacement, Real diameter)
{
  constexpr std::array over_D{0., 0.002, 0.013, 0.042, 0.073, 0.1}, share{0., 0.25, 0.5, 0.75, 0.9, 1.};
  return along_points(over_D, share, displacement / diameter);
}

}  // namespace berm::formulas
