// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "report/expectations/expectations_section.hpp"
#include "report/results/results_section.hpp"

#include <nlohmann/json.hpp>

namespace berm::report {

/// The whole page, one file that needs no other; the runs in the order given, with what is claimed of their tests. `left_out` says which runs are
/// not there, and why.
std::string report_page(std::vector<record::RunRecord> runs, const ExpectationSheets& expected = {},
                        const std::vector<std::string>& left_out = {});

/// The same for a word processor: without scripts, films and navigation, with pictures of the curves by their names.
std::string word_page(const std::vector<record::RunRecord>& runs, const ExpectationSheets& expected,
                      const std::vector<std::string>& left_out, const std::vector<std::string>& pictures);

/// What is seen of a run without scrolling beside its answer in words.
FirstLook first_look(const record::RunRecord& run);

/// What the runs ask, as far as they have it in common, in plain text: the driven body, its soil and its stages, as in "Pipe of 0.5 m in clay with s_u = 5 kPa:
/// push to w = 0.2 m, drag 1.5 m". "" where they drive no body of a width or bodies of other names.
std::string question_of(const std::vector<record::RunRecord>& runs);

/// RunData of web/src/data.ts, with "film": null and "of_test": false.
nlohmann::ordered_json run_data(const record::RunRecord& run);

}  // namespace berm::report
