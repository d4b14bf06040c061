// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::report {

/// Key results of all runs of the page, as HTML, beside what design codes and published formulas give for the same soil. What the first run met stands first, then
/// `first_look`, HTML, and the other runs below it.
std::string results_section(const std::vector<record::RunRecord>& runs, const std::string& first_look = "");

}  // namespace berm::report
