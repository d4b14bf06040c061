// SPDX-License-Identifier: BSD-3-Clause
#include "output/whole_file.hpp"

#include "core/error.hpp"

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <system_error>
#include <unistd.h>

namespace berm {

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

std::string read_whole(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_whole(const std::filesystem::path& path, std::string_view text)
{
  const std::string temporary = path.string() + ".part";
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) throw_errno(fmt::format("cannot write {}", path.string()));
  bool fine = write_all(file, text) && ::fsync(file) == 0;
  int reason = errno;
  if (::close(file) != 0 && fine) fine = false, reason = errno;
  if (fine && ::rename(temporary.c_str(), path.c_str()) != 0) fine = false, reason = errno;
  if (fine) return;
  ::unlink(temporary.c_str());
  errno = reason;
  throw_errno(fmt::format("cannot write {}", path.string()));
}

}  // namespace berm
