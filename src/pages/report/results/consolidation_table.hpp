// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::report {

/// How the water drained in each stage, of the runs whose water flows, as HTML with its heading; "" where none does.
std::string consolidation_table(const std::vector<record::RunRecord>& runs);

}  // namespace berm::report
