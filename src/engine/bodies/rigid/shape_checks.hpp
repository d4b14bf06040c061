// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

#include <fmt/format.h>

namespace berm::bodies {

/// Checks that a list has one number per dimension.
inline void check_entries(Describe& d, const std::string& path, const std::vector<Real>& numbers, int dimension, bool may_be_empty = false)
{
  d.check((may_be_empty && numbers.empty()) || static_cast<int>(numbers.size()) == dimension, path,
          fmt::format("needs {} numbers, one per direction, and has {}", dimension, numbers.size()));
}

}  // namespace berm::bodies
