// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace berm::report {

/// The script and the style of the report's page, and the licences of the packages whose code they hold, made from web/ by the build.
extern const std::string_view page_script, page_style, page_licences;

}  // namespace berm::report
