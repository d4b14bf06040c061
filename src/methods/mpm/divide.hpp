// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::mpm {

/// Where each rank's chunks begin, and the end, such that all have about the same to do: of so many chunks with these costs. Each rank gets a chunk where there
/// are enough.
std::vector<Index> equal_shares(const std::vector<Real>& costs, int ranks);

/// Divides the cells among the ranks of the run, all of which have the whole state, and keeps the particles of this rank's cells. Nothing where it is alone.
template <int dim>
void divide(const problem::Model<dim>& model, problem::State<dim>& state);

/// Divides the cells anew, each rank of which took so many s for its own; false, and nothing, where that would gain little. No result depends on how they are
/// divided. What was made for the old division (Workspace) is to be made again.
template <int dim>
bool divide_anew(const problem::Model<dim>& model, problem::State<dim>& state, Real busy);

/// The state of all ranks, on the first of them, while this lives: then the particles are this rank's again. To be made by all ranks.
template <int dim>
class WholeState {
public:
  explicit WholeState(problem::State<dim>& state);
  ~WholeState();
  WholeState(const WholeState&) = delete;
  WholeState& operator=(const WholeState&) = delete;

private:
  problem::State<dim>& state_;
  std::vector<bodies::Particles<dim>> of_rank_;  ///< empty where nothing was changed
};

}  // namespace berm::mpm
