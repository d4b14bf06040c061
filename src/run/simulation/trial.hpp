// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "problem/model.hpp"
#include "run_folder/summary.hpp"

#include <cmath>

namespace berm::simulation {

/// A trial of the factor of safety (problem/safety.hpp): whether the soil stands with less strength. Its movement is the largest displacement of a point of the soil since the start, or since the last
/// stage that moved a body ended. The soil
///
///   fails    where it moves by more than the limit in a stage that moves no body, finds no equilibrium, or (finite elements) goes on flowing in the last half of the last stage, and yields;
///   stands   where it has not failed, and rests at the end of the last stage, or yields nowhere (finite elements): what moves it then is its water.
///
/// Soil that still moves while some of it yields, but too little of it to flow, is undecided.
class Trial {
public:
  /// `limit`: m; `time_factor`: c_v T / H^2 of the last stage (settings::time_factor_of_last_stage).
  explicit Trial(Real limit, Real time_factor = nan) : limit_(limit), time_factor_(time_factor) {}

  /// A stage begins; `counts`: it moves no body, so that movement is a sign of failure.
  void begin_stage(bool counts);
  /// The movement now, m.
  void note(Real movement);
  /// The same at a time, s, of a method whose soil flows at a steady speed where it fails.
  void note(Real time, Real movement);
  void note_no_equilibrium() { no_equilibrium_ = true; }
  /// The last stage of a method whose soil flows where it fails ends with this part of the stress of yielding soil beyond its strength.
  void end_flow(Real overstress);
  /// The last stage has ended.
  void end(bool rests) { rests_ = rests; }

  bool failed() const { return failed_ || no_equilibrium_ || flowed_; }
  Real movement() const { return movement_; }
  Real limit() const { return limit_; }
  /// Whether more than a tenth of the movement fell into the last half of the stage's time; not of what is less than a thousandth of the limit.
  bool flows_on() const;

  run_folder::Summary::Checks checks() const;
  /// "the soil fails with its strength over 1.4: ..."
  std::string words(Real factor) const;
  void archive(Archive& k);

private:
  Real limit_;  ///< m
  Real time_factor_;
  Real movement_ = 0;
  bool counts_ = true, failed_ = false, no_equilibrium_ = false, flowed_ = false, rests_ = false;
  std::vector<Real> times_, movements_;  ///< of the present stage
};

/// Means of a number over windows of time that lie behind one another: those of the last two whole ones tell how it drifts, without its swings.
class WindowMeans {
public:
  explicit WindowMeans(Real length = 0) : length_(length) {}
  /// The next number; the windows begin anew where the time since the beginning is less than before.
  void note(Real since, Real value);
  /// The change from one window to the next; infinity while there are less than two.
  Real drift() const { return count_ < 2 ? infinity : std::abs(last_ - before_); }
  void archive(Archive& k);

private:
  Real length_;               ///< s
  Real begin_ = 0, now_ = 0;  ///< s, of the open window, and of the last number
  Real sum_ = 0, numbers_ = 0;
  Real last_ = 0, before_ = 0;
  Index count_ = 0;  ///< of whole windows
};

/// Where the particles of all bodies were, by body, id and direction.
template <int dim>
class ParticlePlaces {
public:
  void note(const problem::State<dim>& state);
  /// The largest displacement from there, m.
  Real largest_movement(const problem::State<dim>& state) const;
  void archive(Archive& k);

private:
  std::vector<std::vector<Real>> places_;
};

}  // namespace berm::simulation
