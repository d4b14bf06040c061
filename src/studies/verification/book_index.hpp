// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verification/book.hpp"

namespace berm::verification {

/// A problem with the wall time of its run, s.
struct ProblemTime {
  std::string problem;
  Real wall_s;
};

/// The problems with a result that took longest, ten at most, the longest first.
std::vector<ProblemTime> longest_problems(const std::vector<ExamplePage>& pages);

/// The page index.html of the book: by chapter the table of all numbers, and the problems that took longest. `trust`: how far the runs' own pages say what is
/// right, in words.
std::string index_page(const std::vector<ExamplePage>& pages, const std::string& trust);

}  // namespace berm::verification
