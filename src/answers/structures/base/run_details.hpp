// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/summary.hpp"

#include <optional>

namespace berm::base {

/// Numbers of a run that its summary.json does not hold: they are taken from history and frames when they are asked for.
class RunDetails {
public:
  virtual ~RunDetails() = default;

  virtual std::vector<std::string> names() const = 0;
  /// The number of that name, taken at a place (a length over D, a force in N/m); NaN where the run has none, empty where the name is not known. Throws InputError
  /// where it needs a place and has none, RunError where a frame is damaged.
  virtual std::optional<run_folder::Quantity> find(const std::string& name, std::optional<Real> at) const = 0;
};

}  // namespace berm::base
