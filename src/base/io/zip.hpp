// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace berm::io {

/// A file in a zip archive.
struct ZipEntry {
  std::string name;  ///< with / between folders
  std::string_view content;
};

/// A zip archive with files as they are, not compressed, and without their times: the same files give the same bytes. Each is shorter than 4 GB.
std::string zip_of(const std::vector<ZipEntry>& entries);

}  // namespace berm::io
