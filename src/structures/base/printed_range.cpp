// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/results_section_test.cpp
#include "structures/base/printed_range.hpp"

#include "text/html.hpp"

namespace berm::base {

std::string printed_range(const char* range)
{
  constexpr std::pair<const char*, const char*> signs[] = {{"&lt;=", "≤"},
                                                           {"&gt;=", "≥"},
                                                           {"phi", "φ"},
                                                           {"psi", "ψ"},
                                                           {"delta", "δ"},
                                                           {" deg", "°"},
                                                           {"s_u0", "s<sub>u0</sub>"},
                                                           {"s_u", "s<sub>u</sub>"},
                                                           {"V_max", "V<sub>max</sub>"},
                                                           {"I_r", "I<sub>r</sub>"}};
  std::string text = text::html_text(range);
  for (const auto& [plain, sign] : signs)
    for (std::size_t at = text.find(plain); at != std::string::npos; at = text.find(plain, at + 1))
      text.replace(at, std::string(plain).size(), sign);
  return text;
}

}  // namespace berm::base
