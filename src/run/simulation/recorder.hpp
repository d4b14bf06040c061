// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "problem/model.hpp"
#include "problem/stages.hpp"
#include "run_folder/row.hpp"

#include <algorithm>
#include <optional>

// What both methods write into a row of history.csv. A method leaves out what it does not have.

namespace berm::simulation {

/// A rigid body: how far it went since the start, and the force of the soil on it.
struct RigidResponse {
  Real u, w, H, V;  ///< m, m; the forces that hold the soil's reaction: H along x and V downwards, N/m or N
};

/// That of a rigid body with this force of the soil on it. A zero has no sign.
template <int dim>
RigidResponse response_of(const problem::Model<dim>& model, const problem::State<dim>& state, Index rigid, const Vec<dim>& reaction)
{
  const problem::RigidTravel travel = travel_of(model, state, rigid);
  return {travel.u, travel.w, -reaction[model.axes.along] + 0., model.axes.sign * reaction[model.axes.up] + 0.};
}
template <int dim>
void observe(run_folder::Row& row, const RigidResponse& response)
{
  row("u", response.u, run_folder::metres, "horizontal displacement");
  row("w", response.w, run_folder::metres, "embedment");
  row("H", response.H, run_folder::newtons<dim>, "horizontal force");
  row("V", response.V, run_folder::newtons<dim>, "vertical reaction");
}

/// The resultant of what presses a rigid body's surface, where it rubs on soil with water: the integral of the effective normal stress. Times the friction coefficient
/// it is the axial resistance of a pipe.
template <int dim>
void observe_effective_normal(run_folder::Row& row, Real force)
{
  row("N_eff", force, run_folder::newtons<dim>, "effective normal force on the surface");
}

/// A support: its force on the soil, N/m or N. A zero has no sign.
template <int dim>
void observe_reaction(run_folder::Row& row, const Vec<dim>& force)
{
  row("F", Vec<dim>(force + Vec<dim>::Zero()), run_folder::newtons<dim>, "force of the support on the soil");
}

/// Water outside of a support: its excess pressure (Pa), and what of it flows into the soil (m2/s in plane strain, else m3/s). A zero has no sign.
template <int dim>
void observe_head(run_folder::Row& row, Real pressure, Real inflow)
{
  static constexpr run_folder::ColumnUnit whole{"m3/s", "m3_s"};
  static constexpr run_folder::ColumnUnit unit = dim == 2 ? run_folder::ColumnUnit{"m2/s", "m2_s", &whole} : run_folder::of_part(whole);
  row("p", pressure, run_folder::pascals, "excess pore pressure of the water outside");
  row("Q", inflow + 0., unit, "water that flows into the soil");
}

/// Its rotation, counter-clockwise: the moment of the soil on it about its centre (N m/m or N m), and its rotation since the start (rad). In space both are
/// vectors: Mx_Nm, anglex_rad ...
template <int dim>
void observe_rotation(run_folder::Row& row, const bodies::Angular<dim>& moment, const bodies::Angular<dim>& angle)
{
  row("M", moment, run_folder::newton_metres<dim>, "moment");
  row("angle", angle, run_folder::radians, "rotation");
}

/// Energies and work since the start, J/m or J. Without inertia there is no kinetic energy, and nothing that takes it.
struct Energies {
  std::optional<Real> kinetic, damping, filter;
  Real internal, friction, external, error;
};
template <int dim>
void observe(run_folder::Row& row, const Energies& energies)
{
  const run_folder::ColumnUnit& unit = run_folder::joules<dim>;
  if (energies.kinetic) row("kinetic", *energies.kinetic, unit, "kinetic energy");
  row("internal", energies.internal, unit, "internal energy");
  if (energies.damping) row("damping", *energies.damping, unit, "energy lost to damping");
  if (energies.filter) row("filter", *energies.filter, unit, "energy lost to the velocity filter");
  row("friction", energies.friction, unit, "energy lost to friction");
  row("external", energies.external, unit, "work done from outside");
  row("energy_error", energies.error, unit, "error of the energy balance");
}

/// The water of undrained soil at a point with this total stress and excess pore pressure.
template <int dim>
void observe_water(run_folder::Row& row, const settings::BodySoil& soil, const SymTensor<dim>& stress, Real pressure)
{
  const material::Material& material = soil.materials.front();
  const int place = pore_pressure_index(material);
  if (place == none) return;
  std::array<Real, material::max_state> state{};
  state[place] = pressure;
  row("p", pressure, run_folder::pascals, "excess pore pressure");
  row("seff", effective_stress(material, stress, state.data()), run_folder::pascals, "effective stress");
}

/// How far the excess pore pressure of this stage has gone, of soil whose water flows.
template <int dim>
void observe_consolidation(run_folder::Row& row, const problem::StageState<dim>& stage)
{
  row("p_max", stage.excess_pressure, run_folder::pascals, "largest excess pore pressure");
  row("U", degree_of_consolidation(stage), run_folder::bare, "degree of consolidation");
}

inline void observe_out_of_balance(run_folder::Row& row, Real over_weight)
{
  row("out_of_balance", over_weight, run_folder::bare, "force out of balance");
}

/// A traction: its force now, and the mean displacement of where it acts. Summed over points and divided by their area.
template <int dim>
class LoadedArea {
public:
  void add(const Vec<dim>& force, const Vec<dim>& displacement, Real area)
  {
    force_ += force;
    moved_by_ += area * displacement;
    area_ += area;
  }
  void observe(run_folder::Row& row, Real part_of_force, const std::string& meaning) const
  {
    row("F", Vec<dim>(force_ * part_of_force), run_folder::newtons<dim>, "force");
    row("u", Vec<dim>(moved_by_ / area_), run_folder::metres, meaning);
  }

private:
  Vec<dim> force_ = Vec<dim>::Zero(), moved_by_ = Vec<dim>::Zero();
  Real area_ = 0;
};

/// What the rows of history.csv have in common, whatever the method: the recorder of a method adds a column where it observes its value.
template <int dim>
class Recorder {
public:
  explicit Recorder(const problem::Model<dim>& model);

