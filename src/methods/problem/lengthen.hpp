// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::problem {

/// Where a particle of a lengthened bed comes from.
template <int dim>
struct Parent {
  std::int32_t id = none;              ///< of the particle that it is, or a part of; none: laid with the added length
  Vec<dim> offset = Vec<dim>::Zero();  ///< m, from there
};

template <int dim>
struct LengthenedBed {
  State<dim> state;
  std::vector<std::vector<Parent<dim>>> parents;  ///< by body, then number of the particle
};

/// What of this model cannot be carried to another mesh, with its key: water that flows, boundaries that absorb, tractions, fills, excavations, watched points; "" where all can.
template <int dim>
std::string not_to_lengthen(const Model<dim>& model);

/// A state on the longer mesh of the same seabed. Particles stay where they are; one beyond the fine zone before that is larger than those of its new cell is divided among the places that
/// particles of `fresh`, the start on the longer mesh, have around it: mass, momentum, kinetic energy, volume and volume times stress are kept, and the parts have new numbers. Beyond the ends of the mesh before lies the soil of
/// `fresh`. The stable time step is to be found anew.
template <int dim>
LengthenedBed<dim> lengthen(const settings::Case& c, const Model<dim>& before, const State<dim>& state, const Model<dim>& model,
                            const State<dim>& fresh);

}  // namespace berm::problem
