// SPDX-License-Identifier: BSD-3-Clause
#include "io/zlib_blocks.hpp"

#include "core/for_each_task.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <new>
#include <vector>
#include <zlib.h>

namespace berm::io {
namespace {

constexpr std::size_t block_size = 1 << 17, worth_threads = 8;  // blocks: below, waiting for threads takes as long

/// False where there is no memory.
bool pack_block(std::string_view block, std::string& packed) noexcept
{
  try {
    uLongf size = compressBound(block.size());
    packed.resize(size);
    const bool done = compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(block.data()), block.size(),
                                Z_BEST_SPEED) == Z_OK;
    packed.resize(size);
    packed.shrink_to_fit();
    return done;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

}  // namespace

std::string zlib_blocks(std::string_view bytes)
{
  const std::size_t blocks = (bytes.size() + block_size - 1) / block_size;
  std::vector<std::string> packed(blocks);
  std::atomic<bool> failed = false;
  const auto pack = [&](Index k) {
    if (!pack_block(bytes.substr(static_cast<std::size_t>(k) * block_size, block_size), packed[static_cast<std::size_t>(k)])) failed = true;
  };
  if (blocks < worth_threads)
    for (Index k = 0; k < static_cast<Index>(blocks); ++k) pack(k);
  else
    for_each_task("compress frames", static_cast<Index>(blocks), pack);
  if (failed) throw std::bad_alloc();
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
  uLongf size = count;
  return uncompress(static_cast<Bytef*>(to), &size, reinterpret_cast<const Bytef*>(packed.data()), packed.size()) == Z_OK && size == count;
}

}  // namespace berm::io
