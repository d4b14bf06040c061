// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

/// One input of a target. What it throws, and any finding of a sanitizer, is a bug of berm's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace berm {

inline std::string text_of(const std::uint8_t* data, std::size_t size)
{
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the program where a promise does not hold.
inline void promise(bool holds, const char* what, const std::string& shown)
{
  if (holds) return;
  fmt::print(stderr, "broken promise: {}: {}\n", what, shown);
  std::abort();
}

/// A message to the user is one line that says something.
inline void promise_one_line(const std::string& message)
{
  bool plain = !message.empty();
  for (const char c : message) plain = plain && static_cast<unsigned char>(c) >= 0x20 && c != 0x7F;
  promise(plain, "a message is one line", message);
}

/// A file in memory: readers open it by its path.
class MemoryFile {
public:
  MemoryFile() : file_(::memfd_create("input", MFD_CLOEXEC)), path_(fmt::format("/proc/self/fd/{}", file_)) {}
  ~MemoryFile() { ::close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::filesystem::path& hold(const std::uint8_t* data, std::size_t size) const
  {
    const bool written = ::ftruncate(file_, 0) == 0 && ::pwrite(file_, data, size, 0) == static_cast<ssize_t>(size);
    promise(written, "a file in memory can be written", path_.string());
    return path_;
  }

private:
  int file_;
  std::filesystem::path path_;
};

/// A folder in memory, for readers that ask for the name of a file or for more than one.
class MemoryFolder {
public:
  MemoryFolder() : path_(fmt::format("/dev/shm/berm_fuzz_{}", ::getpid())) { std::filesystem::create_directories(path_); }
  ~MemoryFolder() { std::filesystem::remove_all(path_); }
  MemoryFolder(const MemoryFolder&) = delete;
  MemoryFolder& operator=(const MemoryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path hold(const std::string& name, const std::string& text) const
  {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

private:
  std::filesystem::path path_;
};

/// What begins with an input's first byte, which says what the rest is: `first` where there is none.
struct KindAndText {
  char kind;
  std::string text;
};
inline KindAndText kind_and_text(const std::uint8_t* data, std::size_t size, char first)
{
  return size == 0 ? KindAndText{first, ""} : KindAndText{static_cast<char>(data[0]), text_of(data + 1, size - 1)};
}

/// Does what may refuse a damaged input, by InputError or RunError, in one line.
template <class Work>
void may_be_refused(const Work& work)
{
  try {
    work();
  } catch (const InputError& error) {
    promise_one_line(error.what());
  } catch (const RunError& error) {
    promise_one_line(error.what());
  }
}

}  // namespace berm
