// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace berm::report {

/// The script and the style of the report's page, made from web/ by the build.
extern const std::string_view page_script, page_style;

}  // namespace berm::report
