// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "problem/model.hpp"

namespace berm::problem {

/// Refuses what a case around an axis cannot have: motion and loads that are not the same all around, bodies that their own mirror image does not continue, and
/// what is not made for it.
void check_axisymmetry(Describe& d, const Case& c);

/// Gives the mesh of an axisymmetric case its metric. Nodes within round-off of the axis come to lie on it. Throws InputError where the mesh is beyond it.
template <int dim>
void measure_around_axis(const Case& c, mesh::Mesh<dim>& mesh);

/// Holds the nodes on the axis across it, in each set of supports.
template <int dim>
void hold_axis(Model<dim>& model);

}  // namespace berm::problem
