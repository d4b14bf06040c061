// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::mpm {

/// Throws the RunError for a body of which a sum over its particles is not finite: it names the first particle (body, number, place, cell, time, step) of
/// which something is not a number or infinite, and what; where there is none, it says that velocities and forces are not finite.
template <int dim>
[[noreturn]] void throw_not_finite(const problem::Model<dim>& model, const problem::State<dim>& state, Index body);

/// What to do about a particle of a cell that left the mesh at x: where a rigid body is less than two heights of the cell away, it has pushed the soil out.
template <int dim>
std::string advice_for_leaving(const problem::Model<dim>& model, const problem::State<dim>& state, const Vec<dim>& x, Index cell);

/// Throws RunError where a rigid body that began above the mesh's bottom and between its sides (a circle: wholly, another body: its centre) no longer
/// does: the soil there has nowhere to go. Half-planes may lie anywhere.
template <int dim>
void refuse_rigid_outside_mesh(const problem::Model<dim>& model, const problem::State<dim>& state);

}  // namespace berm::mpm
