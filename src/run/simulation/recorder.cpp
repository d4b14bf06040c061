// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/run_test.cpp
#include "simulation/recorder.hpp"

#include "problem/archive_state.hpp"

#include <fmt/format.h>

namespace berm::simulation {

template <int dim>
Recorder<dim>::Recorder(const problem::Model<dim>& model)
    : since_(displacements_since(model.stages)),
      rigid_zeros_(model.rigid_bodies.size())
{
}

template <int dim>
void Recorder<dim>::zero_rigid_bodies(const problem::State<dim>& state)
{
  rigid_zeros_.assign(state.rigid_bodies.begin(), state.rigid_bodies.end());
}

template <int dim>
void Recorder<dim>::archive_zero(Archive& k, const std::string& name, std::vector<Vec<dim>>& zero)
{
  std::vector<Real> numbers;
  for (const Vec<dim>& x : zero) numbers.insert(numbers.end(), x.begin(), x.end());
  if (numbers.empty()) return;
  k.fixed(name, numbers);
  for (std::size_t n = 0; n < numbers.size(); ++n) zero[n / dim][static_cast<Index>(n % dim)] = numbers[n];
}

template <int dim>
void Recorder<dim>::observe_rigid(const problem::Model<dim>& model, const problem::State<dim>& state, Index rigid, const Vec<dim>& reaction)
{
  const RigidResponse response = response_of(model, state, rigid, reaction);
  observe<dim>(row_, response);
  if (counts_from_stages()) {
    const bodies::RigidState<dim>& now = state.rigid_bodies[rigid];
    const bodies::Pose<dim>& from = rigid_zeros_[static_cast<std::size_t>(rigid)];
    const Vec<dim> moved_by = now.displacement - from.displacement;
    row_("since_u", moved_by[model.axes.along], run_folder::metres, counted("horizontal displacement"));
    row_("since_w", -model.axes.height(moved_by) + 0., run_folder::metres, counted("downward displacement"));
    if constexpr (dim == 3) row_("since_d", moved_by, run_folder::metres, counted("displacement of its centre"));
    row_("since_angle", rotation_between(from.orientation, now.orientation), run_folder::radians, counted("rotation"));
  }
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
  if (counts_from_stages())
    for (std::size_t r = 0; r < rigid_zeros_.size(); ++r)
      k.table(fmt::format("zero_of_rigid_{}", r), [&] { problem::archive(k, rigid_zeros_[r]); });
}

template class Recorder<2>;
template class Recorder<3>;

}  // namespace berm::simulation
