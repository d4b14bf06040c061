// SPDX-License-Identifier: BSD-3-Clause
#include "io/folder_lock.hpp"

#include "io/atomic_file.hpp"
#include "os/control_characters.hpp"
#include "os/error.hpp"

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

namespace berm::io {
namespace {

std::string this_process()
{
  char host[256] = "";
  ::gethostname(host, sizeof host - 1);
  return fmt::format("process {} on {}", ::getpid(), host);
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : path_(folder / file_name)
{
  const auto refuse = [&](const char* what) {
    const int reason = errno;
    if (file_ >= 0) ::close(file_);
    errno = reason;
    throw_errno(fmt::format("cannot use {} as the run folder: {} {}", folder.string(), what, path_.string()));
  };
  try {
    file_ = open_for_one(path_, O_RDWR);
  } catch (const RunError& error) {
    throw RunError(fmt::format("cannot use {} as the run folder: {}", folder.string(), error.what()));
  }
  if (file_ < 0) {
    const std::string owner = read_text_file(path_);
    throw RunError(
        fmt::format("cannot use {} as the run folder: another run is writing into it{}; wait for it, or name another folder with -o",
                    folder.string(), owner.empty() ? "" : fmt::format(" ({})", owner.substr(0, owner.find('\n')))));
  }
  if (::ftruncate(file_, 0) != 0 || !write_all(file_, this_process() + '\n')) {
    const int reason = errno;
    ::unlink(path_.c_str());
    errno = reason;
    refuse("cannot write");
  }
}

std::string FolderLock::owner_of(const std::filesystem::path& folder)
{
  const std::filesystem::path path = folder / file_name;
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return "";
  const bool taken = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  if (!taken) return "";
  const std::string owner = read_text_file(path);
  return owner.empty() ? "another process" : one_line(owner.substr(0, owner.find('\n')));
}

FolderLock::~FolderLock()
{
  ::unlink(path_.c_str());
  ::close(file_);
}

}  // namespace berm::io
