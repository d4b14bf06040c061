// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/step.hpp"
#include "slices/line_of_case.hpp"

namespace berm::slices {

/// The loads of a line but for what soil in slices carries; `on_springs`: m of each node on springs across it, which have no force where the line was laid.
void put_loads(const LineOfCase& of, const LineLoads& now, const std::vector<Real>& on_springs, beam::Loads& loads);

/// The line of a case on springs alone.
class LineOnSprings {
public:
  /// On the springs of the far soil, everywhere; the resistance of an interface along the line is that at this embedment (m).
  LineOnSprings(const problem::Case& c, Real embedment);

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

}  // namespace berm::slices
