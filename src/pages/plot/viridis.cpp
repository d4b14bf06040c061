// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/plot/isometric_raster_test.cpp
#include "plot/viridis.hpp"

#include "plot/nice_number.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace berm::plot {
namespace {

// Ten equally spaced ones.
constexpr std::array<unsigned, 10> viridis_colors = {0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e,
                                                     0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725};

Real channel(unsigned color, int k)
{
  return color >> (8 * (2 - k)) & 0xff;
}

}  // namespace

Rgb viridis(Real part)
{
  const Real at = std::clamp<Real>(part, 0, 1) * (viridis_colors.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), viridis_colors.size() - 2);
  Rgb mixed;
  for (int k = 0; k < 3; ++k)
    mixed[k] = std::lerp(channel(viridis_colors[below], k), channel(viridis_colors[below + 1], k), at - static_cast<Real>(below));
  return mixed;
}

std::string viridis_palette()
{
  std::vector<std::string> entries;
  for (const unsigned color : viridis_colors) entries.push_back(fmt::format("{} '#{:06x}'", entries.size(), color));
  return fmt::format("set palette defined ({})\n", fmt::join(entries, ", "));
}

std::pair<Real, Real> color_range(std::vector<Real> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t part = values.size() / 100;
  const auto end = [](Real hundredth, Real farthest) { return hundredth > 0 ? hundredth : std::max(Real(0), farthest); };
  const Real above = end(values[values.size() - 1 - part], values.back()), below = end(-values[part], -values.front());
  return {below > 0 ? -round_up(below) : 0, above > 0 || below == 0 ? round_up(above) : 0};
}

}  // namespace berm::plot
