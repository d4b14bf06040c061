// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/shape_solid_test.cpp
#include "bodies/rigid/placement.hpp"

#include <algorithm>

namespace berm::bodies {

Matrix<3> frame_along(const Vec<3>& axis)
{
  const Vec<3> y = axis.normalized();
  constexpr Real opposite = 1e-12;
  if (1 + y[1] < opposite) return Vec<3>(1, -1, -1).asDiagonal();
  const Vec<3> v(y[2], 0, -y[0]);  // the y axis x y
  Matrix<3> skew;
  skew << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return Matrix<3>::Identity() + skew + skew * skew / (1 + y[1]);
}

Matrix<3> turned_about_axes(const std::vector<Real>& angles)
{
  Matrix<3> turned = Matrix<3>::Identity();
  for (std::size_t d = 0; d < angles.size() && d < 3; ++d) {
    Orientation<3> about;
    about.turn_by(angles[d] * Vec<3>::Unit(static_cast<int>(d)));
    turned = about.matrix() * turned;
  }
  return turned;
}

CornersOutline hull_of(std::vector<Vec<2>> points)
{
  std::sort(points.begin(), points.end(), [](const Vec<2>& a, const Vec<2>& b) { return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]); });
  std::vector<Vec<2>> hull;
  for (const bool back : {false, true}) {
    const std::size_t first = hull.size();
    for (const Vec<2>& x : points) {
      while (hull.size() >= first + 2) {
        const Vec<2> a = hull.back() - hull[hull.size() - 2], b = x - hull.back();
        if (a[0] * b[1] - a[1] * b[0] > 0) break;
        hull.pop_back();
      }
      hull.push_back(x);
    }
    hull.pop_back();
    if (!back) std::reverse(points.begin(), points.end());
  }
  return {hull};
}

Revolution revolved(const std::vector<Vec<2>>& corners)
{
  // Gauss's three points of a side: the integrands have the degree 4 at most.
  const Real off = std::sqrt(0.15);
  const std::pair<Real, Real> gauss[] = {{0.5 - off, 5. / 18}, {0.5, 8. / 18}, {0.5 + off, 5. / 18}};
  Real x1 = 0, x1y1 = 0, x3 = 0, x1y2 = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2>&a = corners[k], &b = corners[(k + 1) % corners.size()];
    for (const auto& [t, weight] : gauss) {
      const Vec<2> at = a + t * (b - a);
      const Real half_square = weight * (b[1] - a[1]) * at[0] * at[0] / 2;
      x1 += half_square;
      x1y1 += half_square * at[1];
      x3 += half_square * at[0] * at[0] / 2;
      x1y2 += half_square * at[1] * at[1];
    }
  }
  const Real level = x1y1 / x1, around = x3 / x1, across = around / 2 + x1y2 / x1 - level * level;
  return {2 * pi * x1, level, {across, around, across}};
}

}  // namespace berm::bodies
