// SPDX-License-Identifier: BSD-3-Clause
#include "io/zip.hpp"

#include "io/atomic_file.hpp"
#include "io/scratch_folder.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

namespace berm::io::this_file {
namespace {

std::string text_of(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Zip, is_read_by_others_and_has_the_same_bytes_each_time)
{
  const std::string large(300'000, 'x'), odd("\0\n\xff", 3);
  const std::vector<ZipEntry> entries = {{"a folder/b.txt", "hello\n"}, {"large", large}, {"odd", odd}, {"empty", ""}};
  const std::string zip = zip_of(entries);
  EXPECT_EQ(zip_of(entries), zip);
  const ScratchFolder folder;
  write_atomically(folder.path() / "some.zip", zip);
  const std::string inside = folder.path().string();
  ASSERT_EQ(
      std::system(fmt::format("cd {0} && python3 -m zipfile --test some.zip && python3 -m zipfile --extract some.zip out", inside).c_str()),
      0);
  for (const ZipEntry& entry : entries) EXPECT_EQ(text_of(folder.path() / "out" / entry.name), entry.content) << entry.name;
}

}  // namespace
}  // namespace berm::io::this_file
