// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <vector>

namespace berm::uncertainty {

/// A number that a run with other cells gave.
struct SizedNumber {
  Real size;  ///< of its cells, over that of the finest run
  Real number;
};

/// What numbers of several sizes of cells tell of the number for cells without size.
struct Estimate {
  Real converged;      ///< where the line comes to size 0
  Real extrapolation;  ///< half of the way from the line at size 1 to there
  Real mesh;           ///< 95 % of Student's distribution for `converged` as a constant of the fitted line
};

/// The least-squares line number = converged + slope size, each weighted by 1 / size^2: numbers scatter from mesh to mesh in proportion to the cells. Needs three
/// numbers of two sizes at least; NaN where one of them is NaN. Source: docs/theory.md, section 12.
Estimate extrapolate(const std::vector<SizedNumber>& numbers);

/// The half width of a band of 95 % in standard deviations that were found from so many numbers more than were fitted.
Real student_95(int degrees_of_freedom);

/// The part of converged +- half_width that comes from all: what the extrapolation is uncertain by stands, for it is no accident; the others are independent.
Real half_width(Real extrapolation, Real mesh, Real noise, Real speed);

}  // namespace berm::uncertainty
