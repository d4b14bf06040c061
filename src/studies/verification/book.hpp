// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verification/expectation_result.hpp"

namespace berm::verification {

/// An example with all that came of it: a page of the book.
struct ExamplePage {
  Example example;
  std::vector<ProblemResult> results;       ///< of example.runs
  std::vector<ExpectationResult> findings;  ///< of example.expectations
};

struct TrustQuestion;

/// Writes the verification book: OUTPUT/index.html with the numbers of each chapter, a page OUTPUT/EXAMPLE.html for each example with its README, and
/// for each problem its numbers, figures and files, and OUTPUT/trust.html. The pages need nothing but what is in OUTPUT; the run folders are expected there.
/// Throws RunError.
void write_book(const std::filesystem::path& output, const std::vector<ExamplePage>& pages, const std::vector<TrustQuestion>& questions);

}  // namespace berm::verification
