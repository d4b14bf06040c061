// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/gmsh.hpp"

#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <random>

namespace berm::mesh::this_file {
namespace {

// The unit square of two triangles, "upper" and "lower", with its left side named; node tags have gaps, a curve and a point have no name.
const std::string square = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
4
0 9 "left"
1 5 "left"
2 7 "lower part"
2 8 "upper"
$EndPhysicalNames
$Entities
2 2 2 0
1 0 0 0 1 9
2 1 0 0 0
1 0 0 0 0 1 0 1 -5 2 1 -2
2 0 0 0 1 0 0 0 2 1 -2
1 0 0 0 1 1 0 1 7 2 1 2
2 0 0 0 1 1 0 1 8 2 1 2
$EndEntities
$Nodes
3 4 1 400
0 1 0 1
10
0 0 0
1 1 0 1
400
0 1 0
2 1 0 2
30
7
1 0 0
1 1 0
$EndNodes
$Elements
5 5 1 5
0 1 15 1
1 10
1 1 1 1
2 10 400
1 2 1 1
3 10 30
2 1 2 1
4 10 30 7
2 2 2 1
5 10 400 7
$EndElements
)";

const std::string tetrahedron = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
2 1 "base"
3 2 "soil"
$EndPhysicalNames
$Entities
0 0 1 1
4 0 0 0 1 1 0 1 1 0
6 0 0 0 1 1 1 1 2 1 4
$EndEntities
$Nodes
1 4 1 4
3 6 0 4
1
2
3
4
0 0 0
1 0 0
0 1 0
0 0 1
$EndNodes
$Elements
2 2 1 2
2 4 2 1
1 1 2 3
3 6 4 1
2 1 3 2 4
$EndElements
)";

std::string replaced(std::string text, const std::string& old, const std::string& with)
{
  const std::size_t place = text.find(old);
  EXPECT_NE(place, text.npos) << old;
  return text.replace(place, old.size(), with);
}

TEST(ReadMsh, reads_regions_and_boundaries_by_name)
{
  const TemporaryFolder folder;
  const auto mesh = read_msh<2>(folder.write("square.msh", square));
  ASSERT_EQ(mesh.cell_count(), 2);
  EXPECT_EQ(mesh.node_count(), 4);
  EXPECT_EQ(mesh.region_names, (std::vector<std::string>{"lower part", "upper"}));
  EXPECT_EQ(mesh.boundary_names, std::vector<std::string>{"left"});
  EXPECT_GT(mesh.volume(0) + mesh.volume(1), 1 - 1e-15);
  for (Index c = 0; c < 2; ++c)
    EXPECT_EQ(mesh.region_names[mesh.region[c]], mesh.centroid(c)[1] > mesh.centroid(c)[0] ? "upper" : "lower part");
  ASSERT_EQ(mesh.boundary_nodes[0].size(), 2u);
  for (const Index i : mesh.boundary_nodes[0]) EXPECT_EQ(mesh.position[i][0], 0);
}

TEST(ReadMsh, reads_tetrahedra)
{
  const TemporaryFolder folder;
  const auto mesh = read_msh<3>(folder.write("tetrahedron.msh", tetrahedron));
  ASSERT_EQ(mesh.cell_count(), 1);
  EXPECT_NEAR(mesh.volume(0), 1. / 6, 1e-15);
  ASSERT_EQ(mesh.boundary_nodes[mesh.find_boundary("base")].size(), 3u);
  for (const Index i : mesh.boundary_nodes[0]) EXPECT_EQ(mesh.position[i][2], 0);
}

TEST(ReadMsh, passes_over_sections_and_line_ends_that_do_not_matter)
{
  const TemporaryFolder folder;
  std::string text = replaced(square, "$Entities", "$Comments\nmade by hand\n$Nodes\n$EndComments\n$Entities");
  text = replaced(text, "$Elements", "$Periodic\n0\n$EndPeriodic\n\n$Elements");
  std::string windows;
  for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(read_msh<2>(folder.write("unix.msh", text)).cell_count(), 2);
  EXPECT_EQ(read_msh<2>(folder.write("windows.msh", windows)).cell_count(), 2);
}

