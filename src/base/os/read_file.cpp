// SPDX-License-Identifier: BSD-3-Clause
#include "os/read_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <new>
#include <stdexcept>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace berm {
namespace {

std::string kind_of(mode_t mode)
{
  if (S_ISDIR(mode)) return "is a folder";
  return S_ISFIFO(mode) ? "is a FIFO, not a file" : S_ISSOCK(mode) ? "is a socket, not a file" : "is a device, not a file";
}

std::string with_reason(const char* what)
{
  return fmt::format("{}: {}", what, std::generic_category().message(errno));
}

/// Reads to the end, which a file of the kernel's has beyond the size that it is said to have; false where there are more than `most` bytes, or with errno.
bool read_all(int file, std::uintmax_t most, std::string& bytes)
{
  std::size_t count = 0;
  while (count <= most) {
    if (count == bytes.size()) bytes.resize(std::max<std::size_t>(2 * count, 1 << 12));
    const ssize_t got = ::read(file, bytes.data() + count, bytes.size() - count);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return false;
    if (got == 0) return bytes.resize(count), true;
    count += static_cast<std::size_t>(got);
  }
  errno = EFBIG;
  return false;
}

}  // namespace

int open_to_read(const std::filesystem::path& path, std::string& fault)
{
  // Without O_NONBLOCK a FIFO would be waited for before it is known as one; on regular files it has no effect.
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  struct stat about {};
  if (file >= 0 && ::fstat(file, &about) == 0 && S_ISREG(about.st_mode)) return file;
  fault = file >= 0 ? kind_of(about.st_mode) : errno == ENOENT ? "there is no such file" : with_reason("cannot be opened");
  if (file >= 0) ::close(file);
  return -1;
}

FileBytes read_file(const std::filesystem::path& path, std::uintmax_t most)
{
  FileBytes found;
  const int file = open_to_read(path, found.fault);
  if (file < 0) return found;
  struct stat about {};
  ::fstat(file, &about);
  const auto size = static_cast<std::uintmax_t>(about.st_size);
  try {
    if (size <= most) found.bytes.resize(size + 1);
    if (size > most || !read_all(file, most, found.bytes))
      found.fault =
          size > most || errno == EFBIG ? fmt::format("is longer than {} bytes, the maximum", most) : with_reason("cannot be read");
  } catch (const std::bad_alloc&) {
    found.fault = fmt::format("has {} bytes, more than there is memory for", size);
  } catch (const std::length_error&) {
    found.fault = fmt::format("has {} bytes, more than there is memory for", size);
  }
  ::close(file);
  if (!found.fault.empty()) found.bytes.clear();
  return found;
}

}  // namespace berm
