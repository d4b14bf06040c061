// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/summary.hpp"

#include <functional>
#include <optional>

namespace berm::base {

/// Numbers of a run that its summary.json does not hold: they are taken from history and frames when they are asked for.
struct RunDetails {
  std::vector<std::string> names{};
  /// The number of that name, taken at a place (a length over D, a force in N/m); NaN where the run has none, empty where the name is not known. Throws InputError
  /// where it needs a place and has none, RunError where a frame is damaged. Empty: there are none.
  std::function<std::optional<run_folder::Quantity>(const std::string& name, std::optional<Real> at)> find{};
};

}  // namespace berm::base
