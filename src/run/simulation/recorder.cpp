// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/run_test.cpp
#include "simulation/recorder.hpp"

namespace berm::simulation {

template <int dim>
void Recorder<dim>::observe_rigid(const problem::Model<dim>& model, const problem::State<dim>& state, Index rigid, const Vec<dim>& reaction)
{
  const RigidResponse response = response_of(model, state, rigid, reaction);
  observe<dim>(row_, response);
  if (rigid == model.main_rigid) horizontal_ = row_.parts() * response.H, vertical_ = row_.parts() * response.V;
}

template <int dim>
void Recorder<dim>::observe_energies(const Energies& energies, Real at_least)
{
  observe<dim>(row_, energies);
  largest_error_ = std::max(largest_error_, std::abs(energies.error));
  largest_work_ = std::max({largest_work_, std::abs(energies.external), std::abs(energies.internal), at_least});
}

template <int dim>
void Recorder<dim>::observe_overlap()
{
  row_("overlap", max_overlap_, run_folder::metres, "overlap");
  max_overlap_ = 0;
}

template <int dim>
void Recorder<dim>::observe_movement()
{
  if (!movement_) return;
  row_.of_main("run");
  row_("movement", *movement_, run_folder::metres, "largest displacement of the soil since the start, or since a stage that moved a body");
}

template <int dim>
void Recorder<dim>::archive(Archive& k)
{
  k("vertical", vertical_);
  k("horizontal", horizontal_);
  k("largest_error", largest_error_);
  k("largest_work", largest_work_);
  k("max_overlap", max_overlap_);
}

template class Recorder<2>;
template class Recorder<3>;

}  // namespace berm::simulation
