// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verification/expectation_result.hpp"

namespace berm::verification {

std::string link_to(const std::string& address, const std::string& text);

/// Addresses have no spaces; everything that is no plain character is written as %XX.
std::string address_of(const std::filesystem::path& path);

/// A verdict with its colour.
std::string badge(Verdict verdict);

std::string readme_of(const Example& example);

/// Its name and the first heading of its README.
std::string title_of(const Example& example);

/// The id of the section of the orders of convergence, which belong to no one run.
inline constexpr const char* convergence = "convergence";
}  // namespace berm::verification
