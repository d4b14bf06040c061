// SPDX-License-Identifier: BSD-3-Clause
// Meshes as other programs leave them: other units and axes, parts, middles of sides, doubled nodes.
#include "mesh/gmsh.hpp"
#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace berm::mesh::this_file {
namespace {

constexpr const char* head = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"base\"\n2 2 \"soil\"\n$EndPhysicalNames\n";

/// The section $Nodes of one block, the tags from 1.
std::string nodes(const std::vector<Vec<3>>& points)
{
  std::string text = fmt::format("$Nodes\n1 {0} 1 {0}\n2 1 0 {0}\n", points.size());
  for (std::size_t k = 1; k <= points.size(); ++k) text += fmt::format("{}\n", k);
  for (const Vec<3>& x : points) text += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  return text + "$EndNodes\n";
}

constexpr const char* entities =
    "$Entities\n0 1 1 0\n1 0 0 0 1 0 0 1 1 0\n1 0 0 0 1 1 0 1 2 0\n$EndEntities\n";  // curve 1 in "base", surface 1 in "soil"

/// Two triangles with the corners 1 2 3 and the last three of the second, and a side from 1 to 2.
std::string elements(const char* second)
{
  return fmt::format("$Elements\n2 3 1 3\n1 1 1 1\n1 1 2\n2 1 2 2\n2 1 2 3\n3 {}\n$EndElements\n", second);
}

const std::vector<Vec<3>> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
/// The same with the corners of the second triangle by themselves, one of them off by `off`.
std::vector<Vec<3>> doubled(Real off)
{
  std::vector<Vec<3>> points = square;
  points.emplace_back(0, 0, 0);
  points.emplace_back(1 + off, 1, 0);
  return points;
}

Mesh<2> read(const std::string& text, const GmshFile& settings = {})
{
  const TemporaryFolder folder;
  return read_msh<2>(folder.write("mesh.msh", text), settings);
}

std::string message_of(const std::string& text, const GmshFile& settings = {})
{
  try {
    read(text, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string whole(const std::vector<Vec<3>>& points, const char* second)
{
  return fmt::format("{}{}{}{}", head, entities, nodes(points), elements(second));
}

TEST(MeshFiles, are_scaled_turned_and_shifted_in_this_order)
{
  GmshFile settings;
  settings.scale = 1e-3;
  settings.axes = {"x", "-z"};
  settings.shift = {10, -2};
  std::vector<Vec<3>> points;
  for (const Vec<3>& x : square) points.emplace_back(1000 * x[0], 0, 3000 * x[1]);
  const Mesh<2> mesh = read(whole(points, "1 3 4"), settings);
  EXPECT_EQ(mesh.lower, Vec<2>(10, -5));
  EXPECT_EQ(mesh.upper, Vec<2>(11, -2));
  EXPECT_GT(mesh.section(0), 0);  // a mirrored mesh has its corners the right way round
  EXPECT_EQ(mesh.boundary_nodes[0].size(), 2u);
  EXPECT_NE(message_of(whole(points, "1 3 4")).find("mesh.axes"), std::string::npos) << "it lies in x and z";
}

TEST(MeshFiles, in_space_take_z_up)
{
  std::string text = std::string("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 2 \"soil\"\n$EndPhysicalNames\n") +
                     "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 1 2 0\n$EndEntities\n$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n" +
                     "0 0 0\n1 0 0\n0 2 0\n0 0 3\n$EndNodes\n$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n";
  GmshFile settings;
  settings.axes = {"x", "z", "-y"};
  const TemporaryFolder folder;
  const Mesh<3> mesh = read_msh<3>(folder.write("mesh.msh", text), settings);
  EXPECT_EQ(mesh.lower, Vec<3>(0, 0, -2));
  EXPECT_EQ(mesh.upper, Vec<3>(1, 3, 0));
  EXPECT_DOUBLE_EQ(mesh.section(0), 1);
}

TEST(MeshFiles, may_begin_with_a_byte_order_mark)
{
  EXPECT_EQ(read("\xEF\xBB\xBF" + whole(square, "1 3 4")).cell_count(), 2);
}

TEST(MeshFiles, of_second_order_give_their_corners_and_say_so)
{
  std::vector<Vec<3>> points = square;
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 0}}) points.push_back((square[a] + square[b]) / 2);
  const std::string text = std::string(head) + entities + nodes(points) +
                           "$Elements\n2 3 1 3\n1 1 8 1\n1 1 2 5\n2 1 9 2\n2 1 2 3 5 6 7\n3 1 3 4 7 8 9\n$EndElements\n";
  const Mesh<2> mesh = read(text);
  EXPECT_EQ(mesh.cell_count(), 2);
  EXPECT_EQ(mesh.node_count(), 4);
  EXPECT_EQ(mesh.boundary_nodes[0].size(), 2u);
  ASSERT_EQ(mesh.remarks.size(), 1u);
  EXPECT_NE(mesh.remarks[0].find("second order"), std::string::npos);
  EXPECT_TRUE(read(whole(square, "1 3 4")).remarks.empty());
}

// Surface 1 of "soil" is cut into the parts 2 and 3; what Gmsh adds are groups of its own.
TEST(MeshFiles, in_parts_are_read_as_a_whole)
{
  std::string named = head;
  named.replace(named.find("\n2\n1 1"), 3, "\n3\n");
  named.replace(named.find("$EndPhysicalNames"), 0, "2 9 \"_part{1}_physical{2}\"\n");
  const std::string parts = "$PartitionedEntities\n2\n1\n7 1\n0 1 2 0\n2 1 1 1 1 0 0 0 1 0 0 1 1 0\n2 2 1 1 1 0 0 0 1 1 0 2 2 9 0\n"
                            "3 2 1 2 1 2 0 0 0 1 1 0 1 2 0\n$EndPartitionedEntities\n";
  const std::string all =
      named + entities + parts + nodes(square) + "$Elements\n3 3 1 3\n1 2 1 1\n1 1 2\n2 2 2 1\n2 1 2 3\n2 3 2 1\n3 1 3 4\n$EndElements\n";
  const Mesh<2> mesh = read(all);
  EXPECT_EQ(mesh.cell_count(), 2);
  EXPECT_EQ(mesh.region_names, std::vector<std::string>{"soil"});
  EXPECT_EQ(mesh.boundary_nodes[0].size(), 2u);
}

TEST(DoubledNodes, are_refused_with_their_place)
{
  for (const Real off : {0., 1e-9, 9e-4}) {
    const std::string message = message_of(whole(doubled(off), "5 6 4"));
    EXPECT_TRUE(message.find("two nodes lie at (0, 0) m") != std::string::npos ||
                message.find("two nodes lie at (1, 1) m") != std::string::npos)
        << message;
    EXPECT_NE(message.find("mesh.merge_tolerance = \"0.1 m\""), std::string::npos) << message;
  }
}

TEST(DoubledNodes, become_one_within_the_tolerance)
{
  GmshFile settings;
  settings.merge_tolerance = 1e-2;
  const Mesh<2> mesh = read(whole(doubled(5e-3), "5 6 4"), settings);
  EXPECT_EQ(mesh.node_count(), 4);
  EXPECT_EQ(mesh.upper, Vec<2>(1, 1));  // where the first of them is
  Index neighbors = 0;
  for (int corner = 0; corner < 3; ++corner) neighbors += mesh.neighbor(0, corner) != none;
  EXPECT_EQ(neighbors, 1);
  ASSERT_EQ(mesh.remarks.size(), 1u);
  EXPECT_NE(mesh.remarks[0].find("has 2 nodes"), std::string::npos);

  EXPECT_TRUE(read(whole(square, "1 3 4"), settings).remarks.empty()) << "there are none";
  settings.merge_tolerance = 1;
  EXPECT_NE(message_of(whole(doubled(0), "5 6 4"), settings).find("as long as the edge of a cell"), std::string::npos);
  settings.merge_tolerance = 1e-6;  // too little for one of the two pairs
  EXPECT_NE(message_of(whole(doubled(9e-4), "5 6 4"), settings).find("two nodes lie at (1.0009, 1) m"), std::string::npos);
}

// Where nodes lie at the sides of the boxes that they are looked up in.
TEST(DoubledNodes, are_found_wherever_they_lie)
{
  for (const Real x : {-4e-3, -1e-3, 0., 3.9999e-3, 4e-3, 1e5})
    for (const Real off : {-9e-4, 9e-4}) {
      std::vector<Vec<3>> points = doubled(0);
      for (Vec<3>& point : points) point[0] += x, point[1] -= x;
      points[5] += Vec<3>(off, 0, 0);
      points[4] += Vec<3>(0, 5e-2, 0);  // this pair is far apart
      EXPECT_NE(message_of(whole(points, "5 6 4")).find("two nodes lie at"), std::string::npos) << x << " " << off;
    }
}

/// Triangles of "soil" in the plane.
std::string triangles(const std::vector<Vec<3>>& points, const std::vector<std::string>& corners)
{
  std::string text = std::string(head) + entities + nodes(points) + fmt::format("$Elements\n1 {0} 1 {0}\n2 1 2 {0}\n", corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) text += fmt::format("{} {}\n", k + 1, corners[k]);
  return text + "$EndElements\n";
}

constexpr const char* loose = "parts of the mesh touch at ";

// Two surfaces of one body that meet along a line, which each has meshed by itself.
TEST(LooseBorders, of_surfaces_that_meet_at_a_line_with_nodes_of_each_are_refused_with_a_place)
{
  const std::vector<Vec<3>> doubled = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
  EXPECT_NE(message_of(triangles(doubled, {"1 2 3", "1 3 4", "5 6 7", "5 7 8"})).find("two nodes lie at (1, 0) m"), std::string::npos);
  std::vector<Vec<3>> apart = doubled;
  for (std::size_t k : {4u, 7u}) apart[k][0] += 5e-3;  // more than a thousandth of an edge
  const std::string message = message_of(triangles(apart, {"1 2 3", "1 3 4", "5 6 7", "5 7 8"}));
  EXPECT_NE(message.find(std::string(loose) + "(1, 0.5) m and share no nodes there"), std::string::npos) << message;
  GmshFile settings;
  settings.merge_tolerance = 1e-2;
  EXPECT_EQ(read(triangles(apart, {"1 2 3", "1 3 4", "5 6 7", "5 7 8"}), settings).node_count(), 6);
}

TEST(LooseBorders, with_nodes_at_other_places_of_the_line_are_refused)
{
  // The right part begins and ends elsewhere on the line.
  const std::vector<Vec<3>> shifted = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, -0.3, 0}, {2, 0, 0}, {2, 1, 0}, {1, 0.8, 0}};
  EXPECT_NE(message_of(triangles(shifted, {"1 2 3", "1 3 4", "5 6 7", "5 7 8"})).find(loose), std::string::npos);
  // The ends are shared, and a node of the right part hangs between them.
  const std::vector<Vec<3>> hanging = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0.5, 0}, {1, 0.5, 0}};
  EXPECT_NE(message_of(triangles(hanging, {"1 2 3", "1 3 4", "2 5 6", "6 5 3"})).find(loose), std::string::npos);
  // Of the right part only a fifth of its side lies at the left one.
  const std::vector<Vec<3>> end = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0.8, 0}, {2, 1, 0}, {1, 1.8, 0}};
  EXPECT_NE(message_of(triangles(end, {"1 2 3", "1 3 4", "5 6 7"})).find(loose), std::string::npos);
}

