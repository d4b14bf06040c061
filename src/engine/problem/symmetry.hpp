// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "problem/model.hpp"

namespace berm::problem {

/// Refuses planes of symmetry of what is not in space, and motion, loads and gravity that they do not mirror into themselves.
void check_symmetry(Describe& d, const Case& c);

/// Equal parts that the whole has, of which the model is one: 2 pi radians around an axis, 2 or 4 where there are planes of symmetry, else 1.
Real parts_of(const Case& c);

/// The case as the model has it: masses, forces and moments are those of one part.
Case part_of_whole(Case c);

/// Says in the model which axes are mirrored, and holds the nodes on the planes of symmetry across them, in each set of supports.
template <int dim>
void hold_symmetry_planes(const Case& c, Model<dim>& model);

/// Throws KeyError where a rigid body is not its own mirror image: its centre must lie on the planes, it must not lean, and a half-space must go along them.
template <int dim>
void refuse_off_symmetry_planes(const Model<dim>& model);

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
