// SPDX-License-Identifier: BSD-3-Clause
#include "os/mesh_cache.hpp"

#include "mesh/mesh_settings.hpp"
#include "samples/temporary_folder.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace berm::mesh::this_file {
namespace {

SeabedMesh bed_of(Real near_size)
{
  SeabedMesh bed;
  bed.length = 0.3, bed.depth = 0.1, bed.headroom = 0.03;
  bed.near_size = near_size, bed.far_size = 0.015;
  bed.near_left = -0.05, bed.near_right = 0.07, bed.near_depth = 0.025, bed.near_height = 0.015;
  return bed;
}

/// While it lives, a gmsh that counts how often it is started stands before the one of the system.
class CountedGmsh {
public:
  CountedGmsh() : path_(getenv("PATH"))
  {
    const auto program = folder_.write("gmsh", "#!/bin/sh\necho once >> \"${0%/*}/count\"\nPATH=\"$WHOLE_PATH\" exec gmsh \"$@\"\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    setenv("WHOLE_PATH", path_.c_str(), 1);
    setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  }
  ~CountedGmsh() { setenv("PATH", path_.c_str(), 1); }
  long count() const
  {
    const std::string lines = folder_.read("count");
    return std::count(lines.begin(), lines.end(), '\n');
  }

private:
  TemporaryFolder folder_;
  std::string path_;
};

/// The bytes of the mesh that a run would have of this bed.
std::string mesh_of(Real near_size)
{
  const TemporaryFolder run;
  make_mesh<2>(bed_of(near_size), ".", run.path());
  EXPECT_TRUE(std::filesystem::exists(run / "mesh.log"));
  return run.read("mesh.msh");
}

TEST(MeshCache, of_one_geometry_are_made_once_with_the_same_bytes)
{
  const CountedGmsh gmsh;
  const std::string alone = mesh_of(0.006);
  ASSERT_EQ(gmsh.count(), 1);
  {
    const TemporaryFolder folder;
    const MeshCache kept(folder.path());
    for (int run = 0; run < 3; ++run) EXPECT_TRUE(mesh_of(0.006) == alone);
    EXPECT_EQ(gmsh.count(), 2);
    EXPECT_FALSE(mesh_of(0.008) == alone) << "of another geometry";
    EXPECT_EQ(gmsh.count(), 3);
  }
  EXPECT_TRUE(mesh_of(0.006) == alone);
  EXPECT_EQ(gmsh.count(), 4) << "none is kept behind";
}

TEST(MeshCache, are_made_by_one_of_several_processes_that_want_them_at_once)
{
  const CountedGmsh gmsh;
  const TemporaryFolder folder;
  const MeshCache kept(folder.path());
  std::vector<pid_t> runs;
  for (int run = 0; run < 4; ++run)
    if (runs.push_back(::fork()); runs.back() == 0) ::_exit(mesh_of(0.006).empty() ? 1 : 0);
  for (const pid_t run : runs) {
    int status = -1;
    ::waitpid(run, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(gmsh.count(), 1);
}

TEST(MeshCache, that_cannot_be_kept_or_are_not_whole_are_made_each_time)
{
  const CountedGmsh gmsh;
  {
    const MeshCache kept("/proc/no such folder");
    for (int run = 0; run < 2; ++run) mesh_of(0.006);
    EXPECT_EQ(gmsh.count(), 2);
  }
  const TemporaryFolder folder;
  const MeshCache kept(folder.path());
  const std::string whole = mesh_of(0.006);
  for (const auto& file : std::filesystem::directory_iterator(folder.path()))
    if (file.path().extension() == ".msh") std::filesystem::remove(file.path());
  EXPECT_TRUE(mesh_of(0.006) == whole);
  EXPECT_EQ(gmsh.count(), 4);
}

}  // namespace
}  // namespace berm::mesh::this_file
