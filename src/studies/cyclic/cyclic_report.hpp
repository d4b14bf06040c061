// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cyclic/cyclic_settings.hpp"

namespace berm::cyclic {

/// An input of berm cyclic and what came of it.
struct CyclicResults {
  CyclicCase settings;
  std::string input;  ///< its text
  StormStrength strength;
  Real wall_s = 0;

  /// Average and cyclic shear stress at failure over s_u.
  Real factor() const { return settings.storm.average() + strength.stress; }
};

/// The name of the page in the folder.
constexpr const char* page_file = "cyclic.html";

/// Writes cyclic.html, summary.json, parcels.csv, contours.png, material.toml where there is a material, and case.toml. Throws RunError.
void write_results(const CyclicResults& results, const std::filesystem::path& folder);

/// The parcels one by one, and the answer.
std::string words_of_results(const CyclicResults& results);

/// The clay with its undrained strength times factor(), as TOML to paste into a case.
std::string material_toml(const CyclicResults& results);

}  // namespace berm::cyclic
