// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/read_case.hpp"
#include "os/error.hpp"
#include "samples/wrong_inputs.hpp"

namespace berm::test {

/// The message that refuses the good case with these keys; "" where it is read.
inline std::string refusal_with(const std::vector<std::string>& keys)
{
  try {
    input::read_case_text("case.toml", std::string(good_case), keys);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace berm::test
