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

/// A line on slices of soil, all of one model. The first slice, at x = 0, is the caller's, in which the pipe was laid; the others are copies of its state at that moment, or have soil of their own. Each step the line is moved under the
/// forces of the soil in the step before (beam/step.hpp), and then each slice's pipe by the line's mean velocity there:
///
///   F = H - C (v - v_then),  C = max(0, 3 m_c - m)/dt,
///
/// with the mass m_c of the soil that moves with the pipe in a step and the mass m of the line: a reaction that is a step late is stable while m_c < m, and with C at any m_c. Of several
/// ranks each has the whole line and the soil of every n-th slice, which it steps; after a step they tell each other its forces. The first rank has room for all, as it writes checkpoints.
class CoupledLine {
public:
  CoupledLine(const settings::Case& c, const problem::Model<2>& model);

  /// Gives slice k > 0 a soil of its own, in which the pipe is laid before the slices are hung. Both must outlive this.
  void give_soil(std::size_t k, const problem::Model<2>& model, const problem::State<2>& laid) { soils_[k] = {&model, &laid}; }
  /// Hangs the slices on the line: copies the first one, laid.
  void couple(const problem::State<2>& laid);
  bool is_coupled() const { return coupled_; }
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
  /// Whether a slice is springs of the far soil, and its own soil waits as the pipe was laid in it.
  bool is_spring(std::size_t k) const { return is_spring_[k] != 0; }
  /// Slice k > 0.
  const problem::State<2>& slice(std::size_t k) const { return *others_[k - 1]; }
  /// Steps of soil, of all slices together.
  BigIndex slice_steps() const { return slice_steps_; }
  std::size_t count() const { return of_case_.places.size(); }

  /// Without the first slice, which must have been read before.
  void archive(Archive& k, const problem::State<2>& first);
  /// Becomes the line of a shorter mesh of the same case, which has been read. `first`: of the first slice, carried to this mesh; `start`: as it was laid anew here.
  void lengthen(const CoupledLine& before, const settings::Case& c, const problem::State<2>& first, const problem::State<2>& start);
  /// The rank that steps the soil of slice k.
  static int rank_of(std::size_t k);
  /// The soil of the slices k > 0 that a rank steps.
  void archive_of_rank(Archive& k, int rank);

private:
  void begin_as_springs();
  void resolve();
  void scale_springs(const problem::State<2>& first);
  void find_reactions_of_springs();
  void let_time_pass(Real dt, problem::State<2>& state) const;
  void step_as_spring(Index k, Real dt, problem::State<2>& state) const;
  void load_line(const LineLoads& now, Real dt);
  Real time_step(const problem::State<2>& first) const;
  Real step_line(const problem::State<2>& first, Real dt);
  /// What a slice is a copy of; without a state of its own the first one.
  struct Soil {
    const problem::Model<2>* model;
    const problem::State<2>* laid;
  };

  const problem::Model<2>& model_of(std::size_t k) const { return *soils_[k].model; }
  void make_others(const problem::State<2>& first);
  void begin_soils();
  /// Whether this rank steps the soil of a slice.
  bool own(Index k) const;
  // With what failed on this rank; throws RunError on all where it did on one.
  void share_time_steps(problem::State<2>& first, const std::string& fault);
  void share_slices(problem::State<2>& first, const std::string& fault);
  template <class Act>
  void for_slice(Index k, const Act& act) const;

  LineOfCase of_case_;
  std::vector<Soil> soils_;  ///< by slice
  beam::State state_;
  beam::Work work_;
  beam::Loads loads_;
  LineLoads from_;  ///< when the stage began
  bool coupled_ = false;
  std::vector<Index> is_spring_;  ///< by slice
  BigIndex slice_steps_ = 0;
  Real laid_embedment_ = 0;  ///< m, of the pipe
  std::vector<SliceForce> forces_;
  std::vector<std::unique_ptr<problem::State<2>>> others_;
  std::vector<std::unique_ptr<mpm::Workspace<2>>> workspaces_;
  // By slice, of a step: forces (N/m) or velocities (m/s) of its pipe, and its impedance, N s/m2.
  std::vector<Real> sideways_, upwards_, impedances_;
  // By slice: part on springs, resistance along the line (N/m), forces of the springs on the pipe (N/m).
  std::vector<Real> spring_parts_, resistances_, springs_sideways_, springs_upwards_;
  std::vector<Real> before_, moved_, spring_forces_;  ///< by freedom
  // Of ranks: what this one and all tell, and where each one's bytes begin.
  std::vector<Real> told_, told_by_all_;
  std::vector<std::size_t> first_of_rank_;
  std::vector<Real> on_springs_, along_;  ///< by node: m of the line on springs across it, N of resistance along it
};

}  // namespace berm::slices
