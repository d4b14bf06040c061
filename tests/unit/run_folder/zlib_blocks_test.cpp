// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/zlib_blocks.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::run_folder::this_file {
namespace {

constexpr std::size_t block = 1 << 17;

/// Bytes that zlib can halve at most.
std::string noise(std::size_t size)
{
  std::mt19937 random(7);
  std::string bytes(size, '\0');
  for (char& c : bytes) c = static_cast<char>(random() % 16);
  return bytes;
}

/// By the header alone, as VTK does it.
std::string unpacked(const std::string& packed)
{
  const ZlibHeader header(packed.data());
  std::string bytes(header.unpacked(packed.size()), '\0');
  std::size_t from = header.size(packed.size());
  for (std::uint64_t k = 0; k < header.blocks; ++k) {
    std::uint64_t size = 0;
    std::copy_n(packed.data() + ZlibHeader::first_bytes + 8 * k, 8, reinterpret_cast<char*>(&size));
    EXPECT_TRUE(unpack_zlib(std::string_view(packed).substr(from, size), bytes.data() + k * header.block_bytes, header.bytes_of(k)));
    from += size;
  }
  EXPECT_EQ(from, packed.size());
  return bytes;
}

TEST(ZlibBlocks, bytes_come_back_whatever_their_number)
{
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, block - 1, block, block + 1, 3 * block, 9 * block + 5}) {
    const std::string bytes = noise(size), packed = zlib_blocks(bytes);
    EXPECT_TRUE(unpacked(packed) == bytes) << size;
    const ZlibHeader header(packed.data());
    EXPECT_EQ(header.blocks, (size + block - 1) / block);
    EXPECT_EQ(header.block_bytes, block);
    EXPECT_EQ(header.last_bytes, size % block);
    if (size > 1000) {
      EXPECT_LT(packed.size(), 0.7 * static_cast<double>(size));
    }
  }
}

TEST(ZlibBlocks, equal_numbers_take_no_room)
{
  EXPECT_LT(zlib_blocks(std::string(100 * block, '\0')).size(), block);
}

TEST(ZlibBlocks, numbers_that_no_file_of_this_size_can_have_are_none)
{
  const std::string packed = zlib_blocks(noise(3 * block));
  const auto with = [&](std::uint64_t ZlibHeader::*number, std::uint64_t value) {
    ZlibHeader header(packed.data());
    header.*number = value;
    return header;
  };
  constexpr std::uint64_t huge = ~std::uint64_t{0};
  EXPECT_EQ(with(&ZlibHeader::blocks, huge).size(packed.size()), 0u);
  EXPECT_EQ(with(&ZlibHeader::block_bytes, huge).unpacked(packed.size()), 0u);
  EXPECT_EQ(with(&ZlibHeader::last_bytes, huge).unpacked(packed.size()), 0u);
  EXPECT_EQ(with(&ZlibHeader::last_bytes, block + 1).unpacked(packed.size()), 0u);
}

TEST(ZlibBlocks, a_block_of_another_length_is_refused)
{
  const std::string packed = zlib_blocks("twelve bytes").substr(ZlibHeader::first_bytes + 8);
  char bytes[13];
  EXPECT_TRUE(unpack_zlib(packed, bytes, 12));
  EXPECT_FALSE(unpack_zlib(packed, bytes, 11));
  EXPECT_FALSE(unpack_zlib(packed, bytes, 13));
  EXPECT_FALSE(unpack_zlib(packed.substr(1), bytes, 12));
}

}  // namespace
}  // namespace berm::run_folder::this_file
