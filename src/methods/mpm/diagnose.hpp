// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::mpm {

/// Throws the RunError for a body with a sum over its particles that is not finite: it names the first particle (body,
/// number, position, cell, time, step) with a field that is not finite, and that field; where there is none, velocities and
/// forces.
template <int dim>
[[noreturn]] void throw_not_finite(const problem::Model<dim>& model, const problem::State<dim>& state, Index body);

/// Advice for a particle of a cell of a body that left the mesh at x: where a rigid body is less than two heights of the cell away, it
/// has displaced the soil; where the cell is at a boundary that absorbs, soil slid through it.
template <int dim>
std::string advice_for_leaving(const problem::Model<dim>& model, const problem::State<dim>& state, Index body, const Vec<dim>& x,
                               Index cell);

/// Throws RunError where a rigid body that started above the mesh's bottom and between its sides (a circle: entirely,
/// another body: its centre) no longer is: the soil there has nowhere to go. Half-planes are exempt.
template <int dim>
void refuse_rigid_outside_mesh(const problem::Model<dim>& model, const problem::State<dim>& state);

}  // namespace berm::mpm
