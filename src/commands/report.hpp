// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/page/report.hpp"

namespace berm::commands {

/// Writes the page and its figures, and prints the names of what was written.
void print_report(const report::ReportRequest& request);

}  // namespace berm::commands
