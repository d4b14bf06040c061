// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "problem/model.hpp"
#include "run_folder/row.hpp"
#include "simulation/observe.hpp"

#include <algorithm>

namespace berm::simulation {

/// What the rows of history.csv have in common, whatever the method: the recorder of a method adds a column where it observes its value.
template <int dim>
class Recorder {
public:
  /// The last one.
  const run_folder::Row& row() const { return row_; }
  /// V and H of the main rigid body in the last row, N/m or N.
  Real vertical() const { return vertical_; }
  Real horizontal() const { return horizontal_; }
  /// The largest |energy error| of all rows over the largest work done so far.
  Real energy_error() const { return largest_work_ > 0 ? largest_error_ / largest_work_ : 0; }
  /// The largest work done so far, J/m or J.
  Real largest_work() const { return largest_work_; }

  /// What the next row takes from those before it, and from the steps since the last one.
  void archive(Archive& k);

protected:
  /// A depth of the soil in the main rigid body, m, of which the next row has the maximum.
  void note_overlap(Real depth) { max_overlap_ = std::max(max_overlap_, depth); }
  void observe_overlap();
  /// u, w, H and V of a rigid body with this force of the soil on it.
  void observe_rigid(const problem::Model<dim>& model, const problem::State<dim>& state, Index rigid, const Vec<dim>& reaction);
  /// The energy error of the run is compared with the largest work, of which `at_least` (J/m or J) is one.
  void observe_energies(const Energies& energies, Real at_least = 0);

  run_folder::Row row_;

private:
  Real vertical_ = 0, horizontal_ = 0, largest_error_ = 0, largest_work_ = 0;
  Real max_overlap_ = 0;  ///< m, since the last row
};

}  // namespace berm::simulation
