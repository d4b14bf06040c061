// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
#pragma once

#include "core/types.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace berm::site {

/// A cone penetration test (CPT): what the cone met over the depth below the seabed, in SI units.
struct Sounding {
  std::string file;
  std::vector<Real> depth;  ///< ascending
  std::vector<Real> q_t;    ///< cone resistance, corrected for the pore pressure behind the cone where that is possible, else as measured
  std::vector<Real> f_s, u_2;  ///< sleeve friction, pore pressure behind the cone; empty where the file has none
  std::string corrected;       ///< how q_t came about, in words
  Index left_out = 0;          ///< rows without a value
};

/// Reads a sounding from a file of AGS 4 (.ags), GEF (.gef) or a table (.csv). `location` names one of an AGS file with several, else "".
///
/// q_t is read where it is given; else it is q_c + (1 - a) u_2 where the file has u_2 and the area ratio a of the cone; else q_c. Rows that lack a value are left out.
/// Throws InputError with file, line, column and unit where the file is wrong.
Sounding read_sounding(const std::filesystem::path& file, const std::string& location);

/// Mean of f_s over q_t - sigma_v0, with the total stress under a unit weight of the soil in water; 0 without f_s.
Real friction_ratio(const Sounding& sounding, Real submerged_unit_weight);

}  // namespace berm::site
