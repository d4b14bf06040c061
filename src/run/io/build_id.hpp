// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace berm::io {

/// The GNU build id of what was linked, in hexadecimal digits: the same for the same bytes, wherever they lie; "" where there is none.
/// Of the executable or the library that is loaded at this address of the process, also where its file was replaced since.
std::string build_id_at(const void* address);
/// Of an ELF file of 64 bits; "" also where it cannot be read.
std::string build_id_in(const std::filesystem::path& file);

}  // namespace berm::io
