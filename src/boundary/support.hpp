// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

namespace berm {

/// Holds the nodes of one boundary of the mesh in some directions.
struct SupportSettings {
  std::string boundary;
  std::vector<std::string> fixed;  ///< "x", "y", "z"
};

void describe(Describe& d, SupportSettings& support);

}  // namespace berm
