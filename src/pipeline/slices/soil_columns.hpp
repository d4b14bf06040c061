// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::slices {

/// How high soil stands: volumes of particles, each a square, in upright columns of one width.
class SoilColumns {
public:
  /// Over the whole mesh, with columns of this width or a little less, m.
  SoilColumns(const problem::Model<2>& model, Real width);

  /// m, of the middle of each column.
  const std::vector<Real>& middles() const { return middles_; }
  /// m by column: soil, without gaps, above the base.
  std::vector<Real> heights(const problem::State<2>& state) const;

private:
  Real left_, width_;
  std::vector<Real> middles_;
};

}  // namespace berm::slices
