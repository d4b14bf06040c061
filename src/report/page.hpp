// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/run_record.hpp"

namespace berm {

/// The whole page, one file that needs no other; the runs in the order given.
std::string report_page(std::vector<RunRecord> runs);

}  // namespace berm
