// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sea/displacement.hpp"

namespace berm::sea {

/// An input of berm sea and what came of it.
struct SeaResults {
  SeaCase settings;
  std::string input;  ///< its text
  SeaAnswer answer;
  std::optional<Displacements> moved;
  Real wall_s = 0;
};

/// The name of the page in the folder.
constexpr const char* page_file = "sea.html";

/// Writes sea.html, summary.json, spectrum.png, waves.png, record_SEED.csv and waves_SEED.csv (load histories), stage.toml, storm.toml (for berm cyclic) and case.toml; of a pipe on a macro-element track_SEED.csv, track.png and distribution.png, too. Throws RunError.
void write_results(const SeaResults& results, const std::filesystem::path& folder);

/// The numbers, and the answer.
std::string words_of_results(const SeaResults& results);

}  // namespace berm::sea
