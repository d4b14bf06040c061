// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace berm {

/// Opens a regular file for writing, which is made where it is missing; `how`: O_WRONLY or O_RDWR, with O_APPEND, O_TRUNC. Nothing else is written to: opening a FIFO would
/// wait for who reads it, and a link may lead anywhere. Returns -1 where that is not possible, and `fault` says why: "it is a link, and berm writes through none".
int open_to_write(const std::filesystem::path& path, int how, std::string& fault);

}  // namespace berm
