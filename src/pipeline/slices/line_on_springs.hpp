// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/step.hpp"
#include "slices/line_of_case.hpp"

#include <functional>

namespace berm::slices {

/// The loads of a line but for what soil in slices carries; `on_springs`: m of each node on springs across it, which have no force where the line was laid.
void put_loads(const LineOfCase& of, const LineLoads& now, const std::vector<Real>& on_springs, beam::Loads& loads);

/// The line of a case on springs alone.
class LineOnSprings {
public:
  /// On the springs of the far soil, everywhere; the resistance of an interface along the line is that at this embedment (m), a tenth of the diameter while nobody knows it.
  explicit LineOnSprings(const settings::Case& c, std::optional<Real> embedment = {});

  /// A step of time, dt (s), under loads at its end; in halves where the line finds no equilibrium.
  void step(const LineLoads& now, Real dt);

  const LineOfCase& of_case() const { return of_case_; }
  const beam::State& state() const { return state_; }
  void archive(Archive& k) { beam::archive(k, state_); }

private:
  LineOfCase of_case_;
  beam::State state_;
  beam::Work work_;
  beam::Loads loads_;
};

/// Who watches a line on its way.
struct Watch {
  std::function<void(std::size_t stage, Real dt)> step;  ///< after each step
  /// At the end of a stage, between the loads before it and at its end: whether the line goes on.
  std::function<bool(std::size_t stage, const LineLoads& before, const LineLoads& now)> stage_end;
};

/// Takes the line through the stages that load it, each so many times slower. In a step it goes a hundredth of its diameter, so that snaps are resolved and slow heating costs little. It ends early
/// where a line of many nodes would take more than about a second of a processor, or finds no equilibrium.
void go_through_stages(const settings::Case& c, Real slower, const Watch& watch, LineOnSprings& line);

}  // namespace berm::slices