  /// The last one.
  const run_folder::Row& row() const { return row_; }
  /// V and H of the main rigid body in the last row, N/m or N.
  Real vertical() const { return vertical_; }
  Real horizontal() const { return horizontal_; }
  /// The largest |energy error| of all rows over the largest work done so far.
  Real energy_error() const { return largest_work_ > 0 ? largest_error_ / largest_work_ : 0; }
  /// The largest work done so far, J/m or J.
  Real largest_work() const { return largest_work_; }

  /// How far the soil of a trial of the factor of safety has moved, m: from then on a column of the rows.
  void note_movement(Real movement) { movement_ = movement; }

  /// What the next row takes from those before it, and from the steps since the last one.
  void archive(Archive& k);

protected:
  /// A depth of the soil in the main rigid body, m, of which the next row has the maximum.
  void note_overlap(Real depth) { max_overlap_ = std::max(max_overlap_, depth); }
  void observe_overlap();
  void observe_movement();
  /// Whether a stage of the run has displacements count from its beginning.
  bool counts_from_stages() const { return !since_.empty(); }
  /// "displacement", of columns that then do so with the words since when.
  std::string counted(const std::string& what) const { return since_.empty() ? what : what + " " + since_; }
  /// From now on displacements of rigid bodies that count from a stage count from here.
  void zero_rigid_bodies(const problem::State<dim>& state);
  /// Places or displacements that are counted from, of which there are as many when they are read.
  static void archive_zero(Archive& k, const std::string& name, std::vector<Vec<dim>>& zero);
  /// u, w, H and V of a rigid body with this force of the soil on it; where displacements count from a stage, those too.
  void observe_rigid(const problem::Model<dim>& model, const problem::State<dim>& state, Index rigid, const Vec<dim>& reaction);
  /// The energy error of the run is compared with the largest work, of which `at_least` (J/m or J) is one.
  void observe_energies(const Energies& energies, Real at_least = 0);

  run_folder::Row row_;

private:
  std::string since_;                           ///< "since stage "load" began"; "" where all counts from the start
  std::vector<bodies::Pose<dim>> rigid_zeros_;  ///< that displacements of rigid bodies count from
  Real vertical_ = 0, horizontal_ = 0, largest_error_ = 0, largest_work_ = 0;
  Real max_overlap_ = 0;          ///< m, since the last row
  std::optional<Real> movement_;  ///< m
};

}  // namespace berm::simulation