TEST(ReadMsh, leaves_out_what_is_in_no_named_group)
{
  const TemporaryFolder folder;
  // A quadrangle may stand in a surface without a name.
  const std::string text = replaced(replaced(square, "2 8 \"upper\"", "2 9 \"upper\""), "2 2 2 1\n5 10 400 7", "2 2 3 1\n5 10 400 7 30");
  const auto mesh = read_msh<2>(folder.write("half.msh", text));
  EXPECT_EQ(mesh.cell_count(), 1);
  EXPECT_EQ(mesh.node_count(), 3);
  EXPECT_EQ(mesh.boundary_nodes[0].size(), 1u);  // the corner that is left
}

struct Malformed {
  const char *old, *with;
  int line;              // 0: the whole file is meant
  const char* expected;  // part of the message
};

void PrintTo(const Malformed& change, std::ostream* out)
{
  *out << testing::PrintToString(change.old) << " -> " << testing::PrintToString(change.with);
}

class MalformedMsh : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedMsh, is_refused_with_file_line_and_what_was_expected)
{
  const Malformed& change = GetParam();
  const TemporaryFolder folder;
  const auto path = folder.write("mesh.msh", replaced(square, change.old, change.with));
  try {
    read_msh<2>(path);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    const std::string start = path.string() + ":" + (change.line > 0 ? std::to_string(change.line) + ": " : " ");
    EXPECT_EQ(message.substr(0, start.size()), start) << message;
    EXPECT_NE(message.find(change.expected), message.npos) << message;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Table, MalformedMsh,
    testing::Values(
        Malformed{"$MeshFormat", "solid cube", 1, "not a mesh file of Gmsh"}, Malformed{"4.1 0 8", "2.2 0 8", 2, "convert with \"gmsh "},
        Malformed{"4.1 0 8", "4 0 8", 2, "convert with \"gmsh "}, Malformed{"4.1 0 8", "4.1 1 8", 2, "binary, but ASCII is needed"},
        Malformed{"4.1 0 8", "four", 2, "expected the version"}, Malformed{"$EndMeshFormat", "$Nodes", 3, "expected $EndMeshFormat"},
        Malformed{"4\n0 9", "5\n0 9", 10, "expected a physical name"}, Malformed{"4\n0 9", "-4\n0 9", 5, "out of range"},
        Malformed{"4\n0 9", "99999999999999999999\n0 9", 5, "out of range"},
        Malformed{"4\n0 9", "4000000\n0 9", 5, "too short for so many"}, Malformed{"2 8 \"upper\"", "2 8 upper", 9, "\"name\""},
        Malformed{"$Entities\n", "$\x1b[2J\n", 46, "expected $End?[2J"}, Malformed{"\"upper\"", "\"up\x1b[2J\"", 9, "control characters"},
        Malformed{"2 8 \"upper\"", "4 8 \"upper\"", 9, "out of range"}, Malformed{"2 2 2 0", "2 2 2", 12, "numbers of points"},
        Malformed{"2 2 2 0", "2 2 2000000 0", 12, "too short"}, Malformed{"2 1 0 0 0\n", "2 1 nan 0 0\n", 14, "not finite"},
        Malformed{"2 1 0 0 0\n", "2 1 0 0\n", 14, "a point"}, Malformed{"1 7 2 1 2", "12345678 7 2 1 2", 17, "too short"},
        Malformed{"1 7 2 1 2", "2 7 8 2 1 2", 17, "in one region only"},
        Malformed{"2 0 0 0 1 1 0 1 8", "1 0 0 0 1 1 0 1 8", 18, "defined twice"}, Malformed{"3 4 1 400", "3 5 1 400", 32, "hold 4 nodes"},
        Malformed{"3 4 1 400", "900719925474099300 4 1 400", 21, "too short"},
        Malformed{"0 1 0 1\n10", "0 3 0 1\n10", 22, "not among the entities"},
        Malformed{"0 1 0 1\n10", "0 1 0 1000000000\n10", 22, "too short"}, Malformed{"\n400\n", "\n10\n", 26, "defined twice"},
        Malformed{"\n400\n", "\n-4\n", 26, "out of range"}, Malformed{"\n400\n", "\n400 401\n", 26, "follows"},
        Malformed{"\n0 1 0\n", "\n0 1\n", 27, "coordinates"}, Malformed{"\n0 1 0\n", "\n0 inf 0\n", 27, "not finite"},
        Malformed{"\n0 1 0\n", "\n0 1e999 0\n", 27, "out of range"}, Malformed{"\n0 1 0\n", "\n0 1.5x 0\n", 27, "coordinates"},
        Malformed{"\n1 1 0\n", "\n1 1 0.5\n", 43, "z = 0"}, Malformed{"5 5 1 5", "4 5 1 5", 43, "hold 4 elements"},
        Malformed{"5 5 1 5", "5 6 1 5", 45, "hold 5 elements"}, Malformed{"2 1 2 1\n4", "2 1 3 1\n4", 42, "quadrangles"},
        Malformed{"2 1 2 1\n4", "2 1 9 1\n4", 43, "second order"}, Malformed{"2 1 2 1\n4", "2 1 -2 1\n4", 42, "out of range"},
        Malformed{"2 1 2 1\n4", "3 1 4 1\n4", 42, "volume 1 is not among the entities"},
        Malformed{"4 10 30 7", "4 10 30", 43, "3 nodes of a triangle"}, Malformed{"4 10 30 7", "4 10 30 7 400", 43, "follows"},
        Malformed{"4 10 30 7", "4 10 30 8", 43, "node 8 is not among"}, Malformed{"4 10 30 7", "4 10 30 0", 43, "out of range"},
        Malformed{"2 10 400", "2", 39, "node tags"}, Malformed{"4 10 30 7", "4 10 10 7", 0, "no volume"},
        Malformed{"5 10 400 7", "5 10 30 7", 0, "same side"},
        Malformed{"2 7 \"lower part\"\n2 8 \"upper\"", "1 7 \"lower part\"\n1 8 \"upper\"", 0, "no triangle is in a named physical group"},
        Malformed{"$EndElements", "", 46, "but the file ends here"}, Malformed{"$EndNodes", "$EndNode", 33, "expected $EndNodes"}));

TEST(ReadMsh, refuses_a_file_without_a_needed_section)
{
  const TemporaryFolder folder;
  for (const std::string section : {"Entities", "Nodes", "Elements"}) {
    const std::size_t begin = square.find("$" + section), end = square.find("$End" + section) + section.size() + 5;
    const auto path = folder.write("mesh.msh", square.substr(0, begin) + square.substr(end));
    EXPECT_THROW(read_msh<2>(path), InputError) << section;
  }
}

TEST(ReadMsh, refuses_a_missing_file_and_a_folder)
{
  const TemporaryFolder folder;
  EXPECT_THROW(read_msh<2>(folder / "missing.msh"), InputError);
  EXPECT_THROW(read_msh<2>(folder.path()), InputError);
  EXPECT_THROW(read_msh<2>(folder.write("empty.msh", "")), InputError);
}

TEST(ReadMsh, refuses_a_mesh_of_another_dimension)
{
  const TemporaryFolder folder;
  EXPECT_THROW(read_msh<3>(folder.write("square.msh", square)), InputError);
  EXPECT_THROW(read_msh<2>(folder.write("tetrahedron.msh", tetrahedron)), InputError);
}

TEST(ReadMsh, survives_any_cut_and_any_changed_byte)
{
  // Either a mesh or an InputError, never anything else: other exceptions, crashes and endless loops fail the test.
  const TemporaryFolder folder;
  const auto survives = [&](const std::string& text) {
    try {
      EXPECT_GT(read_msh<2>(folder.write("mesh.msh", text)).cell_count(), 0);
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()), "");
    }
  };
  for (std::size_t length = 0; length < square.size(); ++length) survives(square.substr(0, length));
  std::mt19937 random(6);
  const std::string bytes("0123456789-.e$\"\n nNA\0\xff", 22);
  for (int n = 0; n < 3000; ++n) {
    std::string text = square;
    for (int changes = 0; changes < 1 + n % 3; ++changes) text[random() % text.size()] = bytes[random() % bytes.size()];
    survives(text);
  }
}

}  // namespace
}  // namespace berm::mesh::this_file
