// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace berm::desk {

/// The script and the style of the desk's page, made from web/ by the build.
extern const std::string_view desk_script, desk_style;

}  // namespace berm::desk
