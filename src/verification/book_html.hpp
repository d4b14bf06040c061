// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verification/expectation_result.hpp"

namespace berm::verification {

/// A page of the book: `title` is text, `content` HTML.
std::string page(const std::string& title, const std::string& content);

std::string link_to(const std::string& address, const std::string& text);

/// Addresses have no spaces; everything that is no plain character is written as %XX.
std::string address_of(const std::filesystem::path& path);

/// A verdict with its colour.
std::string badge(Verdict verdict);

/// A row of a table; the cells from first_number to last_number are aligned to the right.
std::string row(const std::vector<std::string>& cells, std::size_t first_number, std::size_t last_number, const char* tag);

std::string readme_of(const Example& example);

/// Its name and the first heading of its README.
std::string title_of(const Example& example);

/// The id of the section of the orders of convergence, which belong to no one run.
inline constexpr const char* convergence = "convergence";
}  // namespace berm::verification
