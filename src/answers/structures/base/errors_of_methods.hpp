// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/two_methods_test.cpp, tests/unit/commands/check_json_test.cpp
#pragma once

#include "os/numbers.hpp"
#include "os/text_of_list.hpp"

#include <array>
#include <fmt/format.h>

namespace berm::base {

/// How much V of a smooth pipe pushed 0.5 D into clay is above that of an independent program with D/40 (examples/two_methods), by cells or elements of D/n.
struct ErrorOfSize {
  int n;
  Real of_V;
};
using ErrorsOfSizes = std::array<ErrorOfSize, 3>;

inline constexpr ErrorsOfSizes errors_of_remeshed_elements = {{{5, 0.009}, {10, 0.003}, {20, 0.002}}},
                               errors_of_cells = {{{10, 0.037}, {20, 0.017}, {40, 0.009}}};

/// "D/5, D/10, D/20".
inline std::string sizes_words(const ErrorsOfSizes& errors)
{
  std::vector<std::string> words;
  for (const ErrorOfSize& error : errors) words.push_back(fmt::format("D/{}", error.n));
  return text_of_list(words, ", ");
}

/// "0.9, 0.3, 0.3 %".
inline std::string errors_words(const ErrorsOfSizes& errors)
{
  std::vector<std::string> words;
  for (const ErrorOfSize& error : errors) words.push_back(fmt::format("{:.1f}", 100 * error.of_V));
  return text_of_list(words, ", ") + " %";
}

}  // namespace berm::base
