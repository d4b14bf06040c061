// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "envelope/envelope_probes.hpp"
#include "os/error.hpp"

#include <string>

namespace berm::test {

/// Why no probes are made of a case; "" where they are.
inline std::string refusal_of(const settings::Case& c, const envelope::EnvelopeSettings& how = {})
{
  try {
    envelope::choose_probes(c, how);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace berm::test
