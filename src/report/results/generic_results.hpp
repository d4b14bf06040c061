// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/run_record.hpp"

namespace berm::report {

/// What a run without a pipe tells, as HTML: the quantities of its summary and the last values of what it watches; where there is neither, its checks.
/// `id` begins the names of the tables.
std::string other_results(const pipe::RunRecord& run, const std::string& id);

}  // namespace berm::report
