// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace berm::test {

/// The text of a file of tests/samples.
inline std::string sample(const char* name)
{
  std::ifstream file(std::filesystem::path(BERM_SOURCE_DIR) / "tests/samples" / name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A pipe on sand, coarse and driven fast: a tenth of a second of computing. Rest, push by 2 mm, drag by 2 mm.
inline const std::string small_case = sample("mpm_case.toml");

/// A pipe in clay, half of it below the surface: coarse, less than a second of computing. Rest, push to 60 N/m, drag by 0.4 mm.
inline const std::string small_fem_case = sample("fem_case.toml");

/// Half of a short pipe on a seabed in space, coarse and driven fast: a second of computing. Pushed by 15 mm, then dragged by 30 mm along z: its weight may sink it,
/// and it may turn about its axis.
inline const std::string small_space_case = sample("space_case.toml");

/// Half of a square footing tied to clay, by 96 elements in space: pushed, then dragged along z while it may tilt.
inline const std::string small_fem_space_case = sample("fem_space_case.toml");

/// A pipe of 0.4 m that is laid on soft clay, on cells of D/5: 500 particles. Its line, which hardly bends, has four slices, 1 m apart, and is loaded sideways.
inline const std::string small_line_case = sample("pipeline_case.toml");

}  // namespace berm::test
