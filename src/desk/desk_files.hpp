// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace berm::desk {

/// The script and the style of the desk's page, which begin with the licences of what they hold of others, and the hash of the script of reports as a Content-Security-Policy
/// names it; made from web/ by the build.
extern const std::string_view desk_script, desk_style, report_script_source;

}  // namespace berm::desk
