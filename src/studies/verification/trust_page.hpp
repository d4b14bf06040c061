// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/quality/judgement.hpp"
#include "verification/book.hpp"

namespace berm::verification {

/// A number is right up to this error, relative, and wrong beyond the other; what is between is neither.
constexpr Real error_of_right = 0.05, error_of_wrong = 0.10;

/// A run whose answer is known, and what its page says of it.
struct TrustQuestion {
  std::string problem;          ///< EXAMPLE/RUN
  std::string example, run;     ///< its parts
  std::string what, exact;      ///< the number that is farthest off
  Real error;                   ///< of that number, relative
  report::Judgement judgement;  ///< of the page

  bool is_right() const { return std::abs(error) <= error_of_right; }
  bool is_wrong() const { return std::abs(error) > error_of_wrong; }
  /// Whether the page misleads: a right answer called bad, a wrong one called good.
  bool is_misjudged() const;
};

/// Those of all runs with a number that is known to a relative tolerance.
std::vector<TrustQuestion> trust_questions(const std::vector<ExamplePage>& pages);

/// "61 runs whose answer is known: of 52 right ones 0 are called bad, of 7 wrong ones 0 are called good".
std::string words_of(const std::vector<TrustQuestion>& questions);

/// All of them as a page of the book, those that are misjudged first.
std::string trust_page(const std::vector<TrustQuestion>& questions);

}  // namespace berm::verification
