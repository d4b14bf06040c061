// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/picture/model_picture_page_test.cpp
#pragma once

#include "core/types.hpp"

#include <vector>

namespace berm::picture {

using Points = std::vector<Vec<2>>;

/// The part of a convex polygon where inside(x) >= 0, which is linear in x.
template <class Inside>
Points cut(const Points& convex, const Inside& inside)
{
  Points part;
  for (std::size_t k = 0; k < convex.size(); ++k) {
    const Vec<2>&here = convex[k], &next = convex[(k + 1) % convex.size()];
    const Real a = inside(here), b = inside(next);
    if (a >= 0) part.push_back(here);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) part.emplace_back(here + a / (a - b) * (next - here));
  }
  return part;
}

}  // namespace berm::picture
