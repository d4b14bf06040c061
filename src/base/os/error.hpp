// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <berm/error.hpp>

namespace berm {

/// A value of a case is wrong, found where only its key is known: "support.base.boundary: the mesh has no ...". The key ends at the first ": ", and goes
/// from the root of the case, "stage[2].until" for an item of an array. Whoever read the file adds its name and the line (input::Places).
struct KeyError : InputError {
  using InputError::InputError;
};

}  // namespace berm
