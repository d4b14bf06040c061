// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace berm::report {

/// What `berm report` was asked for.
struct ReportRequest {
  std::vector<std::string> folders;  ///< run folders, or folders that hold run folders
  std::string output;                ///< file; "": report.html in the run folder, of several in the folder that holds them
  std::string expected;              ///< file of what the runs should give; "": expected.toml of each run folder
  bool pdf = false;                  ///< also printed, to a file of the page's name with the ending pdf
  bool figures = false;              ///< also SVG and PNG, in the folder report_figures beside the page
};

/// Writes the page and gives it and the figures that were written, the page first. Throws InputError where a folder is none of a run, RunError where the page cannot be written.
std::vector<std::filesystem::path> write_report(const ReportRequest& request);

}  // namespace berm::report
