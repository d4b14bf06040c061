// SPDX-License-Identifier: BSD-3-Clause
#include "os/control_group.hpp"

#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

/// Control groups as files of a folder.
struct Groups {
  TemporaryFolder folder;

  void write(const std::string& name, const std::string& text) const
  {
    std::filesystem::create_directories((folder / name).parent_path());
    folder.write(name, text);
  }
  ControlGroups read() const { return ControlGroups(folder / "groups", folder / "list"); }
};

TEST(ControlGroups, without_any_there_is_no_limit)
{
  const Groups groups;
  EXPECT_EQ(groups.read().processors(), infinity);
  EXPECT_EQ(groups.read().memory_left(), infinity);
}

TEST(ControlGroups, of_version_2_limit_by_their_own_numbers_and_those_above)
{
  const Groups groups;
  groups.write("list", "0::/outer/inner\n");
  groups.write("groups/cgroup.controllers", "cpu memory\n");
  groups.write("groups/outer/cpu.max", "150000 100000\n");
  groups.write("groups/outer/inner/cpu.max", "max 100000\n");
  EXPECT_EQ(groups.read().processors(), 1.5);
  groups.write("groups/outer/inner/cpu.max", "50000 100000\n");
  EXPECT_EQ(groups.read().processors(), 0.5);
  groups.write("groups/outer/memory.max", "3000\n");
  groups.write("groups/outer/memory.current", "2500\n");
  groups.write("groups/outer/memory.stat", "anon 2400\nfile 100\n");
  groups.write("groups/outer/inner/memory.max", "max\n");
  groups.write("groups/outer/inner/memory.current", "2000\n");
  EXPECT_EQ(groups.read().memory_left(), 600);
}

TEST(ControlGroups, of_version_1_limit_by_controller)
{
  const Groups groups;
  groups.write("list", "9:name=systemd:/\n4:memory:/jobs/one\n2:cpu,cpuacct:/jobs\n0::/\n");
  groups.write("groups/cpu/jobs/cpu.cfs_quota_us", "-1\n");
  groups.write("groups/cpu/jobs/cpu.cfs_period_us", "100000\n");
  groups.write("groups/memory/jobs/one/memory.limit_in_bytes", "4000\n");
  groups.write("groups/memory/jobs/one/memory.usage_in_bytes", "3000\n");
  groups.write("groups/memory/jobs/one/memory.stat", "cache 5\ntotal_cache 500\n");
  EXPECT_EQ(groups.read().processors(), infinity);
  EXPECT_EQ(groups.read().memory_left(), 1500);
  groups.write("groups/cpu/jobs/cpu.cfs_quota_us", "250000\n");
  EXPECT_EQ(groups.read().processors(), 2.5);
}

/// A container shows its own group as the root, whatever the list calls it.
TEST(ControlGroups, of_a_container_are_at_the_root)
{
  const Groups groups;
  groups.write("list", "2:cpu,cpuacct:/docker/0123\n1:memory:/docker/0123\n");
  groups.write("groups/cpu/cpu.cfs_quota_us", "50000\n");
  groups.write("groups/cpu/cpu.cfs_period_us", "100000\n");
  groups.write("groups/memory/memory.limit_in_bytes", "900\n");
  groups.write("groups/memory/memory.usage_in_bytes", "400\n");
  EXPECT_EQ(groups.read().processors(), 0.5);
  EXPECT_EQ(groups.read().memory_left(), 500);
}

}  // namespace
}  // namespace berm::this_file
