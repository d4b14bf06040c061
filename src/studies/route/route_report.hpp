// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "route/route_answer.hpp"

namespace berm::route {

/// An input of berm route and what came of it.
struct RouteResults {
  RouteCase settings;
  std::string input;  ///< its text
  std::vector<SectionAnswer> answer;
  Real wall_s = 0;
};

/// The name of the page in the folder.
constexpr const char* page_file = "route.html";

/// Writes route.html, summary.json, springs.csv (by KP), soils.csv (for BuckPy), lateral.png, axial.png, buckling.png and case.toml. Throws RunError.
void write_results(const RouteResults& results, const std::filesystem::path& folder);

/// The numbers, and the answer.
std::string words_of_results(const RouteResults& results);

/// The headings of BuckPy's sheet Soils.
std::vector<std::string> buckpy_columns();

}  // namespace berm::route
