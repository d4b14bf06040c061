// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "macro_element_fit/fit.hpp"

namespace berm::macro_element_fit {

/// A path with what the macro-element makes of it.
struct Comparison {
  Path path;
  bool fitted;  ///< else it is one that the parameters have not seen
  Response response;
  Misfit misfit;
};

/// Follows a path.
Comparison compare(const Parameters& parameters, Path path, bool fitted);

/// macro_element.json: the parameters with their units, the runs and how far the macro-element is from each. SI units.
std::string json_of(const Parameters& parameters, const std::vector<Comparison>& comparisons);

/// macro_element.c: the code with berm_macro_element_fitted, whose numbers read back to the same bits.
std::string code_of(const Parameters& parameters, const std::vector<Comparison>& comparisons);

/// The table of comparisons, for people.
std::string table_of(const std::vector<Comparison>& comparisons);

/// What berm macro-element leaves in a folder: macro_element.json, .h and .c, macro_element.fmi2.fmu and .fmi3.fmu, and for each run PATH.png: H over u, w over u and V over w beside what the run computed.
/// Gives their names.
std::vector<std::string> write_files(const std::filesystem::path& folder, const Parameters& parameters,
                                     const std::vector<Comparison>& comparisons);

}  // namespace berm::macro_element_fit
