// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"
#include "settings/interface.hpp"

namespace berm::simulation {

/// What decides how much memory a run of the material point method takes. Counts, as far as they are known.
struct RunSize {
  struct OfBody {
    Real particles = 0;
    Real cells = 0;      ///< that hold particles: what the body keeps of others and their nodes lies in memory that is never touched
    Real blocks = 0;     ///< of four particles, that cells own
    int extra_size = 0;  ///< numbers of the fields that a particle has beside those that every one has
  };
  Real cells = 0, nodes = 0;
  std::vector<OfBody> bodies;
  std::size_t contacts = 0;
};

/// The least that a case can have before anything is made of it: mesh and particles of a box, about the mesh of a bed, nothing of a mesh in a file.
template <int dim>
RunSize min_size(const settings::Case& c);

/// The same with the mesh made.
template <int dim>
RunSize min_size(const settings::Case& c, const mesh::Mesh<dim>& mesh);

template <int dim>
RunSize size_of(const problem::Problem<dim>& problem);

/// Bytes that a run of this size takes when it takes most, which is when it makes a frame: mesh, particles, sums of the cells and nodes, and the frame
/// before with the one being made. The program itself comes on top.
template <int dim>
Real memory_of(const RunSize& size);

/// Bytes that gmsh takes beside the program while it makes the mesh of a bed in the plane. 0 of other meshes: berm makes them, or nobody knows how many cells a
/// geometry gives.
Real memory_of_gmsh(const settings::Case& c);

/// Bytes that the program has of the machine's memory now.
Real memory_in_use();

/// Bytes that it had when it had most; NaN where the system does not tell.
Real largest_memory_in_use();

/// Of the bytes in use now, what is not shared with files, such as the program itself, once what was freed has been given back.
Real memory_of_data();

/// Bytes that the program could take beside what it has: the least of what the machine, its control group and its limit of address space leave.
Real memory_left();

/// "5 cells"; of a number that nothing can have, that it is larger than such.
std::string words_of_count(Real count, const char* of);

/// Throws KeyError where `what` ("5 cells"), which needs so many bytes beside those in use, would need more than there is. advice: what the user can do.
void refuse_without_memory(Real bytes, Real in_use, const std::string& what, const std::string& advice);

/// The same for gmsh, as it makes the mesh.
void refuse_without_memory_for_gmsh(const settings::Case& c);

/// The same for a run of the material point method. in_use: what the program had before anything of the run was made.
template <int dim>
void refuse_without_memory(const RunSize& size, Real in_use);

}  // namespace berm::simulation
