// SPDX-License-Identifier: BSD-3-Clause
#include "macro_element/under_force.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::macro_element {
namespace {

/// The largest vertical step, and the part of V to which it is met.
constexpr Real max_step_over_D = 0.05, same_V = 1e-7;

Real tolerance_of(const Parameters& p, Real V)
{
  return same_V * (std::abs(V) + p.vertical_stiffness * 1e-3 * p.diameter);
}

}  // namespace

berm_macro_element_state moved_under(const Parameters& p, const berm_macro_element_state& before, Real x, Real u, Real V)
{
  Real low = -100 * p.diameter, high = 100 * p.diameter, dw = 0;
  berm_macro_element_state after{};
  for (int k = 0; k < 80; ++k) {
    const double to[3] = {x, u, before.w + dw};
    double F[3], K[3][3];
    if (const int error = berm_macro_element_step(&p, &before, to, &after, F, K); error != BERM_MACRO_ELEMENT_OK)
      throw RunError(berm_macro_element_error(error));
    const Real left = V - F[2];
    if (std::abs(left) <= tolerance_of(p, V)) break;
    (left > 0 ? low : high) = dw;
    const Real step = K[2][2] > 1e-6 * p.vertical_stiffness ? left / K[2][2] : (left > 0 ? 1 : -1) * max_step_over_D * p.diameter;
    Real tried = dw + std::clamp<Real>(step, -max_step_over_D * p.diameter, max_step_over_D * p.diameter);
    if (!(tried > low && tried < high)) tried = (low + high) / 2;
    if (high - low < 1e-14 * p.diameter) break;
    dw = tried;
  }
  return after;
}

berm_macro_element_state laid(const Parameters& p, Real laying_force, Real weight)
{
  if (!(weight > 0) || !(laying_force >= weight))
    throw InputError(fmt::format("a pipe of {:.4g} N/m is laid with {:.4g} N/m: with its weight or more", weight, laying_force));
  const double seabed[3] = {0, 0, 0};
  berm_macro_element_state state{};
  if (const int error = berm_macro_element_start(&p, seabed, 0, &state); error != BERM_MACRO_ELEMENT_OK)
    throw InputError(berm_macro_element_error(error));
  for (const Real V : {laying_force, weight}) {
    state = moved_under(p, state, 0, 0, V);
    if (!(std::abs(state.V - V) <= tolerance_of(p, V)))
      throw InputError(fmt::format("the soil of the macro-element does not carry a pipe that is laid with {:.4g} N/m", V));
  }
  return state;
}

}  // namespace berm::macro_element