TEST(LooseBorders, in_space_with_another_diagonal_in_the_common_side_are_refused)
{
  const auto text = [](const char* upper) {
    return std::string("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 2 \"soil\"\n$EndPhysicalNames\n") +
           "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 1 2 0\n$EndEntities\n$Nodes\n1 6 1 6\n3 1 0 6\n1\n2\n3\n4\n5\n6\n" +
           "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 -1\n0.5 0.5 1\n$EndNodes\n$Elements\n1 4 1 4\n3 1 4 4\n1 1 2 3 5\n2 1 3 4 5\n" + upper +
           "$EndElements\n";
  };
  const TemporaryFolder folder;
  EXPECT_EQ(read_msh<3>(folder.write("whole.msh", text("3 1 2 3 6\n4 1 3 4 6\n")), GmshFile{}).cell_count(), 4);
  try {
    read_msh<3>(folder.write("loose.msh", text("3 1 2 4 6\n4 2 3 4 6\n")), GmshFile{});
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(loose), std::string::npos) << error.what();
  }
}

TEST(LooseBorders, of_parts_that_lie_apart_or_meet_in_a_corner_are_none)
{
  const std::vector<Vec<3>> gap = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1.05, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1.05, 1, 0}};
  EXPECT_EQ(read(triangles(gap, {"1 2 3", "1 3 4", "5 6 7", "5 7 8"})).cell_count(), 4);
  const std::vector<Vec<3>> corner = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1.02, 0}, {1, 2, 0}};
  EXPECT_EQ(read(triangles(corner, {"1 2 3", "1 3 4", "3 5 6"})).cell_count(), 3);
}

}  // namespace
}  // namespace berm::mesh::this_file
