// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/run_record.hpp"

namespace berm {

/// The sections of the page that need no script, as HTML; all runs of the page go in, in the page's order.

/// What was asked: for each run a drawing to scale and all parameters.
std::string asked_section(const std::vector<RunRecord>& runs);

/// Key results, beside what design codes and published formulas give for the same soil.
std::string answer_section(const std::vector<RunRecord>& runs);

/// Energy balance, quasi-static indicators, contact, mesh; warnings in words.
std::string trust_section(const std::vector<RunRecord>& runs);

/// The claims of the paper, each with what the runs found; "" where the runs are not of its test.
std::string claims_section(const std::vector<RunRecord>& runs);

}  // namespace berm
