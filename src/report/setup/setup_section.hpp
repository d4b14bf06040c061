// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/run_record.hpp"

namespace berm::report {

/// The case, as HTML: for each run of the page a drawing to scale and all parameters.
std::string setup_section(const std::vector<pipe::RunRecord>& runs);

}  // namespace berm::report
