// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "macro_element/parameters.hpp"

namespace berm::macro_element {

/// After a pipe moved to x and u (m) and so far down or up that V (N/m) acts on it; where none does, as near as it gets. Throws RunError where the macro-element finds no answer.
berm_macro_element_state moved_under(const Parameters& parameters, const berm_macro_element_state& before, Real x, Real u, Real V);

/// Of a pipe at x = u = 0 that was laid by that force and now carries its weight (N/m). Throws InputError where the force is less than the weight, or where the soil holds neither.
berm_macro_element_state laid(const Parameters& parameters, Real laying_force, Real weight);

}  // namespace berm::macro_element
