// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/keep.hpp"
#include "output/frame.hpp"

namespace berm {

/// Makes the frames of a run of the material point method.
template <int dim>
class FrameMaker {
public:
  /// Remembers where the particles of `start` are, and keeps the model, which must outlive it.
  FrameMaker(const Model<dim>& model, const State<dim>& start);

  /// The next frame: its increments count from the frame made before.
  Frame<dim> make(const State<dim>& state);

  /// What the increments of the next frame count from. Where the particles were at the start is not kept: a run that goes on makes its FrameMaker at the
  /// same start.
  void keep(Keep& k);

private:
  struct First {
    Vec<dim> x = Vec<dim>::Zero();
    Real strain = 0;  ///< at the frame before
  };

  const Model<dim>& model_;
  std::vector<std::vector<First>> first_;  ///< by body, then id
};

}  // namespace berm
