// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace berm::sandbox {

/// The version of Landlock that the kernel has; 0 where it has none.
int landlock_version();

/// From now on, and for good, this thread and what it starts write below `folders` and to /dev/null and the terminal only, and start `programs` only. Signals reach none but what it
/// starts, where the kernel can say so (version 6). Throws std::system_error.
void restrict_files(const std::vector<std::filesystem::path>& folders, const std::vector<std::filesystem::path>& programs);

}  // namespace berm::sandbox
