// SPDX-License-Identifier: BSD-3-Clause
#include "os/read_file.hpp"

#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace berm::this_file {
namespace {

std::string fault_of(const std::filesystem::path& path, std::uintmax_t most = 100)
{
  return read_file(path, most).fault;
}

TEST(ReadFile, gives_all_bytes_also_by_a_link)
{
  const TemporaryFolder place;
  const std::string bytes("a\0b\n", 4);
  std::filesystem::create_symlink(place.write("file", bytes), place / "link");
  EXPECT_EQ(read_file(place / "file", 4).bytes, bytes);
  EXPECT_EQ(read_file(place / "link", 100).bytes, bytes);
  EXPECT_EQ(read_file(place.write("empty", ""), 0).fault, "");
}

TEST(ReadFile, reads_files_of_the_kernel_that_are_said_to_be_empty)
{
  EXPECT_NE(read_file("/proc/self/status", 1'000'000).bytes.find("Pid:"), std::string::npos);
  EXPECT_EQ(fault_of("/proc/self/status", 10), "is longer than 10 bytes, the maximum");
}

TEST(ReadFile, refuses_what_is_no_regular_file_at_once)
{
  const TemporaryFolder place;
  ASSERT_EQ(::mkfifo((place / "fifo").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", place / "zero");
  EXPECT_EQ(fault_of(place / "fifo"), "is a FIFO, not a file");
  EXPECT_EQ(fault_of(place / "zero"), "is a device, not a file");
  EXPECT_EQ(fault_of(place.path()), "is a folder");
  EXPECT_EQ(fault_of(place / "nothing"), "there is no such file");
}

TEST(ReadFile, refuses_more_bytes_than_are_wanted_before_it_reads_them)
{
  const TemporaryFolder place;
  const std::filesystem::path file = place.write("hole", "");
  std::filesystem::resize_file(file, 1'000'000'000'000);
  EXPECT_EQ(fault_of(file), "is longer than 100 bytes, the maximum");
}

}  // namespace
}  // namespace berm::this_file
