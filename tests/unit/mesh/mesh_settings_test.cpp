// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/mesh_settings.hpp"

#include "os/error.hpp"
#include "os/gmsh_program.hpp"
#include "samples/sample_meshes.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::mesh::this_file {
namespace {

constexpr const char* square = R"(
Point(1) = {0, 0, 0, 0.3};
Point(2) = {1, 0, 0, 0.3};
Point(3) = {1, 1, 0, 0.3};
Point(4) = {0, 1, 0, 0.3};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("soil") = {1};
Physical Curve("base") = {1};
)";

// Restores PATH at its end.
class Path {
public:
  explicit Path(const std::string& path) : before_(getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
  ~Path() { setenv("PATH", before_.c_str(), 1); }

private:
  std::string before_;
};

std::string failure_of(const std::filesystem::path& geo, const std::filesystem::path& msh)
{
  try {
    run_gmsh(geo, msh, 2, GeometryBy::berm);
  } catch (const RunError& error) {
    return error.what();
  }
  return "none";
}

TEST(RunGmsh, meshes_a_geometry_and_keeps_what_gmsh_said)
{
  const TemporaryFolder folder;
  run_gmsh(folder.write("square.geo", square), folder / "mesh.msh", 2, GeometryBy::berm);
  const auto mesh = read_msh<2>(folder / "mesh.msh");
  EXPECT_GT(mesh.cell_count(), 10);
  EXPECT_GT(mesh.boundary_nodes[mesh.find_boundary("base")].size(), 3u);
  EXPECT_TRUE(std::filesystem::exists(folder / "mesh.log"));
}

TEST(RunGmsh, does_not_read_its_users_options)
{
  const TemporaryFolder folder;
  const auto geo = folder.write("square.geo", square);
  run_gmsh(geo, folder / "first.msh", 2, GeometryBy::berm);
  folder.write(".gmsh-options", "Mesh.MeshSizeFactor = 0.2;\n");
  const std::string home = getenv("HOME") == nullptr ? "" : getenv("HOME");
  setenv("HOME", folder.path().c_str(), 1);
  const TemporaryFolder elsewhere;
  run_gmsh(geo, elsewhere / "second.msh", 2, GeometryBy::berm);
  setenv("HOME", home.c_str(), 1);
  EXPECT_EQ(folder.read("first.msh"), elsewhere.read("second.msh"));
}

TEST(RunGmsh, says_how_to_install_what_is_missing)
{
  const TemporaryFolder folder;
  const auto geo = folder.write("square.geo", square);
  const Path nowhere(folder.path().string());
  EXPECT_EQ(failure_of(geo, folder / "mesh.msh"), "gmsh is not installed: sudo apt-get install gmsh");
}

TEST(RunGmsh, shows_the_end_of_what_gmsh_said_when_it_fails)
{
  const TemporaryFolder folder;
  const std::string broken = failure_of(folder.write("broken.geo", "Point(1) = {0, 0;\n"), folder / "mesh.msh");
  EXPECT_NE(broken.find("gmsh failed on"), broken.npos) << broken;
  EXPECT_NE(broken.find("broken.geo"), broken.npos) << broken;
  EXPECT_NE(broken.find("syntax error"), broken.npos) << broken;
  EXPECT_NE(failure_of(folder / "missing.geo", folder / "mesh.msh").find("no geometry"), std::string::npos);
  EXPECT_NE(failure_of(folder / "broken.geo", folder / "missing/mesh.msh").find("no folder"), std::string::npos);
}

TEST(RunGmsh, tells_a_signal_from_a_failure_and_never_takes_an_old_mesh_for_a_result)
{
  const TemporaryFolder folder;
  const auto geo = folder.write("square.geo", square);
  folder.write("mesh.msh", "old");
  const auto stand_in = [&](const std::string& script) {
    std::filesystem::permissions(folder.write("gmsh", "#!/bin/sh\n" + script), std::filesystem::perms::owner_all);
  };
  const Path stand_in_first(folder.path().string() + ":/bin:/usr/bin");
  stand_in("kill -2 $$\n");
  const std::string message = failure_of(geo, folder / "mesh.msh");
  EXPECT_NE(message.find("signal 2"), message.npos) << message;
  EXPECT_FALSE(std::filesystem::exists(folder / "mesh.msh"));
  stand_in("echo all is well\n");
  EXPECT_NE(failure_of(geo, folder / "mesh.msh").find("all is well"), std::string::npos);
}

TEST(WaitingGmsh, makes_the_meshes_of_a_program_of_its_own)
{
  const TemporaryFolder folder;
  const auto geo = folder.write("square.geo", std::string(square) + "Mesh.MshFileVersion = 4.1;\n");
  run_gmsh(geo, folder / "alone.msh", 2, GeometryBy::berm);
  std::string finer = folder.read("square.geo");
  for (std::size_t k = finer.find("0.3}"); k != finer.npos; k = finer.find("0.3}")) finer.replace(k, 3, "0.1");
  folder.write("finer.geo", finer);
  WaitingGmsh gmsh(folder.path());
  for (const char* name : {"first.msh", "second.msh"}) {
    gmsh.mesh("square.geo", name);
    EXPECT_EQ(folder.read(name), folder.read("alone.msh")) << name;
    gmsh.mesh("finer.geo", "finer.msh");
    EXPECT_GT(folder.read("finer.msh").size(), folder.read("alone.msh").size());
  }
}

TEST(WaitingGmsh, tells_a_failure_and_starts_anew)
{
  const TemporaryFolder folder;
  folder.write("square.geo", square);
  folder.write("broken.geo", "Point(1) = {0, 0;\n");
  WaitingGmsh gmsh(folder.path());
  try {
    gmsh.mesh("broken.geo", "mesh.msh");
    ADD_FAILURE() << "a broken geometry was meshed";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("syntax error"), std::string::npos) << error.what();
  }
  gmsh.mesh("square.geo", "mesh.msh");
  EXPECT_FALSE(folder.read("mesh.msh").empty());
}

