// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verification/book.hpp"

namespace berm::verification {

std::string link_to(const std::string& address, const std::string& text);

/// Addresses have no spaces; everything that is no plain character is written as %XX.
std::string address_of(const std::filesystem::path& path);

/// A verdict with its colour.
std::string badge(Verdict verdict);

std::string readme_of(const Example& example);

/// Its name and the first heading of its README.
std::string title_of(const Example& example);

/// Cells of a table: what is expected, what berm gives, the error, the tolerance, the verdict.
std::vector<std::string> numbers_of(const ExpectationResult& finding);

/// How long a problem took, "" where it has no result.
std::string time_of(const ProblemResult& result);

/// Of a run of the example; null where there is none of that name.
const ProblemResult* result_of(const ExamplePage& page, const std::string& run);

/// The id of the section of the orders of convergence, which belong to no one run.
inline constexpr const char* convergence = "convergence";
}  // namespace berm::verification
