// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sea/sea_answer.hpp"

namespace berm::sea {

/// An input of berm sea and what came of it.
struct SeaResults {
  SeaCase settings;
  std::string input;  ///< its text
  SeaAnswer answer;
  Real wall_s = 0;
};

/// The name of the page in the folder.
constexpr const char* page_file = "sea.html";

/// Writes sea.html, summary.json, spectrum.png, waves.png, record_SEED.csv and waves_SEED.csv (load histories), stage.toml, storm.toml (for berm cyclic) and case.toml. Throws RunError.
void write_results(const SeaResults& results, const std::filesystem::path& folder);

/// The numbers, and the answer.
std::string words_of_results(const SeaResults& results);

/// A table of loads of the largest waves, one after the other: rows of H and V at equal times, which begin and end at H = 0 and the submerged weight.
struct LoadRow {
  Real time, H, V;
};
std::vector<LoadRow> load_history_of(const SeaCase& c, const LoadRecord& record, const std::vector<LoadWave>& waves);

}  // namespace berm::sea
