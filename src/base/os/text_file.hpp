// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/read_file.hpp"

#include <string_view>

namespace berm {

/// Where the text in a file begins: behind the byte order mark of UTF-8, which editors and spreadsheets write, if it has one.
std::size_t begin_of_text(std::string_view bytes);

/// The text of a regular file that has `most` bytes at most, in UTF-8, as programs of others write it: without a byte order mark; bytes that are no UTF-8 are taken for Latin-1,
/// and where lines end with CR alone, they end with LF. Text in UTF-16 and files with a NUL byte have a fault.
FileBytes read_text(const std::filesystem::path& path, std::uintmax_t most);

}  // namespace berm
