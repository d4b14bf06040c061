// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verification/expectation_result.hpp"

namespace berm::verification {

/// An example with all that came of it: a chapter of the book.
struct Chapter {
  Example example;
  std::vector<ProblemResult> results;       ///< of example.runs
  std::vector<ExpectationResult> findings;  ///< of example.expectations
};

/// Writes the verification book: OUTPUT/index.html with the table of all numbers, and a page OUTPUT/EXAMPLE.html for each chapter with its README, and
/// for each problem its numbers, figures and files. The pages need nothing but what is in OUTPUT; the run folders are expected there. Throws RunError.
void write_book(const std::filesystem::path& output, const std::vector<Chapter>& chapters);

}  // namespace berm::verification
