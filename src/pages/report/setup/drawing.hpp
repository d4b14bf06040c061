// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/ground.hpp"

#include <string>
#include <vector>

namespace berm::report {

/// A case drawn to scale, in the plane x-y, from what its file says alone.
struct Drawing {
  std::string svgs;  ///< one or two SVG elements: the whole and, where the driven body is small in it, what is around its path
  std::vector<std::string> notes;  ///< what is not drawn, in words (plain text)
};

/// The bed with its supports and its zones, all bodies at the start, the way of the driven body stage by stage, gravity, dimensions and a scale
/// bar. `title` (plain text) is for those who cannot see it. Cases that look the same are drawn the same.
Drawing draw_case(const problem::Case& settings, const std::string& title);
/// The same with the ground of a run, where more is known of it than the case says.
Drawing draw_case(const problem::Case& settings, const std::string& title, const problem::Ground& ground);

}  // namespace berm::report
