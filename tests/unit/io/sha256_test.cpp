// SPDX-License-Identifier: BSD-3-Clause
#include "io/sha256.hpp"

#include "core/error.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::io {
namespace {

/// Of the examples of FIPS 180-2, appendix B.
TEST(sha256, gives_the_published_digests)
{
  const TemporaryFolder place;
  EXPECT_EQ(sha256_of_file(place.write("abc", "abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of_file(place.write("empty", "")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of_file(place.write("million", std::string(1'000'000, 'a'))),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(sha256, of_what_cannot_be_read_is_an_error)
{
  const TemporaryFolder place;
  EXPECT_THROW(sha256_of_file(place / "nothing"), RunError);
  EXPECT_THROW(sha256_of_file(place.path()), RunError) << "a folder";
}

TEST(program_files, hold_the_program_and_the_libraries_that_are_asked_for)
{
  const std::vector<std::filesystem::path> files = program_files("libstdc++");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].filename(), "test_io");
  EXPECT_TRUE(files[1].filename().string().starts_with("libstdc++"));
  EXPECT_EQ(program_files("libnothing").size(), 1u);
}

}  // namespace
}  // namespace berm::io
