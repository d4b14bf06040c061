// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <optional>
#include <string>
#include <vector>

namespace berm::base {

/// How an observable is measured, and where: lengths and areas over D and D2, forces in N/m.
enum class ObservableUnit { length, area, force, number, none };

/// A number that a claim may be about: its word in claims.toml, and whether it needs a place at which it is taken.
struct Observable {
  const char* word;
  ObservableUnit unit, at;
  bool needs_at;
};
using Observables = std::vector<Observable>;

/// A run as claims look at it; what it reads of its record it reads once.
class ObservedRun {
public:
  virtual ~ObservedRun() = default;

  /// The number of an observable of the run's structure, by its word; NaN where the run has none. Throws RunError where a frame is damaged.
  virtual Real value(const std::string& word, std::optional<Real> at) const = 0;
  /// The embedment over D with which the drag begins; empty without a drag.
  virtual std::optional<Real> begin_of_drag() const = 0;
  /// Whether the drag comes to a displacement over D.
  virtual bool drag_reaches(Real displacement) const = 0;
};

}  // namespace berm::base
