// SPDX-License-Identifier: BSD-3-Clause
#include "os/control_group.hpp"

#include "os/read_file.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <sstream>

namespace berm {

namespace fs = std::filesystem;

std::string kernel_words(const fs::path& path)
{
  constexpr std::uintmax_t max_bytes = 10'000'000;
  return read_file(path, max_bytes).bytes;
}

Real kernel_number(const fs::path& path, const std::string& key)
{
  std::istringstream file(kernel_words(path));
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(key)) {
      try {
        return std::stod(line.substr(key.size()));
      } catch (const std::exception&) {
        return infinity;
      }
    }
  return infinity;
}

/// Lines of the list are NUMBER:CONTROLLERS:GROUP; version 2 has the number 0 and names no controllers.
ControlGroups::ControlGroups(fs::path root, const fs::path& list) : root_(std::move(root))
{
  std::istringstream lines(kernel_words(list));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = fmt::format(",{},", line.substr(first + 1, second - first - 1)), group = line.substr(second + 1);
    if (controllers == ",,") group_ = group;
    if (controllers.find(",cpu,") != std::string::npos) cpu_group_ = group;
    if (controllers.find(",memory,") != std::string::npos) memory_group_ = group;
  }
}

/// Beside groups of version 1, those of version 2 lie in a folder of their own.
fs::path ControlGroups::unified() const
{
  std::error_code error;
  return fs::exists(root_ / "cgroup.controllers", error) ? root_ : root_ / "unified";
}

template <class Of>
Real ControlGroups::least(const fs::path& hierarchy, const std::string& group, const Of& of) const
{
  Real least = infinity;
  fs::path path = group;
  while (true) {
    const Real here = of(hierarchy.string() + path.string());
    if (here < least) least = here;
    if (path == path.parent_path()) return least;
    path = path.parent_path();
  }
}

Real ControlGroups::processors() const
{
  const Real of_version_2 = least(unified(), group_, [](const std::string& folder) {
    std::istringstream words(kernel_words(folder + "/cpu.max"));
    Real quota = 0, period = 0;
    return words >> quota >> period && period > 0 ? quota / period : infinity;
  });
  const Real of_version_1 = least(root_ / "cpu", cpu_group_, [](const std::string& folder) {
    const Real quota = kernel_number(folder + "/cpu.cfs_quota_us"), period = kernel_number(folder + "/cpu.cfs_period_us");
    return quota > 0 && quota < infinity && period > 0 ? quota / period : infinity;
  });
  return std::min(of_version_1, of_version_2);
}

Real ControlGroups::memory_left() const
{
  const auto left = [](const std::string& folder, const char* limit, const char* used, const char* of_files) {
    const Real files = kernel_number(folder + "/memory.stat", of_files);
    const Real bytes = kernel_number(folder + limit) - kernel_number(folder + used) + (files < infinity ? files : 0);
    return std::isnan(bytes) ? infinity : bytes;
  };
  return std::min(
      least(unified(), group_, [&](const std::string& folder) { return left(folder, "/memory.max", "/memory.current", "file "); }),
      least(root_ / "memory", memory_group_,
            [&](const std::string& folder) { return left(folder, "/memory.limit_in_bytes", "/memory.usage_in_bytes", "total_cache "); }));
}

}  // namespace berm
