// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace berm {

/// The input is wrong (exit status 2). The message names file, line, key and what is allowed.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A value of a case is wrong, found where only its key is known: "support.base.boundary: the mesh has no ...". The key ends at the first ": ", and goes
/// from the root of the case, "stage[2].until" for an item of an array. Whoever read the file adds its name and the line (input::Places).
struct KeyError : InputError {
  using InputError::InputError;
};

/// The run failed (exit status 1). The message says what, where, when and what to do.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace berm
