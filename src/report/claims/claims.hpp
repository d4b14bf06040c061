// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/run_record.hpp"

namespace berm::report {

/// The claims of the paper, each with what the runs found, as HTML; "" where the runs are not of its test.
std::string claims_section(const std::vector<pipe::RunRecord>& runs);

}  // namespace berm::report
