// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "soil_fit/fit_soil.hpp"

namespace berm::soil_fit {

/// An input of berm fit and what came of it.
struct FitResults {
  FitCase settings;
  std::string input;  ///< its text
  FittedSoil soil;
  Real wall_s = 0;
};

/// Whether the folder holds what write_results leaves.
bool holds_results(const std::filesystem::path& folder);

/// Writes fit.html, summary.json, curves.csv, material.toml (to paste into a case), priors.toml (for a study), case.toml and the figures. Throws RunError.
void write_results(const FitResults& results, const std::filesystem::path& folder);

/// The keys, how far the tests are met, and what they do not tell, for people.
std::string words_of_results(const FitResults& results);

/// Draws KIND_WHAT.png: what was measured as points and what the law makes of it as lines. Gives the names without ".png".
std::vector<std::string> draw_figures(const FitResults& results, const std::filesystem::path& folder);

/// The material with what was found, as TOML to paste into a case.
std::string material_toml(const FitResults& results);

/// What the tests do not determine, a sentence each; none where they tell all keys.
std::vector<std::string> doubts(const FittedSoil& soil);

}  // namespace berm::soil_fit
