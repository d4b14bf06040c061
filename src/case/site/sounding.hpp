// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/site/sounding_test.cpp
#pragma once

#include "core/types.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace berm::site {

/// Weight of the water in the pores from the seabed on, N/m3, and the pressure of the atmosphere by which resistances are normalized, Pa.
constexpr Real gamma_w = 9810, p_a = 100e3;

/// Rows of a file that do not count, and why.
struct LeftOut {
  std::string why;
  Index rows = 0;
};

/// A cone penetration test (CPT): what the cone met over the depth below the seabed, in SI units.
struct Sounding {
  std::string file;
  std::vector<Real> depth;  ///< ascending
  std::vector<Real> q_t;    ///< cone resistance, corrected for the pore pressure behind the cone where that is possible, else as measured
  std::vector<Real> f_s;    ///< sleeve friction, NaN where a row has none; empty where the file has none
  std::vector<Real> u_2;    ///< pore pressure behind the cone, from the seabed on where it corrects q_t, else as in the file; as f_s
  std::string corrected;    ///< how q_t came about, in words
  Index rows = 0;           ///< of the file
  std::vector<LeftOut> left_out;   ///< of these
  std::vector<std::string> notes;  ///< what was done without, or taken off, and where: each a warning
};

/// Reads a sounding from a file of AGS 4 (.ags), GEF (.gef) or a table (.csv). `location` names one of an AGS file with several, else "".
///
/// A row counts that has a depth and a cone resistance: q_t where it is given; else q_c + (1 - a) u_2 where the row has u_2 and the file the area ratio a of the cone; else q_c.
/// Throws InputError with file, line, column and unit where the file is wrong, and where its values are none of soil.
Sounding read_sounding(const std::filesystem::path& file, const std::string& location);

/// The rows that count and those that do not, in one line: "a.gef: 28 of 30 rows, 0.10 to 3.00 m; left out: 2 without a cone resistance".
std::string rows_of(const Sounding& sounding);

/// Mean of f_s over q_t - sigma_v0, with the total stress under a unit weight of the soil in water; 0 without f_s.
Real friction_ratio(const Sounding& sounding, Real submerged_unit_weight);

}  // namespace berm::site
