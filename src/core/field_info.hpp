// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace berm {

/// Where a field goes besides the memory of the run; sets are joined by |.
enum Travel : unsigned {
  to_checkpoint = 1,
  to_frame = 2,
  with_particle = 4,  ///< follows it to another cell or rank
  must_be_finite = 8,
  everywhere = 15
};

/// What is said of a field once: all that stores, sends, checks or shows it is driven by this.
struct FieldInfo {
  std::string name;   ///< as files spell it: letters, digits and _
  std::string label;  ///< as people read it
  std::string unit;   ///< SI, as UDUNITS-2 spells it; "" = a bare number
  int components = 1;
  unsigned travel = everywhere;

  bool goes(Travel where) const { return (travel & where) != 0; }
};

/// The name of one component, as a checkpoint has it: "stress_xy" of a symmetric tensor in `dim` dimensions, "velocity_x" of a vector, the field's own
/// of a bare number.
std::string component_name(const FieldInfo& field, int component, int dim);

}  // namespace berm
