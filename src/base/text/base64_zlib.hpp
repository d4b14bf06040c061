// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace berm::text {

/// Bytes as base64 (RFC 4648).
std::string base64(std::string_view bytes);

/// Bytes as base64 of a zlib stream (RFC 1950), as a block of the page holds them.
std::string packed(std::string_view bytes);

}  // namespace berm::text
