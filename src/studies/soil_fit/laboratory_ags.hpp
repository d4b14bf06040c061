// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "soil_fit/fit_settings.hpp"

namespace berm::soil_fit {

/// Rows of texts below headings.
struct Sheet {
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> fields;
  std::vector<int> lines;  ///< of the file, by row
};

/// What a file of AGS 4 has of tests of a kind, in the words of measured.columns, with a column "test": of oedometers the end of each increment (group CONS), of triaxial tests the
/// start of shearing and failure (TRET), drained (CD) or undrained (CU) ones by TREG where the file has it. Throws InputError.
Sheet sheet_of_ags(const std::string& file, const std::string& text, const MeasuredKind& kind);

}  // namespace berm::soil_fit
