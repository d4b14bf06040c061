// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::settings {

inline constexpr const char* axis_names[] = {"x", "y", "z"};

/// Whether the whole is mirrored across an axis, by its number.
bool mirrors(const Case& c, int axis);

/// Refuses planes of symmetry of what is not in space, and motion, loads and gravity that they do not mirror into themselves.
void check_symmetry(Describe& d, const Case& c);

/// Equal parts that the whole has, of which the model is one: 2 pi radians around an axis, 2 or 4 where there are planes of symmetry, else 1.
Real parts_of(const Case& c);

/// The case as the model has it: masses, forces and moments are those of one part.
Case part_of_whole(Case c);

/// Refuses what a case around an axis cannot have: motion and loads that are not the same all around, bodies that their own mirror image does not continue, and
/// what is not made for it.
void check_axisymmetry(Describe& d, const Case& c);

}  // namespace berm::settings
