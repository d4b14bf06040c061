// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace berm::test {

/// The message of the Error that act() throws, "" where it throws none.
template <class Error, class Act>
std::string error_of(const Act& act)
{
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace berm::test