// Takes down which member each key stands for.
class Keys : public Describe {
public:
  std::map<std::string, Leaf> leaves;
  std::map<std::string, Parameter> parameters;
  std::vector<std::string> kinds;
  int kind = 0;

  void check(bool, const std::string&, const std::string&, const std::vector<std::string>&) override {}

protected:
  void leaf(const char* key, Leaf variable, const Parameter& parameter) override
  {
    EXPECT_TRUE(leaves.emplace(key, variable).second) << "a second key " << key;
    parameters[key] = parameter;
  }
  int choose(const char* key, const std::vector<const char*>& names, int current, const Parameter&) override
  {
    if (std::string(key) != "kind") return current;
    kinds.assign(names.begin(), names.end());
    return kind;
  }
  void enter(const char*, const Parameter&) override {}
  void leave() override {}
  bool has_table(const char*, bool present) override { return present; }
  std::vector<std::string> names_in(const char*, const std::vector<std::string>&, const Parameter&) override { return {}; }
  void enter_named(const char*, const std::string&) override {}
  int count_in(const char*, int present, const Parameter&) override { return present; }
  void enter_item(const char*, int) override {}
};

TEST(MeshSettings, kind_chooses_the_struct_that_the_other_keys_fill)
{
  MeshSettings settings;
  Keys keys;
  keys.kind = 1;
  describe(keys, settings);
  EXPECT_EQ(keys.kinds, (std::vector<std::string>{"seabed", "gmsh", "box"}));
  ASSERT_TRUE(std::holds_alternative<GmshFile>(settings));
  EXPECT_EQ(std::get<std::string*>(keys.leaves.at("file")), &std::get<GmshFile>(settings).file);
  EXPECT_TRUE(keys.parameters.at("file").required);
}

TEST(MeshSettings, keys_of_a_seabed_stand_for_their_members)
{
  SeabedMesh bed;
  Keys keys;
  describe(keys, bed);
  const std::map<std::string, Real*> members = {{"length", &bed.length},
                                                {"depth", &bed.depth},
                                                {"headroom", &bed.headroom},
                                                {"near_size", &bed.near_size},
                                                {"near_left", &bed.near_left},
                                                {"near_right", &bed.near_right},
                                                {"near_depth", &bed.near_depth},
                                                {"near_height", &bed.near_height},
                                                {"growth", &bed.growth},
                                                {"layer", &bed.layer},
                                                {"slope", &bed.slope}};
  const std::map<std::string, std::optional<Real>*> optional_members = {{"left", &bed.left},           {"far_size", &bed.far_size},
                                                                        {"width", &bed.width},         {"back", &bed.back},
                                                                        {"near_back", &bed.near_back}, {"near_front", &bed.near_front}};
  EXPECT_EQ(keys.leaves.size(), members.size() + optional_members.size());
  for (const auto& [key, member] : members) {
    EXPECT_EQ(std::get<Real*>(keys.leaves.at(key)), member) << key;
    EXPECT_STREQ(keys.parameters.at(key).unit, key == "growth" ? "" : key == "slope" ? "rad" : "m");
    EXPECT_EQ(keys.parameters.at(key).required, key != "growth" && key != "layer" && key != "slope") << key;
  }
  for (const auto& [key, member] : optional_members) EXPECT_EQ(std::get<std::optional<Real>*>(keys.leaves.at(key)), member) << key;
}

