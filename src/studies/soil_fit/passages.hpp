// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "soil_fit/laboratory_table.hpp"
#include "soil_fit/measured.hpp"

namespace berm::soil_fit {

/// The columns that the file of a penetrometer needs, each as alternatives.
std::vector<std::vector<Reading>> columns_of_passages();

/// What the rows of a penetrometer hold: a test for each depth interval over which it went to and fro, with the mean resistance of each passage over the middle third of the
/// interval. Passages go from one turning point of the depth to the next. Throws InputError where rows cannot be those of such a test, or have fewer than three cycles.
std::vector<MeasuredTest> passages_of(const MeasuredFile& file, const LaboratoryTable& table, const std::string& name,
                                      const std::vector<std::size_t>& rows);

/// The resistance of each passage by the law of clay, Pa: passage k flows through clay that k - 1/2 passages have sheared,
///
///   q_k = N s_u (1 + rate part) (d + (1 - d) exp(-3 (k - 1/2) xi_T / ductility)),   d = 1/sensitivity.   [Einav and Randolph 2005; Randolph, Low and Zhou 2007]
std::vector<Real> resistances(const MeasuredTest& test, const material::Material& clay);

/// What is doubtful about the passages of a test, a sentence each, with what the law makes of them.
std::vector<std::string> doubts_of_passages(const MeasuredTest& test, const std::vector<Real>& computed);

/// Resistances by passage, over that of the first, as a table of the page.
std::string passages_html(const MeasuredTest& test, const std::vector<Real>& computed);

}  // namespace berm::soil_fit
