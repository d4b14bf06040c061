// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <vector>

namespace berm::uncertainty {

/// A number that a run with other cells gave.
struct SizedNumber {
  Real size;  ///< of its cells, over those of the run
  Real number;
};

/// What numbers of several sizes of cells tell of the number at zero cell size.
struct Estimate {
  Real converged;      ///< where the line comes to size 0
  Real order;          ///< of convergence, through the finest, the second and the coarsest; NaN where scatter hides it
  Real extrapolation;  ///< half of the way from the line at the finest size to there
  Real mesh;           ///< 95 % of Student's distribution for `converged` as a constant of the fitted line
  Real scatter;        ///< standard deviation of the finest number about the line, of these numbers alone
};

/// The least-squares line number = converged + slope size, each weighted by 1 / size^2: numbers scatter from mesh to mesh in proportion to the cells. Their standard
/// deviation is `known_scatter` at the finest size, or that about the line where it is larger. Needs three numbers of two sizes at least; NaN where one of them is NaN.
/// Source: docs/theory/method.md, Discretisation uncertainty.
Estimate extrapolate(const std::vector<SizedNumber>& numbers, Real known_scatter);

/// The part of converged +- half_width that comes from all: what the extrapolation is uncertain by stands, for it is no accident; the others are independent.
Real half_width(Real extrapolation, Real mesh, Real noise, Real speed);

}  // namespace berm::uncertainty
