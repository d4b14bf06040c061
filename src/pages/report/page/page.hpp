// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/expectations/expectations_section.hpp"

namespace berm::report {

/// The whole page, one file that needs no other; the runs in the order given, with what is claimed of their tests. `left_out` says which runs are
/// not there, and why.
std::string report_page(std::vector<record::RunRecord> runs, const ExpectationSheets& expected = {},
                        const std::vector<std::string>& left_out = {});

}  // namespace berm::report
