// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/run_folder/run_folder_test.cpp
#include "io/atomic_file.hpp"

#include "os/error.hpp"
#include "os/read_file.hpp"
#include "os/write_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace berm::io {
namespace {

/// The file gets the mode of the one that it takes the place of: what its user shares with nobody stays so.
bool keep_mode(int file, const std::filesystem::path& path)
{
  constexpr mode_t of_users = 0777;
  struct stat made {
  }, before{};
  if (::lstat(path.c_str(), &before) != 0 || !S_ISREG(before.st_mode)) return true;
  return ::fstat(file, &made) == 0 && (((made.st_mode ^ before.st_mode) & of_users) == 0 || ::fchmod(file, before.st_mode & of_users) == 0);
}

/// Makes a temporary file with fill(file descriptor), which returns false with errno where it fails; forces it to the disk
/// and renames it.
template <class Fill>
void make_whole(const std::filesystem::path& path, const Fill& fill)
{
  const std::filesystem::path part = part_of(path);
  const int file = open_to_write(part, O_WRONLY | O_TRUNC);
  bool fine = keep_mode(file, path) && fill(file) && ::fsync(file) == 0;
  int reason = errno;
  if (::close(file) != 0 && fine) fine = false, reason = errno;
  if (fine && ::rename(part.c_str(), path.c_str()) != 0) fine = false, reason = errno;
  if (fine) return;
  ::unlink(part.c_str());
  errno = reason;
  throw_errno(fmt::format("cannot write {}", path.string()));
}

/// Copies one file to another; false with errno where not all bytes were copied.
bool copy_all(int from, int to)
{
  std::string bytes(1 << 20, '\0');
  while (true) {
    const ssize_t count = ::read(from, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0;
    if (!write_all(to, std::string_view(bytes.data(), static_cast<std::size_t>(count)))) return false;
  }
}

}  // namespace

void throw_errno(const std::string& what)
{
  throw RunError(fmt::format("{}: {}", what, std::generic_category().message(errno)));
}

bool write_all(int file, std::string_view text)
{
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

int open_to_write(const std::filesystem::path& path, int how)
{
  std::string fault;
  const int file = berm::open_to_write(path, how, fault);
  if (file < 0) throw RunError(fmt::format("cannot write {}: {}", path.string(), fault));
  return file;
}

int open_for_one(const std::filesystem::path& path, int how)
{
  while (true) {
    const int file = open_to_write(path, how);
    if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
      const int reason = errno;
      ::close(file);
      if (reason == EWOULDBLOCK) return -1;
      errno = reason;
      throw_errno(fmt::format("cannot lock {}", path.string()));
    }
    // Whoever had it before may have removed it at the end.
    struct stat open {
    }, named{};
    if (::fstat(file, &open) == 0 && ::lstat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino && open.st_dev == named.st_dev)
      return file;
    ::close(file);
  }
}

std::string read_text_file(const std::filesystem::path& path, std::uintmax_t most)
{
  FileBytes found = read_file(path, most);
  std::error_code error;
  if (!found.fault.empty() && std::filesystem::exists(path, error)) throw RunError(fmt::format("{}: {}", path.string(), found.fault));
  return std::move(found.bytes);
}

std::filesystem::path part_of(const std::filesystem::path& path)
{
  return path.string() + ".part";
}

void write_atomically(const std::filesystem::path& path, std::string_view text)
{
  make_whole(path, [&](int file) { return write_all(file, text); });
}

void write_atomically(const std::filesystem::path& path, const std::vector<std::string_view>& parts)
{
  make_whole(path, [&](int file) {
    return std::all_of(parts.begin(), parts.end(), [&](std::string_view part) { return write_all(file, part); });
  });
}

void copy_atomically(const std::filesystem::path& from, const std::filesystem::path& to)
{
  std::string fault;
  const int source = open_to_read(from, fault);
  if (source < 0) throw RunError(fmt::format("{}: {}", from.string(), fault));
  try {
    make_whole(to, [&](int file) { return copy_all(source, file); });
  } catch (...) {
    ::close(source);
    throw;
  }
  ::close(source);
}

void finish_whole(const std::filesystem::path& path)
{
  const std::filesystem::path part = part_of(path);
  const auto refuse = [&] {
    const int reason = errno;
    ::unlink(part.c_str());
    errno = reason;
    throw_errno(fmt::format("cannot write {}", path.string()));
  };
  const int file = ::open(part.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) refuse();
  const bool synced = ::fsync(file) == 0;
  const int reason = errno;
  ::close(file);
  errno = reason;
  if (!synced || ::rename(part.c_str(), path.c_str()) != 0) refuse();
}

void sync_file(const std::filesystem::path& path)
{
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) throw_errno(fmt::format("cannot read {}", path.string()));
  const bool synced = ::fsync(file) == 0;
  const int reason = errno;
  ::close(file);
  errno = reason;
  if (!synced) throw_errno(fmt::format("cannot write {}", path.string()));
}

void make_folder(const std::filesystem::path& path)
{
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw RunError(fmt::format("cannot make the folder {}: {}", path.string(), error.message()));
}

std::filesystem::path make_inner_folder(const std::filesystem::path& folder, const std::filesystem::path& name)
{
  std::error_code error;
  const std::filesystem::path inner = folder / name;
  if (std::filesystem::is_symlink(inner, error))
    throw RunError(fmt::format("cannot write into {}: it is a link, and berm writes through none", inner.string()));
  make_folder(inner);
  return inner;
}

bool holds_page(const std::filesystem::path& folder, const std::string& page, const std::string& command)
{
  std::error_code error;
  if (std::filesystem::exists(folder / page, error)) return true;
  if (std::filesystem::is_directory(folder, error) && !std::filesystem::is_empty(folder, error))
    throw InputError(fmt::format("{} holds files that are not of {}: name another folder with -o", folder.string(), command));
  return false;
}

}  // namespace berm::io
