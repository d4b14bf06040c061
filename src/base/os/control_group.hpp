// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/numbers.hpp"

#include <filesystem>

namespace berm {

/// What the kernel says in a file of its own, such as one below /proc; "" where it says nothing.
std::string kernel_words(const std::filesystem::path& path);

/// The number in the first line of such a file that begins with `key`; infinity where there is none, or "max".
Real kernel_number(const std::filesystem::path& path, const std::string& key = "");

/// The control groups of this process, as containers and schedulers set them up: versions 1 and 2, with all groups above its own.
class ControlGroups {
public:
  /// `root`: where the system shows them; `list`: the kernel's list of those that the process is in.
  explicit ControlGroups(std::filesystem::path root = "/sys/fs/cgroup", const std::filesystem::path& list = "/proc/self/cgroup");

  /// The time of processors that they give, as a number of processors; infinity where there is no limit.
  Real processors() const;
  /// The memory in bytes that they leave; infinity where there is no limit. Pages of files that were read or written are given back when needed.
  Real memory_left() const;

private:
  /// The smallest value of a controller's group and those above it.
  template <class Of>
  Real least(const std::filesystem::path& hierarchy, const std::string& group, const Of& of) const;
  std::filesystem::path unified() const;

  std::filesystem::path root_;
  std::string group_, cpu_group_, memory_group_;  ///< of version 2; of version 1 by controller
};

}  // namespace berm
