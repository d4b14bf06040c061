// SPDX-License-Identifier: BSD-3-Clause
#include "io/sha256.hpp"

#include "io/atomic_file.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::io::this_file {
namespace {

constexpr int here = 0;

TEST(BuildId, of_what_is_loaded_is_that_of_its_file)
{
  const std::string id = build_id_at(&here);
  EXPECT_EQ(id.size(), 40u) << "SHA-1, as the linker makes it";
  EXPECT_EQ(build_id_in("/proc/self/exe"), id);
}

TEST(BuildId, is_the_same_of_a_copy_and_none_of_a_part_or_of_what_is_no_program)
{
  const TemporaryFolder folder;
  std::filesystem::copy_file("/proc/self/exe", folder / "copy");
  EXPECT_EQ(build_id_in(folder / "copy"), build_id_at(&here));
  const std::string bytes = read_text_file("/proc/self/exe");
  for (const std::size_t size : {0, 3, 40, 64, 100, 300}) {
    folder.write("part", bytes.substr(0, size));
    EXPECT_EQ(build_id_in(folder / "part"), "") << size;
  }
  folder.write("part", "# no program\n" + std::string(1000, 'x'));
  EXPECT_EQ(build_id_in(folder / "part"), "");
  EXPECT_EQ(build_id_in(folder / "nothing"), "");
  const int on_the_stack = 0;
  EXPECT_EQ(build_id_at(&on_the_stack), "");
}

}  // namespace
}  // namespace berm::io::this_file
