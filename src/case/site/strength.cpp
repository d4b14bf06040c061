// SPDX-License-Identifier: BSD-3-Clause
#include "site/strength.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace berm::site {
namespace {

constexpr Real gamma_w = 9810, p_a = 100e3, degree = std::numbers::pi / 180;

Real friction_of(const Layer& layer, Real submerged_unit_weight, Correlation correlation)
{
  const Real sigma = submerged_unit_weight * layer.middle;
  if (correlation == Correlation::robertson_campanella) return std::atan((std::log10(layer.q_t / sigma) + 0.29) / 2.68);
  return degree * (17.6 + 11 * std::log10(layer.q_t / p_a / std::sqrt(sigma / p_a)));
}

}  // namespace

std::vector<Layer> layers_of(const Sounding& sounding)
{
  std::vector<Layer> layers;
  Real top = 0;
  for (std::size_t first = 0; first < sounding.depth.size();) {
    Real end = top + std::max(0.1, 0.1 * top);
    while (sounding.depth[first] >= end) {
      top = end;
      end = top + std::max(0.1, 0.1 * top);
    }
    std::size_t last = first;
    Layer layer{top, 0, 0};
    for (; last < sounding.depth.size() && sounding.depth[last] < end; ++last) {
      layer.middle += sounding.depth[last];
      layer.q_t += sounding.q_t[last];
    }
    const auto count = static_cast<Real>(last - first);
    layers.push_back({top, layer.middle / count, layer.q_t / count});
    first = last;
    top = end;
  }
  return layers;
}

std::vector<Strength> undrained_strength(const Sounding& sounding, Real submerged_unit_weight, Real N_kt)
{
  std::vector<Strength> all;
  for (const Layer& layer : layers_of(sounding)) {
    const Real s_u = (layer.q_t - (submerged_unit_weight + gamma_w) * layer.middle) / N_kt;
    if (s_u <= 0)
      throw InputError(fmt::format("{}: at a depth of {:.2f} m the cone resistance is {:.1f} kPa, no more than the weight above: clay has "
                                   "no strength there. Is its zero that at the seabed?",
                                   sounding.file, layer.middle, layer.q_t / 1000));
    all.push_back({layer.top, layer.middle, s_u});
  }
  return all;
}

std::vector<Strength> friction_angle(const Sounding& sounding, Real submerged_unit_weight, Correlation correlation)
{
  std::vector<Strength> all;
  Real low = 0, high = 0;
  std::size_t together = 0;
  for (const Layer& layer : layers_of(sounding)) {
    const Real phi = layer.middle > 0 && layer.q_t > 0 ? std::min(friction_of(layer, submerged_unit_weight, correlation), 45 * degree) : 0;
    if (!(phi >= 25 * degree))
      throw InputError(fmt::format("{}: at a depth of {:.2f} m the cone resistance of {:.0f} kPa is that of no sand, as the angle of "
                                   "friction would be less than 25 deg: begin with a kind in clay",
                                   sounding.file, layer.middle, layer.q_t / 1000));
    low = together > 0 ? std::min(low, phi) : phi;
    high = together > 0 ? std::max(high, phi) : phi;
    if (together > 0 && high - low <= 2 * degree) {
      Strength& last = all.back();
      const auto n = static_cast<Real>(together);
      last = {last.top, (n * last.middle + layer.middle) / (n + 1), (n * last.value + phi) / (n + 1)};
      ++together;
    } else {
      all.push_back({layer.top, layer.middle, phi});
      low = high = phi;
      together = 1;
    }
  }
  return all;
}

}  // namespace berm::site
