// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/os/child_process_test.cpp
#include "os/write_file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace berm {

int open_to_write(const std::filesystem::path& path, int how, std::string& fault)
{
  // A FIFO that nobody reads is refused at once with O_NONBLOCK; on regular files it has no effect.
  const int file = ::open(path.c_str(), how | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0666);
  struct stat about {};
  if (file >= 0 && ::fstat(file, &about) == 0 && S_ISREG(about.st_mode)) return file;
  fault = file >= 0 || errno == ENXIO ? "it is not a regular file"
          : errno == ELOOP            ? "it is a link, and berm writes through none"
                                      : std::generic_category().message(errno);
  if (file >= 0) ::close(file);
  return -1;
}

}  // namespace berm
