// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace berm::report {

/// The browser that prints: what the environment variable BERM_BROWSER names, else the first of Chromium and Google Chrome in the PATH. Throws RunError with
/// what to install where there is none.
std::filesystem::path printing_browser();

/// Prints a page into a PDF as that browser does without a window. Throws RunError where it fails; an older file stays then.
void print_pdf(const std::filesystem::path& browser, const std::filesystem::path& page, const std::filesystem::path& pdf);

}  // namespace berm::report
