// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "expectations/expectation.hpp"

namespace berm::report {

/// The expected.toml of one example or of several.
using ExpectationSheets = std::vector<expectations::Expectations>;

/// What is published of the tests that there are runs of, for the charts.
base::PublishedPoints published_points(const std::vector<record::RunRecord>& runs, const ExpectationSheets& sheets);

/// Whether a run is of a test of which something is published.
bool is_of_a_test(const record::RunRecord& run, const ExpectationSheets& sheets);

/// What is expected of the runs and whether they give it, as HTML; "" where nothing is.
std::string expectations_section(const std::vector<record::RunRecord>& runs, const ExpectationSheets& sheets);

/// The claims of each test that there are runs of, with what these found, as HTML; the section of the first is #claims. "" where there are none.
std::string claims_section(const std::vector<record::RunRecord>& runs, const ExpectationSheets& sheets);

}  // namespace berm::report
