// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "safety/search.hpp"
#include "settings/case.hpp"

#include <filesystem>

namespace berm::safety {

/// Of its folder: F_1.3750.
std::string trial_name(Real factor);

/// safety.csv: a line a trial, by factor. What is not known is empty.
std::string safety_csv(const std::vector<Trial>& trials);

/// The table of trials for people, and the answer below it.
std::string safety_words(const std::vector<Trial>& trials);

/// The answer alone: "F = 1.378 to 1.385: ...".
std::string answer_in_words(const std::vector<Trial>& trials);

/// Why the answer is to be doubted, a sentence each: water that still flows at the end, soil that fails at every factor, movements that do not depend on the factor, and what cells do to it.
std::vector<std::string> doubts_of(const std::vector<Trial>& trials, settings::Method method);

/// Writes FOLDER/safety.csv, summary.json, movement.png (over the factor), movement_in_time.png (of the two trials beside the answer and those next to them) and safety.html with both, what failure means and
/// the soil of these two trials. The trials are in the order of their factors; `finished`: the search is over.
void write_safety_report(const settings::Case& settings, const std::vector<Trial>& trials, const std::filesystem::path& folder,
                         bool finished);

/// Draws the figures; the names of those that were drawn, without ".png".
std::vector<std::string> draw_safety(const std::vector<Trial>& trials, const std::filesystem::path& folder, const std::string& title);

}  // namespace berm::safety
