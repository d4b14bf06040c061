// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/step.hpp"
#include "mpm/grid.hpp"
#include "slices/line_of_case.hpp"

#include <functional>
#include <memory>

namespace berm::slices {

/// What a slice gives its part of the line.
struct SliceForce {
  Vec<2> force = Vec<2>::Zero();  ///< N/m, of the soil on the pipe in the last step; when it is hung, the mean of many
  Real contact_mass = 0;          ///< kg/m, of soil at the nodes that the pipe touches
};

/// A line on slices of soil, all of one model. The first slice, at x = 0, is the caller's, in which the pipe was laid; the others are copies of its state at that moment. Each step the line is moved under the
/// forces of the soil in the step before (beam/step.hpp), and then each slice's pipe by the line's mean velocity there:
///
///   F = H - C (v - v_then),  C = max(0, 3 m_c - m)/dt,
///
/// with the mass m_c of the soil that moves with the pipe in a step and the mass m of the line: a reaction that is a step late is stable while m_c < m, and with C at any m_c.
class CoupledLine {
public:
  CoupledLine(const problem::Case& c, const problem::Model<2>& model);

  /// Hangs the slices on the line: copies the first one, laid.
  void hang(const problem::State<2>& laid);
  bool hangs() const { return hangs_; }
  /// In a new stage of loads: where they go from. The first slice has begun the stage already.
  void begin_stage(const problem::State<2>& first);
  /// Finds the stable time steps of all slices where they do not hold any more.
  void find_time_steps(problem::State<2>& first, mpm::Workspace<2>& workspace);
  /// One step of all. `step_first` steps the first slice, whose stable time step and drive are set.
  void step(problem::State<2>& first, mpm::Workspace<2>& workspace, const std::function<void()>& step_first);

  const LineOfCase& of_case() const { return of_case_; }
  const beam::State& state() const { return state_; }
  const std::vector<SliceForce>& forces() const { return forces_; }
  /// At a time (s) in the stage that the first slice is in.
  LineLoads loads_at(const problem::State<2>& first, Real time) const;
  /// Slice k > 0.
  const problem::State<2>& slice(std::size_t k) const { return *others_[k - 1]; }
  std::size_t count() const { return of_case_.places.size(); }

  /// Without the first slice, which must have been read before.
  void archive(Archive& k, const problem::State<2>& first);

private:
  void load_line(const LineLoads& now, Real dt);
  Real step_line(const problem::State<2>& first, Real dt);
  void make_others(const problem::State<2>& first);
  template <class Act>
  void for_slice(Index k, const Act& act) const;

  const problem::Model<2>& model_;
  LineOfCase of_case_;
  beam::State state_;
  beam::Work work_;
  beam::Loads loads_;
  LineLoads from_;  ///< when the stage began
  bool hangs_ = false;
  std::vector<SliceForce> forces_;
  std::vector<std::unique_ptr<problem::State<2>>> others_;
  std::vector<std::unique_ptr<mpm::Workspace<2>>> workspaces_;
  // By slice, of a step.
  std::vector<Real> sideways_, upwards_, of_slices_;
  std::vector<Real> before_, moved_;  ///< by freedom
};

}  // namespace berm::slices
