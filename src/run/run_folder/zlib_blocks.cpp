// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/zlib_blocks.hpp"

#include "core/for_each_task.hpp"

#include <algorithm>
#include <cstring>
#include <libdeflate.h>
#include <memory>
#include <new>
#include <vector>

namespace berm::run_folder {
namespace {

constexpr std::size_t block_size = 1 << 17, worth_threads = 8;  // blocks: below, waiting for threads takes as long

using Compressor = std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)>;
using Decompressor = std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>;

template <class Kept>
Kept checked(Kept made)
{
  if (!made) throw std::bad_alloc();
  return made;
}

std::string packed_block(std::string_view block)
{
  constexpr int fastest = 1;
  thread_local const Compressor compressor = checked(Compressor(libdeflate_alloc_compressor(fastest), &libdeflate_free_compressor));
  std::string packed(libdeflate_zlib_compress_bound(compressor.get(), block.size()), '\0');
  packed.resize(libdeflate_zlib_compress(compressor.get(), block.data(), block.size(), packed.data(), packed.size()));
  packed.shrink_to_fit();
  return packed;
}

}  // namespace

std::string zlib_blocks(std::string_view bytes)
{
  const std::size_t blocks = (bytes.size() + block_size - 1) / block_size;
  std::vector<std::string> packed(blocks);
  const auto pack = [&](Index k) {
    packed[static_cast<std::size_t>(k)] = packed_block(bytes.substr(static_cast<std::size_t>(k) * block_size, block_size));
  };
  if (blocks < worth_threads)
    for (Index k = 0; k < static_cast<Index>(blocks); ++k) pack(k);
  else
    for_each_task("compress frames", static_cast<Index>(blocks), pack);
  std::vector<std::uint64_t> header{blocks, block_size, bytes.size() % block_size};
  for (const std::string& block : packed) header.push_back(block.size());
  std::string all(reinterpret_cast<const char*>(header.data()), header.size() * sizeof(std::uint64_t));
  std::size_t size = all.size();
  for (const std::string& block : packed) size += block.size();
  all.reserve(size);
  for (const std::string& block : packed) all += block;
  return all;
}

ZlibHeader::ZlibHeader(const char* first) noexcept
{
  std::memcpy(&blocks, first, sizeof blocks);
  std::memcpy(&block_bytes, first + sizeof blocks, sizeof blocks);
  std::memcpy(&last_bytes, first + 2 * sizeof blocks, sizeof blocks);
}

std::uint64_t ZlibHeader::size(std::uint64_t room) const
{
  if (room < first_bytes || blocks > (room - first_bytes) / sizeof(std::uint64_t)) return 0;
  return first_bytes + blocks * sizeof(std::uint64_t);
}

std::uint64_t ZlibHeader::unpacked(std::uint64_t room) const
{
  if (blocks == 0) return 0;
  const std::uint64_t most = max_zlib_ratio * room, last = bytes_of(blocks - 1);
  if (last > most || (blocks > 1 && (last > block_bytes || block_bytes > most / (blocks - 1)))) return 0;
  return (blocks - 1) * block_bytes + last;
}

bool unpack_zlib(std::string_view packed, void* to, std::size_t count)
{
  thread_local const Decompressor decompressor = checked(Decompressor(libdeflate_alloc_decompressor(), &libdeflate_free_decompressor));
  return libdeflate_zlib_decompress(decompressor.get(), packed.data(), packed.size(), to, count, nullptr) == LIBDEFLATE_SUCCESS;
}

}  // namespace berm::run_folder
