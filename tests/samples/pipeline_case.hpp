// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "samples/small_cases.hpp"

#include "input/read_case.hpp"

namespace berm::test {

inline settings::Case line_case(const std::vector<std::string>& set = {})
{
  return input::read_case_text("line.toml", small_line_case, set);
}

}  // namespace berm::test
