// SPDX-License-Identifier: BSD-3-Clause
#include "soil_plot/isometric_raster.hpp"

#include "soil_plot/raster.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace berm::soil_plot {
namespace {

constexpr Real ambient = 0.5;  // part of the light that comes from everywhere

/// The first and the last pixel whose middle lies between two places of a row of `count`.
std::pair<Index, Index> pixels_between(Real from, Real to, Index count)
{
  return {static_cast<Index>(std::ceil(std::clamp<Real>(from - 0.5, 0, count))),
          static_cast<Index>(std::floor(std::clamp<Real>(to - 0.5, -1, count - 1)))};
}

Real parallelogram(const Vec<2>& a, const Vec<2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

}  // namespace

IsometricRaster::IsometricRaster(const Vec<3>& lower, const Vec<3>& upper, Index columns) : lower_(lower), upper_(upper), columns_(columns)
{
  Vec<2> right_above = Vec<2>::Constant(-infinity);
  left_below_ = -right_above;
  for (int k = 0; k < 8; ++k) {
    const Vec<3> corner((k & 1) != 0 ? upper[0] : lower[0], (k & 2) != 0 ? upper[1] : lower[1], (k & 4) != 0 ? upper[2] : lower[2]);
    left_below_ = left_below_.cwiseMin(isometric(corner));
    right_above = right_above.cwiseMax(isometric(corner));
  }
  const Vec<2> size = right_above - left_below_;
  pixels_per_metre_ = columns / size[0];
  rows_ = std::max<Index>(1, static_cast<Index>(std::lround(size[1] * pixels_per_metre_)));
  depth_.assign(static_cast<std::size_t>(columns_) * rows_, -infinity);
  colors_.assign(3 * depth_.size(), 255);
}

bool IsometricRaster::holds(const Vec<3>& x) const
{
  return (x.array() >= lower_.array()).all() && (x.array() <= upper_.array()).all();
}

Vec<2> IsometricRaster::pixel_of(const Vec<3>& x) const
{
  return (isometric(x) - left_below_) * pixels_per_metre_;
}

void IsometricRaster::paint(Index column, Index row, Real depth, Real light, const Rgb& color)
{
  const std::size_t pixel = static_cast<std::size_t>(row) * columns_ + column;
  if (depth <= depth_[pixel]) return;
  depth_[pixel] = depth;
  const Real part = ambient + (1 - ambient) * std::max<Real>(light, 0);
  for (int k = 0; k < 3; ++k) colors_[3 * pixel + k] = static_cast<unsigned char>(std::lround(part * color[k]));
}

void IsometricRaster::paint_ball(const Vec<3>& center, Real radius, const Rgb& color)
{
  if (!holds(center)) return;
  const Vec<3> light = Vec<3>(-0.3, 0.6, 0.75).normalized();  // right, up, towards the eye
  const Vec<2> middle = pixel_of(center);
  const Real in_pixels = std::max<Real>(radius * pixels_per_metre_, 0.75);  // one pixel at least
  const auto [left, right] = pixels_between(middle[0] - in_pixels, middle[0] + in_pixels, columns_);
  const auto [low, high] = pixels_between(middle[1] - in_pixels, middle[1] + in_pixels, rows_);
  for (Index row = low; row <= high; ++row)
    for (Index column = left; column <= right; ++column) {
      const Vec<2> from = (Vec<2>(column + 0.5, row + 0.5) - middle) / in_pixels;
      const Real rest = 1 - from.squaredNorm();
      if (rest < 0) continue;
      const Vec<3> normal(from[0], from[1], std::sqrt(rest));
      paint(column, row, towards_eye(center) + radius * normal[2], normal.dot(light), color);
    }
}

void IsometricRaster::paint_triangle(const std::array<Vec<3>, 3>& corners, const Rgb& color)
{
  std::array<Vec<2>, 3> p;
  for (int k = 0; k < 3; ++k) p[k] = pixel_of(corners[k]);
  const Real twice_area = parallelogram(p[1] - p[0], p[2] - p[0]);
  if (twice_area == 0) return;  // seen from its edge
  const Vec<3> normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  const Real light = std::abs(normal.dot(Vec<3>(0.35, 0.85, 0.4).normalized()));
  const auto [left_x, right_x] = std::minmax({p[0][0], p[1][0], p[2][0]});
  const auto [low_y, high_y] = std::minmax({p[0][1], p[1][1], p[2][1]});
  const auto [left, right] = pixels_between(left_x, right_x, columns_);
  const auto [low, high] = pixels_between(low_y, high_y, rows_);
  constexpr Real slack = 1e-9;  // no pixel falls between two neighbours
  for (Index row = low; row <= high; ++row)
    for (Index column = left; column <= right; ++column) {
      const Vec<2> x(column + 0.5, row + 0.5);
      const Real N_1 = parallelogram(x - p[0], p[2] - p[0]) / twice_area, N_2 = parallelogram(p[1] - p[0], x - p[0]) / twice_area,
                 N_0 = 1 - N_1 - N_2;
      if (std::min({N_0, N_1, N_2}) < -slack) continue;
      const Vec<3> place = N_0 * corners[0] + N_1 * corners[1] + N_2 * corners[2];
      if (holds(place)) paint(column, row, towards_eye(place), light, color);
    }
}

std::array<int, 3> IsometricRaster::at(Index column, Index row) const
{
  const std::size_t pixel = static_cast<std::size_t>(row) * columns_ + column;
  return {colors_[3 * pixel], colors_[3 * pixel + 1], colors_[3 * pixel + 2]};
}

std::string IsometricRaster::bytes() const
{
  return {colors_.begin(), colors_.end()};
}

}  // namespace berm::soil_plot
