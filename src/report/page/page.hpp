// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/run_record.hpp"

namespace berm::report {

/// The whole page, one file that needs no other; the runs in the order given. `left_out` says which runs are not
/// there, and why.
std::string report_page(std::vector<pipe::RunRecord> runs, const std::vector<std::string>& left_out = {});

}  // namespace berm::report
