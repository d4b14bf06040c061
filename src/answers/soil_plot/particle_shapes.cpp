// SPDX-License-Identifier: BSD-3-Clause
#include "soil_plot/particle_shapes.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace berm::soil_plot {
namespace {

constexpr Real reach = 1.8;         // of neighbours, in sqrt(volume)
constexpr Real torn = 5;            // a neighbour that is so many times as far away as it was
constexpr Real longest_axis = 2.5;  // of an ellipse; its shorter one is then 0.4

/// Particles in square buckets by where they were at first.
class Buckets {
public:
  Buckets(const std::vector<Vec<2>>& places, Real size) : places_(places), size_(size)
  {
    for (std::size_t k = 0; k < places.size(); ++k) entries_.push_back({bucket(places[k][0]), bucket(places[k][1]), static_cast<Index>(k)});
    std::sort(entries_.begin(), entries_.end());
  }

  /// Visits those within a distance of a place.
  template <class Visit>
  void visit_near(const Vec<2>& place, Real distance, const Visit& visit) const
  {
    for (std::int64_t column = bucket(place[0] - distance); column <= bucket(place[0] + distance); ++column) {
      auto next = std::lower_bound(entries_.begin(), entries_.end(), Entry{column, bucket(place[1] - distance), 0});
      for (const std::int64_t last = bucket(place[1] + distance); next != entries_.end() && next->column == column && next->row <= last;
           ++next)
        if ((places_[next->particle] - place).squaredNorm() <= distance * distance) visit(next->particle);
    }
  }

private:
  struct Entry {
    std::int64_t column, row;
    Index particle;
    auto operator<=>(const Entry&) const = default;
  };
  std::int64_t bucket(Real x) const { return static_cast<std::int64_t>(std::floor(x / size_)); }

  const std::vector<Vec<2>>& places_;
  Real size_;
  std::vector<Entry> entries_;
};

/// The symmetric A of a deformation: of the axes of F F^T, with stretches a and 1/a.
Matrix<2> shape_of(const Matrix<2>& F)
{
  const Matrix<2> B = F * F.transpose();
  const Real mean = B.trace() / 2, half = std::hypot((B(0, 0) - B(1, 1)) / 2, B(0, 1)), shorter = mean - half, longer = mean + half;
  if (!(half > 0)) return Matrix<2>::Identity();
  const Real a = longer < std::pow(longest_axis, 4) * shorter ? std::pow(longer / shorter, 0.25) : longest_axis;
  return (a + 1 / a) / 2 * Matrix<2>::Identity() + (a - 1 / a) / 2 / half * (B - mean * Matrix<2>::Identity());
}

}  // namespace

std::vector<Matrix<2>> particle_shapes(const run_folder::Frame<2>& frame, const std::vector<Index>& points)
{
  const run_folder::FieldValues<Real>* displacement = find_field(frame.fields, "displacement");
  if (displacement == nullptr || points.empty()) return std::vector<Matrix<2>>(points.size(), Matrix<2>::Identity());
  std::vector<Vec<2>> first;
  for (std::size_t k = 0; k < frame.points.size(); ++k)
    first.emplace_back(frame.points[k] - Vec<2>(displacement->at(k, 0), displacement->at(k, 1)));
  std::vector<Real> volumes;
  for (const Index p : points) volumes.push_back(frame.volume[p]);
  std::nth_element(volumes.begin(), volumes.begin() + static_cast<std::ptrdiff_t>(volumes.size() / 2), volumes.end());
  const Buckets buckets(first, reach * std::sqrt(volumes[volumes.size() / 2]));
  std::vector<Matrix<2>> shapes;
  for (const Index p : points) {
    Matrix<2> now = 0.1 * frame.volume[p] * Matrix<2>::Identity(), then = now;
    buckets.visit_near(first[p], reach * std::sqrt(frame.volume[p]), [&](Index n) {
      const Vec<2> dX = first[n] - first[p], dx = frame.points[n] - frame.points[p];
      if (frame.body[n] != frame.body[p] || dx.norm() > torn * dX.norm()) return;
      now += dx * dX.transpose();
      then += dX * dX.transpose();
    });
    shapes.push_back(shape_of(now * then.inverse()));
  }
  return shapes;
}

}  // namespace berm::soil_plot
