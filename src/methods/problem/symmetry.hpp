// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "problem/model.hpp"

namespace berm::problem {

/// Says in the model which axes are mirrored, and holds the nodes on the planes of symmetry across them, in each set of supports.
template <int dim>
void hold_symmetry_planes(const settings::Case& c, Model<dim>& model);

/// Throws KeyError where a rigid body is not its own mirror image: its centre must lie on the planes, it must not lean, and a half-space must go along them.
template <int dim>
void refuse_off_symmetry_planes(const Model<dim>& model);

/// Gives the mesh of an axisymmetric case its metric. Nodes within round-off of the axis come to lie on it. Throws InputError where the mesh is beyond it.
template <int dim>
void measure_around_axis(const settings::Case& c, mesh::Mesh<dim>& mesh);

/// Holds the nodes on the axis across it, in each set of supports.
template <int dim>
void hold_axis(Model<dim>& model);

}  // namespace berm::problem
