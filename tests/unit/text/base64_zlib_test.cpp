// SPDX-License-Identifier: BSD-3-Clause
#include "text/base64_zlib.hpp"

#include "samples/unpacking.hpp"

#include <random>

namespace berm::text::this_file {
namespace {

TEST(packed, base64_is_that_of_the_standard)
{
  // RFC 4648, section 10.
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfe\x00\xfb", 4)), "//4A+w==");
}

TEST(packed, bytes_unpack_to_what_they_were)
{
  std::mt19937 random(1);
  for (const std::size_t size : {0, 1, 2, 3, 1000, 100'000}) {
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random() % 7);
    EXPECT_EQ(inflated(from_base64(packed(bytes))), bytes);
  }
  EXPECT_LT(packed(std::string(100'000, 'a')).size(), 1000u);
}

}  // namespace
}  // namespace berm::text::this_file