TEST(MakeMesh, keeps_a_copy_of_the_users_mesh)
{
  const TemporaryFolder theirs, ours;
  run_gmsh(theirs.write("square.geo", square), theirs / "square.msh", 2, GeometryBy::berm);
  const auto mesh = make_mesh<2>(GmshFile{"square.msh"}, theirs.path(), ours / "run");
  EXPECT_GT(mesh.cell_count(), 10);
  EXPECT_EQ(ours.read("run/mesh.msh"), theirs.read("square.msh"));
  // A path from the root is taken as it is, and the kept copy can be read again into its own place.
  EXPECT_EQ(make_mesh<2>(GmshFile{(ours / "run/mesh.msh").string()}, theirs.path(), ours / "run").cell_count(), mesh.cell_count());
}

TEST(MakeMesh, lets_gmsh_mesh_the_users_geometry_in_the_plane_and_in_space)
{
  const TemporaryFolder theirs, ours;
  theirs.write("square.geo", square);
  theirs.write("cube.geo", std::string(square) + "box[] = Extrude {0, 0, 1} {Surface{1};};\nPhysical Volume(\"rock\") = {box[1]};\n");
  const auto plane = make_mesh<2>(GmshFile{"square.geo"}, theirs.path(), ours / "plane");
  EXPECT_GT(plane.cell_count(), 10);
  EXPECT_EQ(read_msh<2>(ours / "plane/mesh.msh").cell_count(), plane.cell_count());
  const auto space = make_mesh<3>(GmshFile{"cube.geo"}, theirs.path(), ours / "space");
  EXPECT_GT(space.cell_count(), 50);
  EXPECT_NE(space.find_region("rock"), none);
}

TEST(MakeMesh, of_a_geometry_that_gives_no_mesh_names_the_key_and_no_file_of_its_own)
{
  const TemporaryFolder theirs, ours;
  const auto refusal = [&](const char* geometry) -> std::string {
    theirs.write("their.geo", geometry);
    try {
      make_mesh<2>(GmshFile{"their.geo"}, theirs.path(), ours.path());
    } catch (const KeyError& error) {
      return error.what();
    }
    return "accepted";
  };
  const std::string empty = refusal("Mesh.Algorithm = 6;\n");
  EXPECT_EQ(empty.find("mesh.file: the mesh that gmsh made cannot be used: line "), 0u) << empty;
  EXPECT_NE(empty.find("the file ends without a section"), std::string::npos) << empty;
  EXPECT_EQ(empty.find("mesh.msh"), std::string::npos) << empty;
  const std::string unnamed = std::string(square).substr(0, std::string(square).find("Physical"));
  EXPECT_EQ(refusal(unnamed.c_str()).find("mesh.file: the mesh that gmsh made cannot be used: no triangle is in a named physical group"),
            0u)
      << refusal(unnamed.c_str());
}

TEST(MakeMesh, refuses_a_missing_file_with_its_name)
{
  const TemporaryFolder folder;
  for (const char* name : {"missing.msh", "missing.geo"}) try {
      make_mesh<2>(GmshFile{name}, folder.path(), folder.path());
      FAIL() << "accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find((folder / name).string()), std::string::npos) << error.what();
    }
}

TEST(MakeMesh, makes_boxes)
{
  const TemporaryFolder folder;
  EXPECT_EQ(make_mesh<2>(sample_box<2>(), ".", folder.path()).cell_count(), 56);
  EXPECT_EQ(make_mesh<3>(sample_box<3>(), ".", folder.path()).cell_count(), 504);
}

TEST(MakeMesh, says_when_the_run_folder_cannot_be_made)
{
  const TemporaryFolder folder;
  folder.write("file", "");
  EXPECT_THROW(make_mesh<2>(sample_box<2>(), ".", folder / "file"), RunError);
}

TEST(MeshSettings, of_a_file_that_is_not_there_name_their_key)
{
  const TemporaryFolder folder;
  for (const std::string name : {"nowhere.msh", "nowhere.geo"}) {
    GmshFile file;
    file.file = name;
    try {
      make_mesh<2>(file, folder.path(), folder / "work");
      FAIL() << "there is no " << name;
    } catch (const KeyError& error) {
      EXPECT_EQ(std::string(error.what()).find("mesh.file: "), 0u) << error.what();
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace berm::mesh::this_file
