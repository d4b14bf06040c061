// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "macro_element/parameters.hpp"
#include "macro_element_fit/path.hpp"

namespace berm::macro_element_fit {

using macro_element::Parameters;

/// What the macro-element does on a path: its numbers at the points of the path.
struct Response {
  std::vector<Real> w, H, V;  ///< m, N/m
};

/// The macro-element on a path: u as it was, and w or V, whichever was given. Throws RunError where it finds no answer.
Response follow(const Parameters& parameters, const Path& path);

/// How far the macro-element is from a run, over all points of its path.
struct Misfit {
  Real H = nan;        ///< root mean square of the difference in H, over the largest H of the run
  Real V = nan;        ///< the same of V where w was given, over the largest V of the run; NaN without such points
  Real w = nan;        ///< the same of w where V was given, over the diameter; NaN without such points
  Real largest = nan;  ///< largest H of the macro-element over that of the run
  Real end = nan;      ///< w at the end of the path, the macro-element's less the run's, over the diameter
};

/// H is NaN on a path without a drag (largest H below a tenth of the largest V).
Misfit misfit_of(const Path& path, const Response& response);

/// Parameters that fit these paths best: least squares of H over the largest H, of V over the largest V and of w over the diameter, each path with the
/// same weight (Levenberg-Marquardt from several beginnings). V0(w) is what fresh soil answered the pushes. Throws RunError where there is no push by
/// velocity into fresh soil, no drag, or where paths have different diameters. Nothing in a plane across the pipe tells what is along it: its friction is the first path's, its mobilisation the best
/// estimate of DNV-RP-F114.
Parameters fit(const std::vector<Path>& paths);

}  // namespace berm::macro_element_fit
