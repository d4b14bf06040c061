// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/claims/claim_sheet.hpp"

namespace berm::report {

/// The claims of one test or of several.
using ClaimSheets = std::vector<ClaimSheet>;

/// Whether claims can be made of a run, and it has the parameters of the test.
bool is_of_test(const record::RunRecord& run, const ClaimSheet& sheet);
bool is_of_a_test(const record::RunRecord& run, const ClaimSheets& sheets);

/// What is published of the tests that there are runs of.
base::PublishedPoints published_points(const std::vector<record::RunRecord>& runs, const ClaimSheets& sheets);

/// The claims of each test that there are runs of, with what these found, as HTML; the section of the first is #claims. "" where there are none.
std::string claims_section(const std::vector<record::RunRecord>& runs, const ClaimSheets& sheets);

}  // namespace berm::report
