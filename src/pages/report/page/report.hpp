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
  bool docx = false;                 ///< also as a Word document, to a file of the page's name with the ending docx
  bool figures = false;              ///< also SVG and PNG, in the folder report_figures beside the page
};

/// Writes the page and gives it and the figures that were written, the page first. Throws InputError where a folder is none of a run, RunError where the page cannot be written.
std::vector<std::filesystem::path> write_report(const ReportRequest& request);

/// The browser that prints: what the environment variable BERM_BROWSER names, else the first of Chromium and Google Chrome in the PATH. Throws RunError with
/// what to install where there is none.
std::filesystem::path printing_browser();

/// Prints a page into a PDF as that browser does without a window. Throws RunError where it fails; an older file stays then.
void print_pdf(const std::filesystem::path& browser, const std::filesystem::path& page, const std::filesystem::path& pdf);

/// pandoc of the PATH. Throws RunError with what to install where there is none.
std::filesystem::path word_writer();

/// Makes a Word document of a page whose pictures lie beside it. Throws RunError where that fails; an older file stays then.
void write_docx(const std::filesystem::path& pandoc, const std::filesystem::path& page, const std::filesystem::path& docx);

}  // namespace berm::report
