// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/penetrometer.hpp"

#include <array>

namespace berm::formulas {
namespace {

constexpr const char *cavity_range = "I_r > 1", *cone_range = "50 <= I_r <= 500, cone of 60 deg";

bool is_rough(Real roughness)
{
  return within(roughness, 0, 1);
}

bool is_of_cones(const DeepInClay& cone)
{
  return within(cone.rigidity_index, 50, 500) && is_rough(cone.roughness) && within(cone.anisotropy, -1, 1);
}

}  // namespace

Formula sphere_limit(Real rigidity_index)
{
  constexpr Source source{Label::exact, "limit pressure of a spherical cavity, Gibson and Anderson 1961", cavity_range};
  return formula(4. / 3 * (1 + std::log(rigidity_index)), source, rigidity_index > 1);
}

Formula cylinder_limit(Real rigidity_index)
{
  constexpr Source source{Label::exact, "limit pressure of a cylindrical cavity, Gibson and Anderson 1961", cavity_range};
  return formula(1 + std::log(rigidity_index), source, rigidity_index > 1);
}

Formula cone_factor_strain_path(const DeepInClay& cone)
{
  constexpr Source source{Label::recalled, "Teh and Houlsby 1991", cone_range};
  const Real sphere = 4. / 3 * (1 + std::log(cone.rigidity_index));
  return formula(sphere * (1.25 + cone.rigidity_index / 2000) + 2.2 * cone.roughness - 1.8 * cone.anisotropy, source, is_of_cones(cone));
}

Formula cone_factor_remeshed(const DeepInClay& cone)
{
  constexpr Source source{Label::recalled, "Lu and others 2004", cone_range};
  return formula(3.4 + 1.6 * std::log(cone.rigidity_index) - 1.9 * cone.anisotropy + 1.3 * cone.roughness, source, is_of_cones(cone));
}

Formula cone_factor_steady(const DeepInClay& cone)
{
  constexpr Source source{Label::recalled, "Abu-Farsakh, Tumay and Voyiadjis 2003", cone_range};
  return formula(2.45 + 1.8 * std::log(cone.rigidity_index) - 2.1 * cone.anisotropy, source, is_of_cones(cone));
}

Formula ball_factor(Real roughness)
{
  constexpr Source source{Label::recalled, "Randolph, Martin and Hu 2000, mean of the bounds", "deep"};
  constexpr Real smooth = (11.0 + 11.8) / 2, rough = (15.1 + 15.3) / 2;
  return formula(smooth + roughness * (rough - smooth), source, is_rough(roughness));
}

Formula smooth_sphere(Real w_over_D)
{
  constexpr Source source{Label::exact, "characteristics, wished in place", "smooth, uniform s_u, 0.05 <= w/D <= 0.5"};
  constexpr std::array w{0.05, 0.1, 0.3, 0.5}, V{0.787, 1.446, 3.198, 3.930};
  std::size_t k = 0;
  while (k + 2 < w.size() && w_over_D > w[k + 1]) ++k;
  const Real power = std::log(V[k + 1] / V[k]) / std::log(w[k + 1] / w[k]);
  return formula(V[k] * std::pow(w_over_D / w[k], power), source, within(w_over_D, w.front(), w.back()));
}

Formula deep_plate_factor(Real roughness)
{
  constexpr Source source{Label::recalled, "Martin and Randolph 2001", "deep"};
  return formula(12.42 + roughness * (13.11 - 12.42), source, is_rough(roughness));
}

}  // namespace berm::formulas
