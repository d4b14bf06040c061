// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"
#include "problem/model.hpp"
#include "run_folder/summary.hpp"

namespace berm::simulation {

/// Watches the size of the cells at the main rigid body while stages drive it: an answer of fine cells is not continued on coarse ones without a word.
template <int dim>
class CellWatch {
public:
  /// Where a row of the history is written.
  void observe(const problem::Model<dim>& model, const problem::State<dim>& state);

  /// The sizes at its start, now and at most, m, and the part of its travel on cells that are much larger than those at the start; nothing where no body was driven.
  run_folder::Summary::Checks checks() const;
  /// Says where cells grew; `body` is its name.
  void warn(const std::string& body, Real width) const;

  void archive(Archive& k);

private:
  Real first_ = nan, last_ = nan, largest_ = nan;  ///< m
  Real travel_ = 0, coarse_travel_ = 0;            ///< m
  Vec<dim> place_ = Vec<dim>::Zero();
  Index near_ = 0;
};

}  // namespace berm::simulation
