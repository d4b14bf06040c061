// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "user_law/library.hpp"
#include "user_law/loaded_law.hpp"

namespace berm::samples {

/// A law of the library of tests/samples/trial_laws.cpp, elastic where it can be: E = 10 MPa, nu = 0.25, one state variable.
inline user_law::LoadedLaw trial_law(const std::string& name, bool one_at_a_time = false)
{
  void* const library = user_law::open_library(BERM_TRIAL_LAWS).handle;
  const auto function = reinterpret_cast<int (*)(berm_law_increment*)>(user_law::find_function(library, BERM_TRIAL_LAWS, {name}).address);
  return {function, {"clay", {1e7, 0.25}, 1}, "the law " + name, one_at_a_time};
}

}  // namespace berm::samples
