// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm {

/// Each adds its kernels to the list that Google Benchmark runs. A kernel says so (SkipWithError) where its input does not take the way that its name says.

/// Eight particles of Mohr-Coulomb soil, in the plane and in space: elastic, or returned to a face, an edge or the apex.
void add_stress_kernels();
/// Principal axes of as many tensors as a register holds numbers, and sums over the lanes of as many vectors.
void add_lane_kernels();
/// Cells of points that have just left theirs.
void add_mesh_kernels();
/// Impulses of contact points that are open, stick or slide.
void add_contact_kernels();
/// What is wrong with the surface of a long pipe of many triangles.
void add_surface_kernels();
/// Stress and consistent tangent of one point of the finite elements.
void add_tangent_kernels();
/// A step of a pipeline, and its matrix.
void add_line_kernels();

}  // namespace berm
