// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <functional>
#include <optional>

namespace berm::element {

/// A strain that is free, and what is looked for.
struct BalanceRequest {
  Real guess = 0;      ///< of the strain
  Real step = 0;       ///< > 0: how far off the guess may be, roughly
  Real limit = 1;      ///< strains beyond +- this are none
  Real tolerance = 0;  ///< Pa
};

/// The strain x at which a stress is what it should be: |excess(x)| <= tolerance, excess the stress less its target, Pa, which grows with x near the
/// solution. From the guess the interval grows until it holds a change of sign; within it Illinois' false position, with bisection where that stays behind
/// (Dahlquist and Bjorck, Numerical Methods, section 6.4). Empty where no strain within the limit gives the stress, and where excess is not finite.
std::optional<Real> balance(const std::function<Real(Real)>& excess, const BalanceRequest& request);

}  // namespace berm::element
