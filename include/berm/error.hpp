// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

#pragma GCC visibility push(default)
namespace berm {

/// The input is wrong (exit status 2). The message names file, line, key and what is allowed.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The run failed (exit status 1). The message says what, where, when and what to do.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace berm
#pragma GCC visibility pop
