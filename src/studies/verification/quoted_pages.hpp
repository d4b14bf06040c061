// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verification/book_html.hpp"

namespace berm::verification {

/// Throws InputError where a page does not have a text that expected.toml in its folder says it has, or has it twice.
void check_quotations(const std::filesystem::path& folder, const std::vector<Expectation>& expectations);

/// Puts the numbers of the runs into the pages that quote others, and into expected.toml; says which. Throws RunError.
void quote_results(const std::vector<ExamplePage>& pages);

}  // namespace berm::verification
