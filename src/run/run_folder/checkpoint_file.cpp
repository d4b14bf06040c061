// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/checkpoint_file.hpp"

#include "io/atomic_file.hpp"
#include "run_folder/hdf5_archive.hpp"

#include <charconv>
#include <fcntl.h>
#include <fmt/format.h>
#include <sstream>
#include <unistd.h>
#include <zlib.h>

namespace berm::run_folder {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t header_bytes = 512;  // the minimum for HDF5
constexpr std::string_view magic = "berm checkpoint, format ";

/// A file descriptor, closed with this object.
class OpenFile {
public:
  OpenFile(const fs::path& path, int how) : file_(::open(path.c_str(), how | O_CLOEXEC)) {}
  ~OpenFile()
  {
    if (file_ >= 0) ::close(file_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  operator int() const { return file_; }

private:
  int file_;
};

/// Of the bytes from ... to of a file; empty where some are missing.
std::optional<std::uint32_t> crc_of(int file, BigIndex from, BigIndex to)
{
  constexpr BigIndex max = 1 << 20;
  std::vector<unsigned char> buffer(static_cast<std::size_t>(std::clamp<BigIndex>(to - from, 0, max)));
  uLong crc = crc32(0, nullptr, 0);
  while (from < to) {
    const ssize_t got =
        ::pread(file, buffer.data(), static_cast<std::size_t>(std::min<BigIndex>(to - from, static_cast<BigIndex>(buffer.size()))), from);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return std::nullopt;
    crc = crc32(crc, buffer.data(), static_cast<uInt>(got));
    from += got;
  }
  return static_cast<std::uint32_t>(crc);
}

std::string header(BigIndex bytes, std::uint32_t crc, const std::string& version)
{
  std::string text =
      fmt::format("{}{}\nberm {}\n{} bytes, CRC-32 {:08x} from byte {} on\n", magic, checkpoint_format, version, bytes, crc, header_bytes);
  text.resize(header_bytes, '\n');
  return text;
}

/// Whether the first bytes are the header of a content of this length and CRC; else throws what is wrong with them.
void check_header(const std::string& found, BigIndex bytes, std::uint32_t crc)
{
  if (found == header(bytes, crc, BERM_VERSION)) return;
  if (!found.starts_with(magic)) throw RunError("it is not a checkpoint of berm");
  int format = 0;
  std::from_chars(found.data() + magic.size(), found.data() + found.size(), format);
  if (format > checkpoint_format)
    throw RunError(fmt::format("it has format {}, that of a newer berm; this one reads format {}", format, checkpoint_format));
  if (format > 0 && format < checkpoint_format)
    throw RunError(fmt::format(
        "it has format {}, that of an older berm; this one reads format {}: finish the run with that version, or start it again", format,
        checkpoint_format));
  std::istringstream lines(found);
  std::string line, berm, version;
  std::getline(lines, line);
  lines >> berm >> version;
  const bool readable = std::all_of(version.begin(), version.end(), [](char c) { return c > ' ' && c <= '~'; });
  if (readable && found == header(bytes, crc, version))
    throw RunError(fmt::format(
        "it was written by berm {}, and this is berm " BERM_VERSION ": a run is resumed by the version that started it", version));
  throw RunError("it is damaged");
}

void check(const fs::path& path)
{
  const OpenFile file(path, O_RDONLY);
  if (file < 0) io::throw_errno("it cannot be read");
  const BigIndex size = ::lseek(file, 0, SEEK_END), first = std::min<BigIndex>(size, header_bytes);
  std::string found(static_cast<std::size_t>(first), '\0');
  const std::optional<std::uint32_t> crc = crc_of(file, first, size);
  if (::pread(file, found.data(), found.size(), 0) != first || !crc) io::throw_errno("it cannot be read");
  check_header(found, size, *crc);
}

void force_to_disk(const fs::path& folder)
{
  const OpenFile file(folder, O_RDONLY | O_DIRECTORY);
  if (file < 0 || ::fsync(file) != 0) io::throw_errno(fmt::format("cannot write to {}", folder.string()));
}

template <class Act>
void removed_where_it_fails(const fs::path& part, const Act& act)
{
  try {
    act();
  } catch (const RunError&) {
    // Emptied first: HDF5 may keep it open, and with it its space on a disk that may be full.
    if (const int file = ::open(part.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC); file >= 0) ::close(file);
    ::unlink(part.c_str());
    throw;
  }
}

}  // namespace

void write_checkpoint(const fs::path& path, const Contents& contents)
{
  begin_checkpoint(path, contents);
  finish_checkpoint(path);
}

void begin_checkpoint(const fs::path& path, const Contents& contents)
{
  const fs::path part = io::part_of(path);
  ::unlink(part.c_str());  // HDF5 would write through a link
  removed_where_it_fails(part, [&] {
    Hdf5Writer writer(part, header_bytes);
    contents(writer);
    writer.close();
  });
}

void finish_checkpoint(const fs::path& path)
{
  const fs::path part = io::part_of(path);
  removed_where_it_fails(part, [&] {
    const OpenFile file(part, O_RDWR);
    const BigIndex size = file < 0 ? -1 : ::lseek(file, 0, SEEK_END);
    const std::optional<std::uint32_t> crc = size < 0 ? std::nullopt : crc_of(file, header_bytes, size);
    if (!crc || ::lseek(file, 0, SEEK_SET) != 0 || !io::write_all(file, header(size, *crc, BERM_VERSION)) || ::fsync(file) != 0 ||
        ::rename(part.c_str(), path.c_str()) != 0)
      io::throw_errno(fmt::format("cannot write {}", path.string()));
    force_to_disk(path.parent_path());
  });
}

void read_checkpoint(const fs::path& path, const Contents& contents)
{
  check(path);
  Hdf5Reader reader(path);
  contents(reader);
}

std::uint32_t crc_of(const void* first, std::size_t bytes)
{
  return static_cast<std::uint32_t>(crc32_z(crc32(0, nullptr, 0), static_cast<const unsigned char*>(first), bytes));
}

std::optional<std::uint32_t> crc_of(const fs::path& path, BigIndex bytes)
{
  const OpenFile file(path, O_RDONLY);
  return file < 0 ? std::nullopt : crc_of(file, 0, bytes);
}

}  // namespace berm::run_folder
