// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/run_sandbox_test.cpp
#include "sandbox/landlock.hpp"

#include <cerrno>
#include <cstdint>
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/landlock.h>
#include <string>
#include <sys/auxv.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <system_error>
#include <unistd.h>

namespace berm::sandbox {
namespace {

namespace fs = std::filesystem;

// Newer than the headers of Debian 12.
constexpr std::uint64_t access_truncate = 1U << 14, scope_abstract_sockets = 1U << 0, scope_signals = 1U << 1;

/// What the kernel reads of landlock_ruleset_attr since version 6; older ones take the first of it.
struct Ruleset {
  std::uint64_t files = 0, net = 0, scoped = 0;
};

constexpr std::uint64_t write_to_file = LANDLOCK_ACCESS_FS_WRITE_FILE;
constexpr std::uint64_t change_folder = LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_DIR |
                                        LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_SYM | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                                        LANDLOCK_ACCESS_FS_REFER;
constexpr std::uint64_t never = LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SOCK;

class Descriptor {
public:
  explicit Descriptor(long descriptor) : descriptor_(static_cast<int>(descriptor))
  {
    if (descriptor_ < 0) throw std::system_error(errno, std::generic_category());
  }
  ~Descriptor() { ::close(descriptor_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return descriptor_; }

private:
  int descriptor_;
};

void allow(const Descriptor& rules, const fs::path& path, std::uint64_t access)
{
  const Descriptor opened(::open(path.c_str(), O_PATH | O_CLOEXEC));
  landlock_path_beneath_attr rule{};
  rule.allowed_access = access;
  rule.parent_fd = opened.get();
  if (::syscall(SYS_landlock_add_rule, rules.get(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0)
    throw std::system_error(errno, std::generic_category(), path.string());
}

/// The loader, which starts every program; empty where the kernel loaded this one without it.
fs::path loader()
{
  Dl_info info;
  const unsigned long base = ::getauxval(AT_BASE);
  return base != 0 && ::dladdr(reinterpret_cast<void*>(base), &info) != 0 ? fs::path(info.dli_fname) : fs::path();
}

}  // namespace

int landlock_version()
{
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  return version < 0 ? 0 : static_cast<int>(version);
}

void restrict_files(const std::vector<fs::path>& folders, const std::vector<fs::path>& programs)
{
  const int version = landlock_version();
  const std::uint64_t write = write_to_file | (version >= 3 ? access_truncate : 0);
  const Ruleset attributes{write | change_folder | never | LANDLOCK_ACCESS_FS_EXECUTE, 0, scope_abstract_sockets | scope_signals};
  const std::size_t known = version >= 6 ? sizeof attributes : version >= 4 ? 2 * sizeof(std::uint64_t) : sizeof(std::uint64_t);
  const Descriptor rules(::syscall(SYS_landlock_create_ruleset, &attributes, known, 0));
  for (const fs::path& folder : folders) allow(rules, folder, write | change_folder);
  for (const char* device : {"/dev/null", "/dev/tty"})
    if (fs::exists(device)) allow(rules, device, write);
  for (const fs::path& program : programs) allow(rules, program, LANDLOCK_ACCESS_FS_EXECUTE);
  if (const fs::path file = loader(); !file.empty()) allow(rules, file, LANDLOCK_ACCESS_FS_EXECUTE);
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || ::syscall(SYS_landlock_restrict_self, rules.get(), 0) != 0)
    throw std::system_error(errno, std::generic_category());
}

}  // namespace berm::sandbox
