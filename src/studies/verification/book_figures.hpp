// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verification/expectation_result.hpp"

namespace berm::verification {

/// Draws FOLDER/NAME.png of an expectation about a column: the column over time, the window shaded, and what is expected, with its tolerance where it is
/// a level. Of an order of convergence: errors over cell size, both logarithmic, with the fitted slope. False where there is nothing to draw.
bool draw_finding(const std::filesystem::path& folder, const std::string& name, const Expectation& e, const ExpectationResult& finding,
                  const std::filesystem::path& run_folder);

}  // namespace berm::verification
