// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/cpt/cpt_report_test.cpp
#pragma once

#include "cpt/profile.hpp"

#include <filesystem>

namespace berm::cpt {

/// A sounding and what came of it.
struct CptResults {
  site::Sounding sounding;
  Choice choice;
  Profile profile;
};

/// The name of the page in the folder.
constexpr const char* page_file = "cpt.html";

/// Writes cpt.html, summary.json, profile.csv, layers.csv, layers.toml (materials and layers of a case) and pictures. Throws RunError.
void write_results(const CptResults& results, const std::filesystem::path& folder);

/// The layers as a table.
std::string words_of_results(const CptResults& results);

/// Materials and layers, to paste into a case.
std::string layers_toml(const CptResults& results);

}  // namespace berm::cpt
