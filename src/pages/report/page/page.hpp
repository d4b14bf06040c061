// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "report/expectations/expectations_section.hpp"

#include <nlohmann/json.hpp>

namespace berm::report {

/// The whole page, one file that needs no other; the runs in the order given, with what is claimed of their tests. `left_out` says which runs are
/// not there, and why.
std::string report_page(std::vector<record::RunRecord> runs, const ExpectationSheets& expected = {},
                        const std::vector<std::string>& left_out = {});

/// What is seen of a run without scrolling, as HTML: its stages in one line, the place of its curves (which the page's script draws), and its last picture of the
/// soil, as far as the run folder has one.
std::string first_look(const record::RunRecord& run);

/// RunData of web/src/data.ts, with "film": null and "of_test": false.
nlohmann::ordered_json run_data(const record::RunRecord& run);

}  // namespace berm::report
