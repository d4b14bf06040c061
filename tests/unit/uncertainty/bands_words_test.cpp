// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/bands.hpp"

#include <gtest/gtest.h>

namespace berm::uncertainty::this_file {
namespace {

TEST(Words, tell_the_number_the_converged_one_and_what_it_is_uncertain_by)
{
  run_folder::Uncertainty u;
  u.quantities = {{"V_at_w_0.1D", "N/m", {808.25, 715.5, 61.125, 1.125, 46, 14, 1, 5.5}},
                  {"w_end_of_push", "m", {0.002, 0.002, 0, nan, 0, 0, 0, 0}}};
  u.runs = {{"cells_0.5", 0.5, 1, 30}, {"cells_1.5", 1.5, 1, 10}};
  u.without = {{"H_residual", "cells_2.2 has no such number"}};
  u.left_out = {"speed: the strength of the soil depends on it"};
  const std::string words = words_of(u, settings::Method::mpm);
  for (const char* part :
       {"2 more runs, on cells 0.5 to 1.5 times as large, 40 s", " 1.1 ", " - ", "808", "720 +- 60 N/m", "2.000 +- 0 mm", " 5.5\n",
        "speed\n", "not in the bands: speed: the strength", "without a band: H_residual: cells_2.2 has no such number"})
    EXPECT_NE(words.find(part), std::string::npos) << part << " is not in\n" << words;
  EXPECT_NE(words_of(u, settings::Method::fem).find("increments\n"), std::string::npos);
}

TEST(Words, tell_what_grains_would_do_to_the_numbers)
{
  run_folder::Uncertainty u;
  u.grains = {2.2, {0.1e-3, 0.5e-3}, {{"V_at_w_0.1D", "N/m", 820, {690, 760}}, {"w_end", "m", 0.006, {0.0055, 0.0058}}}};
  const std::string words = words_of(u, settings::Method::mpm);
  for (const char* part : {"on cells 2.2 times as large", "d50 0.1 mm", "d50 0.5 mm\n", "690           760 N/m", "5.8 mm"})
    EXPECT_NE(words.find(part), std::string::npos) << part << " is not in\n" << words;
  EXPECT_EQ(words_of({}, settings::Method::mpm).find("d50"), std::string::npos) << "not where nothing was tried";
}

}  // namespace
}  // namespace berm::uncertainty::this_file
