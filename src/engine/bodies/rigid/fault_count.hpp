// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <fmt/format.h>
#include <string>

namespace berm::bodies {

/// Counts one kind of fault of a surface, and where the first is.
struct FaultCount {
  BigIndex count = 0;
  Vec<3> first = Vec<3>::Zero();  ///< m

  void add(const Vec<3>& x)
  {
    if (count++ == 0) first = x;
  }
  std::string words(const char* one, const char* many) const
  {
    if (count == 0) return {};
    return fmt::format("{} {}, such as at ({:.6g}, {:.6g}, {:.6g}) m", count, count == 1 ? one : many, first[0], first[1], first[2]);
  }
};

}  // namespace berm::bodies
