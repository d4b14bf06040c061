// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::report {

/// The case, as HTML: for each run of the page a drawing to scale and all parameters.
std::string setup_section(const std::vector<record::RunRecord>& runs);

}  // namespace berm::report
