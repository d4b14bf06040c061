// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/cell_watch_test.cpp
#include "simulation/cell_watch.hpp"

#include "io/log.hpp"
#include "problem/cells_at_body.hpp"

namespace berm::simulation {
namespace {

constexpr Real much_travel = 0.01;

}  // namespace

template <int dim>
void CellWatch<dim>::observe(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  const Index main = model.main_rigid;
  if (main == none || model.driven[state.stage.index] != main) return;
  const bodies::RigidState<dim>& now = state.rigid_bodies[main];
  const Real size = problem::cell_size_at<dim>(model, placed<dim>(model.rigid_bodies[main], now), near_);
  if (std::isnan(size)) return;
  const Real moved_by = (now.displacement - place_).norm();
  place_ = now.displacement;
  travel_ += moved_by;
  if (std::isnan(first_)) first_ = largest_ = size;
  if (size > problem::coarser_cells * first_) coarse_travel_ += moved_by;
  last_ = size;
  largest_ = std::max(largest_, size);
}

template <int dim>
run_folder::Summary::Checks CellWatch<dim>::checks() const
{
  if (std::isnan(first_)) return {};
  return {{"cells_at_body_first_m", first_},
          {"cells_at_body_last_m", last_},
          {"cells_at_body_largest_m", largest_},
          {"travel_on_coarse_cells", travel_ > 0 ? coarse_travel_ / travel_ : 0}};
}

template <int dim>
void CellWatch<dim>::warn(const std::string& body, Real width) const
{
  if (!(travel_ > 0) || coarse_travel_ / travel_ <= much_travel) return;
  io::warn("\"{}\" left the fine cells: cells at it were D/{:.0f} at the start, and D/{:.0f} at most, for {:.0f} % of its travel; "
           "resistance increases with the size of the cells: refine the mesh along its path",
           body, width / first_, width / largest_, 100 * coarse_travel_ / travel_);
}

template <int dim>
void CellWatch<dim>::archive(Archive& k)
{
  k("first", first_);
  k("last", last_);
  k("largest", largest_);
  k("travel", travel_);
  k("coarse_travel", coarse_travel_);
  k("place", place_);
}

template class CellWatch<2>;
template class CellWatch<3>;

}  // namespace berm::simulation
