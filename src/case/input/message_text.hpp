// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

namespace berm::input {

/// Edit distance of two words: insertions, deletions, replacements and swaps of neighbours (optimal string alignment).
int edit_distance(const std::string& a, const std::string& b);

/// The word of a list that was probably meant, or "" where none is near: at most one edit and one more for every four
/// letters, or else the only word that begins with what was written.
std::string nearest(const std::string& word, const std::vector<std::string>& words);

/// `; did you mean "x"? (allowed: x, y, ...)`, as far as applicable.
std::string suggestion(const std::string& word, const std::vector<std::string>& allowed);

/// At most twelve words, separated by commas.
std::string listed(const std::vector<std::string>& words);

/// The first `max` bytes of a text and "...", or all of it; no UTF-8 character is cut.
std::string shortened(const std::string& text, std::size_t max);

/// A text in quotes, on one line, cut after 60 bytes.
std::string in_quotes(const std::string& text);

/// A quantity in its SI unit, angles in degrees: "0.02 m", "35 deg".
std::string quantity(Real value, const std::string& si_unit);

/// The admissible range, angles in degrees with radians beside them: "more than 0 m", "from 0 to 89.9 deg (0 to 1.569 rad)";
/// "" where it is unbounded.
std::string range_text(const Range& range, const std::string& si_unit);

bool within(Real value, const Range& range);

}  // namespace berm::input
