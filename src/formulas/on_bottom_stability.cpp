// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/on_bottom_stability.hpp"

#include "settings/water_loads.hpp"

#include <algorithm>
#include <array>

namespace berm::formulas {
namespace {

template <std::size_t rows, std::size_t columns>
struct Table {
  std::array<Real, rows> row;
  std::array<Real, columns> column;
  std::array<std::array<Real, columns>, rows> value;

  /// Straight between entries along both; at the ends as there.
  Real at(Real r, Real c) const
  {
    const auto [i, s] = place(row, r);
    const auto [j, t] = place(column, c);
    return (1 - s) * ((1 - t) * value[i][j] + t * value[i][j + 1]) + s * ((1 - t) * value[i + 1][j] + t * value[i + 1][j + 1]);
  }

private:
  template <std::size_t n>
  static std::pair<std::size_t, Real> place(const std::array<Real, n>& of, Real x)
  {
    const auto next = std::upper_bound(of.begin() + 1, of.end() - 1, x) - of.begin();
    const auto k = static_cast<std::size_t>(next) - 1;
    return {k, std::clamp((x - of[k]) / (of[k + 1] - of[k]), Real(0), Real(1))};
  }
};

constexpr std::array<Real, 11> peak_M{0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1, 2, 5, 10}, peak_K{2.5, 5, 10, 20, 30, 40, 50, 60, 70, 100, 140};
constexpr Table<11, 11> horizontal_peak{peak_M,
                                        peak_K,
                                        {{{13.0, 6.80, 4.55, 3.33, 2.72, 2.40, 2.15, 1.95, 1.80, 1.52, 1.30},
                                          {10.7, 5.76, 3.72, 2.72, 2.20, 1.90, 1.71, 1.58, 1.49, 1.33, 1.22},
                                          {9.02, 5.00, 3.15, 2.30, 1.85, 1.58, 1.42, 1.33, 1.27, 1.18, 1.14},
                                          {7.64, 4.32, 2.79, 2.01, 1.63, 1.44, 1.33, 1.26, 1.21, 1.14, 1.09},
                                          {6.63, 3.80, 2.51, 1.78, 1.46, 1.32, 1.25, 1.19, 1.16, 1.10, 1.05},
                                          {5.07, 3.30, 2.27, 1.71, 1.43, 1.34, 1.29, 1.24, 1.18, 1.08, 1.00},
                                          {4.01, 2.70, 2.01, 1.57, 1.44, 1.37, 1.31, 1.24, 1.17, 1.05, 1.00},
                                          {3.25, 2.30, 1.75, 1.49, 1.40, 1.34, 1.27, 1.20, 1.13, 1.01, 1.00},
                                          {1.52, 1.50, 1.45, 1.39, 1.34, 1.20, 1.08, 1.03, 1.00, 1.00, 1.00},
                                          {1.11, 1.10, 1.07, 1.06, 1.04, 1.01, 1.00, 1.00, 1.00, 1.00, 1.00},
                                          {1.00, 1.00, 1.00, 1.00, 1.00, 1.00, 1.00, 1.00, 1.00, 1.00, 1.00}}}};
constexpr Table<11, 11> vertical_peak{peak_M,
                                      peak_K,
                                      {{{5.00, 5.00, 4.85, 3.21, 2.55, 2.26, 2.01, 1.81, 1.63, 1.26, 1.05},
                                        {3.87, 4.08, 4.23, 2.87, 2.15, 1.77, 1.55, 1.41, 1.31, 1.11, 0.97},
                                        {3.16, 3.45, 3.74, 2.60, 1.86, 1.45, 1.26, 1.16, 1.09, 1.00, 0.90},
                                        {3.01, 3.25, 3.53, 2.14, 1.52, 1.26, 1.10, 1.01, 0.99, 0.95, 0.90},
                                        {2.87, 3.08, 3.35, 1.82, 1.29, 1.11, 0.98, 0.90, 0.90, 0.90, 0.90},
                                        {2.21, 2.36, 2.59, 1.59, 1.20, 1.03, 0.92, 0.90, 0.90, 0.90, 0.90},
                                        {1.53, 1.61, 1.80, 1.18, 1.05, 0.97, 0.92, 0.90, 0.90, 0.90, 0.90},
                                        {1.05, 1.13, 1.28, 1.12, 0.99, 0.91, 0.90, 0.90, 0.90, 0.90, 0.90},
                                        {0.96, 1.03, 1.05, 1.00, 0.90, 0.90, 0.90, 0.90, 0.90, 0.90, 0.90},
                                        {0.91, 0.92, 0.93, 0.91, 0.90, 0.90, 0.90, 0.90, 0.90, 0.90, 0.90},
                                        {0.90, 0.90, 0.90, 0.90, 0.90, 0.90, 0.90, 0.90, 0.90, 0.90, 0.90}}}};

constexpr std::array<Real, 10> weight_M{0.2, 0.4, 0.5, 0.6, 0.8, 1, 1.5, 2, 4, 10};
constexpr Table<10, 6> long_waves{weight_M,  // by K, from 10 on
                                  {10, 15, 20, 30, 40, 60},
                                  {{{1.50, 1.42, 1.35, 1.25, 1.22, 1.22},
                                    {1.82, 1.70, 1.61, 1.53, 1.50, 1.50},
                                    {2.19, 1.97, 1.83, 1.69, 1.61, 1.61},
                                    {2.65, 2.35, 2.18, 1.99, 1.85, 1.72},
                                    {3.05, 2.55, 2.32, 2.13, 2.01, 1.90},
                                    {3.05, 2.55, 2.40, 2.20, 2.06, 1.95},
                                    {2.65, 2.45, 2.36, 2.24, 2.11, 2.09},
                                    {2.50, 2.40, 2.35, 2.27, 2.22, 2.19},
                                    {2.45, 2.40, 2.39, 2.37, 2.37, 2.37},
                                    {2.50, 2.50, 2.50, 2.50, 2.50, 2.50}}}};
constexpr Table<10, 5> short_waves{weight_M,  // by N, at K = 5
                                   {0.003, 0.006, 0.012, 0.024, 0.048},
                                   {{{1.55, 1.45, 1.34, 1.24, 1.13},
                                     {2.00, 1.65, 1.34, 1.24, 1.13},
                                     {3.30, 2.60, 1.91, 1.24, 1.13},
                                     {3.75, 3.07, 2.38, 1.70, 1.13},
                                     {4.00, 3.45, 2.90, 2.36, 1.81},
                                     {3.90, 3.50, 3.10, 2.71, 2.31},
                                     {3.25, 3.13, 3.00, 2.88, 2.75},
                                     {2.75, 2.75, 2.75, 2.75, 2.75},
                                     {2.60, 2.60, 2.60, 2.60, 2.60},
                                     {2.50, 2.50, 2.50, 2.50, 2.50}}}};

}  // namespace

PeakLoads f109_peak_loads(Real K, Real M)
{
  constexpr Source source{Label::fit, "DNV-RP-F109", "K > 0, M >= 0; M <= 10 where K < 2.5"};
  const bool in_range = K > 0 && M >= 0 && (K >= peak_K.front() || M <= peak_M.back());
  const Real short_waves_too = std::max(Real(1), peak_K.front() / K);
  return {formula(horizontal_peak.at(M, K) * short_waves_too, source, in_range), formula(vertical_peak.at(M, K), source, in_range)};
}

LoadReductions f109_load_reductions(Real embedment, Real trench_depth, Real trench_angle, bool permeable)
{
  constexpr Source source{Label::fit, "DNV-RP-F109", "w/D >= 0; trench walls of 5 to 45 deg, z_t/D >= 0"};
  const bool in_range = embedment >= 0 && (!(trench_depth > 0) || within(trench_angle / degree, 5, 45));
  const settings::WaterReductions left = settings::water_reductions(embedment, trench_depth, trench_angle, permeable);
  return {formula(left.horizontal, source, in_range), formula(left.vertical, source, in_range)};
}

Formula f109_weight_for_half_diameter(Real K, Real M, Real N)
{
  constexpr Source source{Label::fit, "DNV-RP-F109", "K > 0, 0 <= M <= 10, 0.003 <= N <= 0.048 where K < 10"};
  const Real over_long = long_waves.at(M, K), over_short = short_waves.at(M, N);
  const Real ratio = K >= 10 ? over_long : over_short + (over_long - over_short) * std::clamp((K - 5) / 5, Real(0), Real(1));
  return formula(ratio * (2 + M) * (2 + M), source, K > 0 && within(M, 0, 10) && (K >= 10 || within(N, 0.003, 0.048)));
}

}  // namespace berm::formulas
