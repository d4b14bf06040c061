// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/state.hpp"

namespace berm::beam {

/// Effective force of an element, N: tension positive.
Real effective_force(const Line& line, const State& state, Index element);

/// Curvature that the line has bent to, v'' - v_0'' (1/m), at a node: mean of its elements. Positive where the displacement turns upwards along x.
Real curvature(const Line& line, const State& state, Plane plane, Index node);

/// EI (v'' - v_0''), N m, at a node: mean of its elements.
Real moment(const Line& line, const State& state, Plane plane, Index node);

/// The node that has gone sideways most from the straight axis, or from where the line lies without stress.
Index crown(const Line& line, const State& state, bool from_shape = false);

/// The largest lateral moment at a node, N m.
Real largest_moment(const Line& line, const State& state);

/// EI (v''' - v_0'''), N, of an element, the slope of its moment.
Real shear(const Line& line, const State& state, Plane plane, Index element);

/// Longitudinal strain since the line was without stress, of the membrane and of bending in both planes, in the fibre of an element that is stretched (first) or compressed (second) most; tension
/// positive, with what temperature and pressure do. Strain by the lay tension is not in it.
struct FibreStrain {
  Real largest, smallest;
};
FibreStrain longitudinal_strain(const Line& line, const State& state, Index element);

/// Largest slope of the line at a node, whichever the plane. Beyond largest_valid_slope its strain is not that of a pipe any more.
Real largest_slope(const Line& line, const State& state);

}  // namespace berm::beam
