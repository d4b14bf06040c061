// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/waves.hpp"

#include <algorithm>
#include <numbers>

namespace berm::formulas {
namespace {

constexpr int parts = 8000;  // of an integral over a spectrum

/// Integral from the first to the last frequency of the density times a function.
template <class Weight>
Real integral(const WaveSpectrum& spectrum, const Weight& weight)
{
  const Real step = (spectrum.last() - spectrum.first()) / parts;
  Real sum = 0;
  for (int k = 0; k <= parts; ++k) {
    const Real w = spectrum.first() + k * step;
    sum += spectrum.density(w) * weight(w) * (k == 0 || k == parts ? 0.5 : 1);
  }
  return sum * step;
}

}  // namespace

WaveSpectrum WaveSpectrum::jonswap(Real height, Real period, Real peakedness)
{
  WaveSpectrum made;
  made.peak_ = 2 * pi / period;
  made.first_ = 0.4 * made.peak_, made.last_ = 8 * made.peak_;
  made.peakedness_ = peakedness;
  made.scale_ = height * height / (16 * integral(made, [](Real) { return Real(1); }));
  return made;
}

WaveSpectrum WaveSpectrum::table(std::vector<Real> frequency, std::vector<Real> density)
{
  WaveSpectrum made;
  made.first_ = frequency.front(), made.last_ = frequency.back();
  made.peak_ = frequency[static_cast<std::size_t>(std::max_element(density.begin(), density.end()) - density.begin())];
  made.frequency_ = std::move(frequency), made.density_ = std::move(density);
  return made;
}

Real WaveSpectrum::density(Real w) const
{
  if (!(w >= first_ && w <= last_)) return 0;
  if (!frequency_.empty()) {
    const auto next = std::upper_bound(frequency_.begin() + 1, frequency_.end() - 1, w) - frequency_.begin();
    const auto k = static_cast<std::size_t>(next);
    const Real part = (w - frequency_[k - 1]) / (frequency_[k] - frequency_[k - 1]);
    return density_[k - 1] + part * (density_[k] - density_[k - 1]);
  }
  const Real x = w / peak_, off = (x - 1) / (x <= 1 ? 0.07 : 0.09);
  return scale_ * std::pow(x, -5) * std::exp(-1.25 * std::pow(x, -4)) * std::pow(peakedness_, std::exp(-off * off / 2));
}

Real height_of(const WaveSpectrum& spectrum)
{
  return 4 * std::sqrt(integral(spectrum, [](Real) { return Real(1); }));
}

Formula wave_peakedness(Real height, Real period)
{
  constexpr Source source{Label::fit, "DNV-RP-F109", "H_s > 0, T_p > 0"};
  const Real steepness = period / std::sqrt(height);
  return formula(steepness <= 3.6 ? 5 : steepness >= 5 ? 1 : std::exp(5.75 - 1.15 * steepness), source, height > 0 && period > 0);
}

Real wave_number(Real frequency, Real depth)
{
  const Real deep = frequency * frequency * depth / standard_gravity;
  Real x = deep > 1 ? deep : std::sqrt(deep);  // k d
  for (int n = 0; n < 50; ++n) {
    const Real t = std::tanh(x), change = (x * t - deep) / (t + x * (1 - t * t));
    x -= change;
    if (std::abs(change) <= 1e-14 * x) break;
  }
  return x / depth;
}

Real velocity_at_seabed(Real frequency, Real depth)
{
  return frequency / std::sinh(wave_number(frequency, depth) * depth);
}

SeabedWaves waves_at_seabed(const WaveSpectrum& spectrum, Real depth)
{
  const auto moment = [&](int order) {
    return integral(spectrum, [&](Real w) { return std::pow(w, order) * std::pow(velocity_at_seabed(w, depth), 2); });
  };
  const Real variance = moment(0);
  return {2 * std::sqrt(variance), 2 * pi * std::sqrt(variance / moment(2))};
}

Real wave_direction_factor(Real angle, Real spreading)
{
  const Real along = std::cos(angle) * std::cos(angle), across = 1 - along;
  if (std::isinf(spreading)) return std::sqrt(across);
  return std::sqrt(((spreading + 1) * across + along) / (spreading + 2));
}

DesignOscillation design_oscillation(const SeabedWaves& waves, Real duration, Real depth, Real peakedness)
{
  constexpr Source source{Label::fit, "DNV-RP-F109", "duration > e T_u, 1 <= gamma <= 5"};
  constexpr Real euler = 0.5772;
  const Real tau = duration / waves.period, root = std::sqrt(2 * std::log(tau));
  const bool in_range = tau > std::numbers::e && within(peakedness, 1, 5);
  const Real largest = tau > std::numbers::e ? waves.velocity / 2 * (root + euler / root) : nan;
  const Real k_t = peakedness <= 3.3 ? 1.25 - 0.04 * (peakedness - 1) / 2.3 : 1.21 - 0.04 * (peakedness - 3.3) / 1.7;
  const Real ratio = std::sqrt(depth / standard_gravity) / waves.period, k = ratio <= 0.2 ? k_t - 5 * (k_t - 1) * ratio : 1;
  return {formula(largest, source, in_range), formula(k * waves.period, source, in_range)};
}

Formula current_on_pipe(Real velocity, Real height, Real roughness, Real angle, Real diameter)
{
  constexpr Source source{Label::fit, "DNV-RP-F109", "z_0 > 0, D > 0, z_r > 0"};
  const Real rough = roughness / diameter;
  const Real mean = velocity * ((1 + rough) * std::log(1 + 1 / rough) - 1) / std::log(1 + height / roughness) * std::sin(angle);
  return formula(mean, source, roughness > 0 && diameter > 0 && height > 0);
}

}  // namespace berm::formulas
