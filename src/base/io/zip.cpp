// SPDX-License-Identifier: BSD-3-Clause
#include "io/zip.hpp"

#include <cstdint>
#include <zlib.h>

namespace berm::io {
namespace {

/// Numbers in the order of bytes of the format, the smallest first.
void put(std::string& bytes, int size, std::uint64_t value)
{
  for (int k = 0; k < size; ++k) bytes += static_cast<char>(value >> 8 * k & 0xff);
}

/// What the header before a file and the one in the directory share: version 2.0, names in UTF-8, stored, the first day of 1980.
void put_entry(std::string& bytes, const ZipEntry& entry)
{
  const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(entry.content.data()), entry.content.size());
  put(bytes, 2, 20), put(bytes, 2, 1u << 11), put(bytes, 2, 0), put(bytes, 2, 0), put(bytes, 2, 1u << 5 | 1);
  put(bytes, 4, sum), put(bytes, 4, entry.content.size()), put(bytes, 4, entry.content.size());
  put(bytes, 2, entry.name.size()), put(bytes, 2, 0);
}

}  // namespace

std::string zip_of(const std::vector<ZipEntry>& entries)
{
  std::string bytes, directory;
  for (const ZipEntry& entry : entries) {
    put(directory, 4, 0x02014b50), put(directory, 2, 20);
    put_entry(directory, entry);
    put(directory, 2, 0), put(directory, 2, 0), put(directory, 2, 0), put(directory, 4, 0), put(directory, 4, bytes.size());
    directory += entry.name;
    put(bytes, 4, 0x04034b50);
    put_entry(bytes, entry);
    bytes += entry.name;
    bytes += entry.content;
  }
  const std::size_t at = bytes.size();
  bytes += directory;
  put(bytes, 4, 0x06054b50), put(bytes, 4, 0), put(bytes, 2, entries.size()), put(bytes, 2, entries.size());
  put(bytes, 4, directory.size()), put(bytes, 4, at), put(bytes, 2, 0);
  return bytes;
}

}  // namespace berm::io
