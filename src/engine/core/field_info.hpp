// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace berm {

/// Where a field travels besides the memory of the run; combined by |.
enum Travel : unsigned {
  to_checkpoint = 1,
  to_frame = 2,
  with_particle = 4,  ///< moves with the particle to another cell or rank
  must_be_finite = 8,
  everywhere = 15
};

/// Metadata of a field, declared once; all that stores, sends, checks or displays it uses them.
struct FieldInfo {
  std::string name;   ///< identifier in files: letters, digits and _
  std::string label;  ///< for display
  std::string unit;   ///< SI, as UDUNITS-2 spells it; "" = dimensionless
  int components = 1;
  unsigned travel = everywhere;

  bool goes(Travel where) const { return (travel & where) != 0; }
};

/// Name of one component in a checkpoint: "stress_xy" of a symmetric tensor in `dim` dimensions, "velocity_x" of a vector,
/// the field's own name of a scalar.
std::string component_name(const FieldInfo& field, int component, int dim);

}  // namespace berm
