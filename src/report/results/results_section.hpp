// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/run_record.hpp"

namespace berm::report {

/// Key results of all runs of the page, as HTML, beside what design codes and published formulas give for the same soil.
std::string results_section(const std::vector<pipe::RunRecord>& runs);

}  // namespace berm::report
