// SPDX-License-Identifier: BSD-3-Clause
#include "site/strength.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::site {
namespace {

constexpr Real least_friction_angle = 25 * degree;

/// Layers without strength, of all, beyond which the sounding is none of this kind of soil, or its zero or unit is wrong.
constexpr Real most_without = 0.25;

void refuse_many(const Sounding& sounding, const StrengthProfile& profile, std::size_t layers, const std::string& why)
{
  if (static_cast<Real>(profile.without.size()) <= most_without * static_cast<Real>(layers) && profile.without.size() < layers) return;
  const Layer& first = profile.without.front();
  throw InputError(fmt::format("{}: at a depth of {:.2f} m the cone resistance is {:.1f} kPa, {} ({} of {} layers)", sounding.file,
                               first.middle, first.q_t / 1000, why, profile.without.size(), layers));
}

}  // namespace

Real friction_of(Real q_t, Real effective_stress, Correlation correlation)
{
  if (correlation == Correlation::robertson_campanella) return std::atan((std::log10(q_t / effective_stress) + 0.29) / 2.68);
  return degree * (17.6 + 11 * std::log10(q_t / p_a / std::sqrt(effective_stress / p_a)));
}

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

StrengthProfile undrained_strength(const Sounding& sounding, Real submerged_unit_weight, Real N_kt)
{
  StrengthProfile profile;
  const std::vector<Layer> layers = layers_of(sounding);
  for (const Layer& layer : layers) {
    const Real s_u = (layer.q_t - (submerged_unit_weight + gamma_w) * layer.middle) / N_kt;
    if (s_u > 0)
      profile.strength.push_back({layer.top, layer.middle, s_u});
    else
      profile.without.push_back(layer);
  }
  refuse_many(sounding, profile, layers.size(),
              "not more than the overburden: clay has no strength there. Is its unit right, and its zero that at the seabed?");
  return profile;
}

StrengthProfile friction_angle(const Sounding& sounding, Real submerged_unit_weight, Correlation correlation)
{
  StrengthProfile profile;
  Real low = 0, high = 0;
  std::size_t together = 0;
  const std::vector<Layer> layers = layers_of(sounding);
  for (const Layer& layer : layers) {
    const Real phi = layer.middle > 0 && layer.q_t > 0
                         ? std::min(friction_of(layer.q_t, submerged_unit_weight * layer.middle, correlation), most_friction_angle)
                         : 0;
    if (!(phi >= least_friction_angle)) {
      profile.without.push_back(layer);
      continue;
    }
    low = together > 0 ? std::min(low, phi) : phi;
    high = together > 0 ? std::max(high, phi) : phi;
    if (together > 0 && high - low <= 2 * degree) {
      Strength& last = profile.strength.back();
      const auto n = static_cast<Real>(together);
      last = {last.top, (n * last.middle + layer.middle) / (n + 1), (n * last.value + phi) / (n + 1)};
      ++together;
    } else {
      profile.strength.push_back({layer.top, layer.middle, phi});
      low = high = phi;
      together = 1;
    }
  }
  refuse_many(sounding, profile, layers.size(),
              "too low for sand, as the angle of friction would be less than 25 deg: start with a kind in clay, unless its unit is wrong");
  return profile;
}

}  // namespace berm::site
