// SPDX-License-Identifier: BSD-3-Clause
#include "soil_plot/raster.hpp"

#include "os/text_of_list.hpp"
#include "plot/gnuplot.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <fmt/format.h>

namespace berm::soil_plot {
namespace {

Real cross(const Vec<2>& a, const Vec<2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// The whole numbers from `least` to `most`, as far as they are from 0 to count - 1.
std::pair<Index, Index> whole_between(Real min, Real max, Index count)
{
  return {static_cast<Index>(std::ceil(std::clamp<Real>(min, 0, count))),
          static_cast<Index>(std::floor(std::clamp<Real>(max, -1, count - 1)))};
}

}  // namespace

Raster::Raster(const Vec<2>& lower, const Vec<2>& upper, Index columns, Index rows)
    : lower_(lower),
      pixels_per_metre_(columns / (upper[0] - lower[0]), rows / (upper[1] - lower[1])),
      columns_(columns),
      rows_(rows),
      values_(static_cast<std::size_t>(columns) * rows, nan),
      nearest_(values_.size(), infinity)
{
}

void Raster::paint(const std::array<Vec<2>, 3>& corners, const std::array<Real, 3>& values)
{
  // Slack for the round-off at a side, so that no pixel falls between two neighbours.
  constexpr Real slack = 1e-9;
  std::array<Vec<2>, 3> p;  // in pixels; middles of pixels are whole numbers
  for (int k = 0; k < 3; ++k) p[k] = (corners[k] - lower_).cwiseProduct(pixels_per_metre_) - Vec<2>(0.5, 0.5);
  const Real twice_area = cross(p[1] - p[0], p[2] - p[0]);
  if (twice_area == 0) return;
  const auto [left, right] = std::minmax({p[0][0], p[1][0], p[2][0]});
  const auto [low, high] = std::minmax({p[0][1], p[1][1], p[2][1]});
  const auto [first_column, last_column] = whole_between(left - slack, right + slack, columns_);
  const auto [first_row, last_row] = whole_between(low - slack, high + slack, rows_);
  for (Index row = first_row; row <= last_row; ++row)
    for (Index column = first_column; column <= last_column; ++column) {
      const Vec<2> x(column, row);
      const Real N_1 = cross(x - p[0], p[2] - p[0]) / twice_area, N_2 = cross(p[1] - p[0], x - p[0]) / twice_area;
      const Real N_0 = 1 - N_1 - N_2;
      if (std::min({N_0, N_1, N_2}) < -slack) continue;
      values_[static_cast<std::size_t>(row) * columns_ + column] = N_0 * values[0] + N_1 * values[1] + N_2 * values[2];
    }
}

void Raster::paint_ellipse(const Vec<2>& center, const Matrix<2>& A, Real value)
{
  const Vec<2> metres(1 / pixels_per_metre_[0], 1 / pixels_per_metre_[1]);
  const Vec<2> half = A.rowwise().norm();  // of the box around it
  const Vec<2> lower = (center - half - lower_).cwiseQuotient(metres) - Vec<2>(0.5, 0.5),
               upper = (center + half - lower_).cwiseQuotient(metres) - Vec<2>(0.5, 0.5);
  const auto [first_column, last_column] = whole_between(lower[0], upper[0], columns_);
  const auto [first_row, last_row] = whole_between(lower[1], upper[1], rows_);
  const Matrix<2> to_circle = A.inverse();
  for (Index row = first_row; row <= last_row; ++row)
    for (Index column = first_column; column <= last_column; ++column) {
      const Vec<2> x = lower_ + Vec<2>(column + 0.5, row + 0.5).cwiseProduct(metres);
      const std::size_t pixel = static_cast<std::size_t>(row) * columns_ + column;
      const Real away = (to_circle * (x - center)).squaredNorm();
      if (away > 1 || away >= nearest_[pixel]) continue;
      nearest_[pixel] = away;
      values_[pixel] = value;
    }
}

std::string Raster::floats() const
{
  const std::vector<float> values(values_.begin(), values_.end());
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

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
  return fmt::format("set palette defined ({})\n", text_of_list(entries, ", "));
}

std::pair<Real, Real> color_range(std::vector<Real> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t part = values.size() / 100;
  const auto end = [](Real hundredth, Real farthest) { return hundredth > 0 ? hundredth : std::max(Real(0), farthest); };
  const Real above = end(values[values.size() - 1 - part], values.back()), below = end(-values[part], -values.front());
  return {below > 0 ? -plot::round_up(below) : 0, above > 0 || below == 0 ? plot::round_up(above) : 0};
}

}  // namespace berm::soil_plot
