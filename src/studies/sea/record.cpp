// SPDX-License-Identifier: BSD-3-Clause
#include "sea/record.hpp"

#include <algorithm>
#include <numeric>
#include <random>

namespace berm::sea {
namespace {

constexpr Real negligible = 1e-4;  // amplitude of a component over the largest

/// Two numbers of the standard normal distribution, by Box and Muller.
std::pair<Real, Real> two_normal(std::mt19937_64& random)
{
  const auto uniform = [&] { return (static_cast<Real>(random() >> 11) + 0.5) * 0x1p-53; };
  const Real radius = std::sqrt(-2 * std::log(uniform())), angle = 2 * pi * uniform();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Amplitudes of the velocity at the seabed now, and how they turn in a step.
struct Components {
  std::vector<Real> frequency, cosine, sine, turn_cosine, turn_sine;
};

Components components_of(const SeaCase& c, unsigned seed, Real step)
{
  const formulas::WaveSpectrum& spectrum = *c.spectrum;
  const Real distance = 2 * pi / c.sea.duration;
  std::mt19937_64 random(seed);
  const auto first = std::max(static_cast<int>(std::ceil(spectrum.first() / distance)), 1),
             last = static_cast<int>(spectrum.last() / distance);
  const auto size_of = [&](int n) {
    return formulas::velocity_at_seabed(n * distance, c.sea.depth) * std::sqrt(spectrum.density(n * distance) * distance);
  };
  Real largest = 0;
  for (int n = first; n <= last; ++n) largest = std::max(largest, size_of(n));
  Components all;
  for (int n = first; n <= last; ++n) {
    const auto [a, b] = two_normal(random);
    const Real w = n * distance, size = size_of(n);
    if (!(size > negligible * largest)) continue;
    all.frequency.push_back(w);
    all.cosine.push_back(size * a), all.sine.push_back(size * b);
    all.turn_cosine.push_back(std::cos(w * step)), all.turn_sine.push_back(std::sin(w * step));
  }
  return all;
}

}  // namespace

LoadRecord realisation(const SeaCase& c, const RecordFactors& factors, unsigned seed)
{
  LoadRecord record;
  record.step = c.record.step.value_or(2 * pi / c.spectrum->peak() / 40);
  Components parts = components_of(c, seed, record.step);
  const auto rows = static_cast<std::size_t>(c.sea.duration / record.step) + 1;
  const settings::WaterSettings water = water_of(c);
  for (std::size_t row = 0; row < rows; ++row) {
    Real velocity = 0, acceleration = 0;
    for (std::size_t n = 0; n < parts.frequency.size(); ++n) {
      const Real x = parts.cosine[n], y = parts.sine[n];
      velocity += x;
      acceleration -= parts.frequency[n] * y;
      parts.cosine[n] = x * parts.turn_cosine[n] - y * parts.turn_sine[n];
      parts.sine[n] = x * parts.turn_sine[n] + y * parts.turn_cosine[n];
    }
    const Real u = factors.direction * velocity + factors.current, a = factors.direction * acceleration;
    record.velocity.push_back(u), record.acceleration.push_back(a);
    const settings::WaterForce force = water_force(water, {u, a}, c.pipe.diameter, 0, factors.embedment);
    record.H.push_back(force.H), record.V.push_back(force.V);
  }
  return record;
}

std::vector<LoadWave> waves_of(const LoadRecord& record)
{
  const std::vector<Real>&H = record.H, &u = record.velocity;
  const Real mean = std::accumulate(u.begin(), u.end(), Real(0)) / static_cast<Real>(u.size());
  std::vector<LoadWave> waves;
  std::optional<std::size_t> begin;
  for (std::size_t row = 1; row < u.size(); ++row) {
    if (!(u[row - 1] < mean && u[row] >= mean)) continue;
    if (begin) {
      const auto [least, most] =
          std::minmax_element(H.begin() + static_cast<std::ptrdiff_t>(*begin), H.begin() + static_cast<std::ptrdiff_t>(row));
      waves.push_back({*begin, row, *most, *least});
    }
    begin = row;
  }
  return waves;
}

std::vector<LoadWave> largest_waves(std::vector<LoadWave> waves, std::size_t count)
{
  std::stable_sort(waves.begin(), waves.end(), [](const LoadWave& a, const LoadWave& b) { return a.size() > b.size(); });
  waves.resize(std::min(waves.size(), count));
  std::sort(waves.begin(), waves.end(), [](const LoadWave& a, const LoadWave& b) { return a.begin < b.begin; });
  return waves;
}

}  // namespace berm::sea
