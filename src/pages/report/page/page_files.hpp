// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace berm::report {

/// The script and the style of the report's page, the script's hash as a Content-Security-Policy names it, and the licences of the packages whose code they hold, made from web/ by the build.
extern const std::string_view page_script, page_script_source, page_style, page_licences;

}  // namespace berm::report
