// SPDX-License-Identifier: BSD-3-Clause
#include "slices/soil_columns.hpp"

#include <algorithm>
#include <cmath>

namespace berm::slices {

SoilColumns::SoilColumns(const problem::Model<2>& model, Real width)
{
  const auto [low, high] = std::minmax_element(model.mesh.position.begin(), model.mesh.position.end(),
                                               [](const Vec<2>& a, const Vec<2>& b) { return a[0] < b[0]; });
  const Real length = (*high)[0] - (*low)[0];
  const int count = static_cast<int>(std::ceil(length / width));
  left_ = (*low)[0];
  width_ = length / count;
  for (int k = 0; k < count; ++k) middles_.push_back(left_ + (k + Real(0.5)) * width_);
}

std::vector<Real> SoilColumns::heights(const problem::State<2>& state) const
{
  std::vector<Real> heights(middles_.size(), 0);
  const auto last = static_cast<Index>(middles_.size()) - 1;
  const auto column_of = [&](Real x) { return std::clamp(static_cast<Index>(std::floor((x - left_) / width_)), Index(0), last); };
  for (const bodies::Particles<2>& particles : state.particles)
    for (const Index cell : particles.occupied())
      for (Index p = 0; p < particles.count_in(cell); ++p) {
        const bodies::Particle<2> particle = particles.read_at(cell, p);
        const Real side = std::sqrt(particle.volume), from = particle.x[0] - side / 2, to = particle.x[0] + side / 2;
        for (Index k = column_of(from); k <= column_of(to); ++k) {
          const Real column_from = k == 0 ? -infinity : left_ + static_cast<Real>(k) * width_,
                     column_to = k == last ? infinity : left_ + static_cast<Real>(k + 1) * width_;
          heights[static_cast<std::size_t>(k)] += std::max(Real(0), std::min(to, column_to) - std::max(from, column_from)) * side / width_;
        }
      }
  return heights;
}

}  // namespace berm::slices
