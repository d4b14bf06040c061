// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid/rigid_body.hpp"
#include "bodies/rigid/triangle_faults.hpp"
#include "bodies/rigid/triangle_file.hpp"
#include "os/error.hpp"

#include <cctype>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace berm::bodies::this_file {
namespace {

/// A folder of its own for the files of a test.
class SurfaceFile : public testing::Test {
protected:
  std::filesystem::path file(const std::string& name, const std::string& text) const
  {
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  /// The message with which a file is refused, without the folder.
  std::string refusal(const std::string& name, const std::string& text) const
  {
    TriangulatedSettings settings;
    settings.file = file(name, text).string();
    try {
      read_solid(settings);
    } catch (const InputError& error) {
      const std::string message = error.what();
      return message.substr(message.find(name));
    }
    return "accepted";
  }
};

/// A box as triangles, from lower to upper.
Triangles box_of(const Vec<3>& lower, const Vec<3>& upper)
{
  Triangles t;
  for (int k = 0; k < 8; ++k) t.points.emplace_back(k & 1 ? upper[0] : lower[0], k & 2 ? upper[1] : lower[1], k & 4 ? upper[2] : lower[2]);
  const Index sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& [a, b, c, d] : sides) t.corners.push_back({a, b, c}), t.corners.push_back({a, c, d});
  return t;
}

Triangles with(Triangles t, const Triangles& other)
{
  const Index first = static_cast<Index>(t.points.size());
  t.points.insert(t.points.end(), other.points.begin(), other.points.end());
  for (const auto& [a, b, c] : other.corners) t.corners.push_back({a + first, b + first, c + first});
  return t;
}

Triangles triangles_from(const SurfaceMesh<3>& surface)
{
  Triangles t;
  t.points = surface.points;
  for (const auto& cell : surface.cells)
    for (std::size_t k = 1; k + 1 < cell.points.size(); ++k) t.corners.push_back({cell.points[0], cell.points[k], cell.points[k + 1]});
  return t;
}

/// A torus with a square section of side 0.2 about a circle of radius 0.6: corners of both kinds, and a hole.
Triangles torus()
{
  return triangles_from(revolved_surface({{0.5, -0.1}, {0.7, -0.1}, {0.7, 0.1}, {0.5, 0.1}}, [](const Vec<3>& x) { return x; }));
}

std::string text_stl(const Triangles& t)
{
  std::string text = "solid body\n";
  for (const auto& corners : t.corners) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const Index k : corners) text += fmt::format("  vertex {} {} {}\n", t.points[k][0], t.points[k][1], t.points[k][2]);
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid body\n";
}

std::string in_capitals(std::string text)
{
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string binary_stl(const Triangles& t)
{
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");  // some programs begin binary files like that, too
  const auto add = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  add(static_cast<std::uint32_t>(t.corners.size()));
  for (const auto& corners : t.corners) {
    for (int d = 0; d < 3; ++d) add(0.f);
    for (const Index k : corners)
      for (int d = 0; d < 3; ++d) add(static_cast<float>(t.points[k][d]));
    add(std::uint16_t(0));
  }
  return bytes;
}

std::string obj(const Triangles& t)
{
  std::string text = "# a body\no body\n";
  for (const Vec<3>& x : t.points) text += fmt::format("v {} {} {}\n", x[0], x[1], x[2]);
  for (const auto& [a, b, c] : t.corners) text += fmt::format("f {}/1/2 {}//3 {}\n", a + 1, b + 1, c + 1);
  return text;
}

TEST_F(SurfaceFile, of_each_format_has_the_same_triangles)
{
  const Triangles box = box_of({0.25, -0.5, 1}, {1.25, 0.5, 3});
  for (const auto& [name, text] :
       {std::pair{"a.stl", text_stl(box)}, {"b.STL", binary_stl(box)}, {"c.obj", obj(box)}, {"capitals.stl", in_capitals(text_stl(box))}}) {
    const Triangles read = read_triangles(file(name, text));
    ASSERT_EQ(read.points.size(), 8u) << name;  // three times four corners become one point each
    ASSERT_EQ(read.corners.size(), 12u) << name;
    EXPECT_EQ(fault_of(read), "") << name;
    const Contents contents = contents_of(read);
    EXPECT_NEAR(contents.volume, 2, 1e-14) << name;
    EXPECT_NEAR((contents.center - Vec<3>(0.75, 0, 2)).norm(), 0, 1e-14) << name;
    EXPECT_NEAR((contents.inertia - Vec<3>(2. / 12, 5. / 12, 5. / 12)).norm(), 0, 1e-14) << name;  // ascending
  }
}

TEST_F(SurfaceFile, of_obj_may_have_polygons_and_count_from_the_last_vertex)
{
  const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                           "f 4 3 2 1\nf -4 -3 -2 -1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const Triangles read = read_triangles(file("q.obj", text));
  EXPECT_EQ(read.corners.size(), 12u);
  EXPECT_EQ(fault_of(read), "");
  EXPECT_NEAR(contents_of(read).volume, 1, 1e-15);
}

TEST_F(SurfaceFile, is_refused_with_what_is_wrong_and_where)
{
  const Triangles box = box_of({0, 0, 0}, {1, 1, 1});
  Triangles open = box, turned = box, flat = box, point = box, sheet = box;
  open.corners.pop_back();
  std::swap(turned.corners[0][1], turned.corners[0][2]);
  flat.corners.push_back({0, 1, 1});
  for (Vec<3>& x : point.points) x.setConstant(2);
  sheet.corners = {{0, 1, 2}, {0, 2, 1}};
  Triangles wings = box;
  wings.points.emplace_back(2, 0.5, 0.5);
  const Index tip = 8;
  wings.corners.insert(wings.corners.end(), {{0, 1, tip}, {1, 0, tip}});
  EXPECT_EQ(refusal("open.stl", text_stl(open)), "open.stl is not closed: 3 edges with one triangle, such as at (1, 0.5, 1) m");
  EXPECT_EQ(refusal("turned.stl", text_stl(turned)),
            "turned.stl 3 edges between triangles of opposite directions, such as at (0.5, 0.5, 0) m");
  EXPECT_EQ(refusal("flat.obj", obj(flat)), "flat.obj 1 triangle without area, such as at (0.666667, 0, 0) m");
  EXPECT_EQ(refusal("point.obj", obj(point)), "point.obj has no size: all its points are one");
  EXPECT_EQ(refusal("sheet.obj", obj(sheet)), "sheet.obj contains no volume");
  EXPECT_EQ(refusal("wings.obj", obj(wings)), "wings.obj 1 edge with more than two triangles, such as at (0.5, 0, 0) m");
  const std::string through = refusal("through.stl", text_stl(with(box, box_of({0.5, 0.25, 0.25}, {2, 0.75, 0.75}))));
  EXPECT_TRUE(through.starts_with("through.stl ") && through.find("pairs of triangles that cut through each other, such as at") < 40)
      << through;
  EXPECT_EQ(refusal("none.stl", "solid none\nendsolid none\n"), "none.stl has no triangle");
  EXPECT_EQ(refusal("word.stl", "solid a\nvertex 0 zero 0\n"), "word.stl:2: needs three numbers after \"vertex\"");
  EXPECT_EQ(refusal("far.obj", "v 0 0 0\nf 1 2 3\n"), "far.obj:2: \"2\" is not a vertex before this line, which has 1 of them");
  EXPECT_EQ(refusal("two.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n"), "two.obj:3: a face has three corners or more, and this one 2");
  EXPECT_EQ(refusal("half.stl", binary_stl(box).substr(0, 500).replace(0, 5, "other")),
            "half.stl: has 500 bytes, and a binary STL file with its 12 facets has 684");
  EXPECT_EQ(refusal("body.step", "ISO"), "body.step: is neither an STL nor an OBJ file by its ending: .stl, .obj");
  TriangulatedSettings missing;
  missing.file = "no_such_file.stl";
  EXPECT_THROW(read_solid(missing), InputError);
}

TEST_F(SurfaceFile, that_is_inside_out_is_turned)
{
  Triangles box = box_of({0, 0, 0}, {1, 1, 1});
  for (auto& corners : box.corners) std::swap(corners[0], corners[1]);
  TriangulatedSettings settings;
  settings.file = file("inside_out.stl", text_stl(box)).string();
  read_solid(settings);
  EXPECT_NEAR(settings.solid->contents.volume, 1, 1e-15);
  EXPECT_LT(surface_at<3>(make_shape<3>(settings), Vec<3>(0.5, 0.5, 0.5)).distance, 0);
}

/// Distance of a point from a triangle by halving its largest side until it is small: brute force of another kind.
Real distance_to(const Vec<3>& x, const Vec<3>& a, const Vec<3>& b, const Vec<3>& c)
{
  const auto from_line = [&](const Vec<3>& p, const Vec<3>& q) {
    const Real t = std::clamp((x - p).dot(q - p) / (q - p).squaredNorm(), Real(0), Real(1));
    return (x - p - t * (q - p)).norm();
  };
  const Vec<3> normal = cross(b - a, c - a);
  const auto side = [&](const Vec<3>& p, const Vec<3>& q) { return cross(q - p, x - p).dot(normal) >= 0; };
  if (side(a, b) && side(b, c) && side(c, a)) return std::abs((x - a).dot(normal)) / normal.norm();
  return std::min({from_line(a, b), from_line(b, c), from_line(c, a)});
}

TEST(TriangleMesh, distance_is_the_least_of_all_triangles_with_the_sign_of_the_winding_number)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> number(-1, 1);
  for (const Triangles& t : {torus(), with(box_of({-0.9, -0.8, -0.7}, {-0.1, 0.8, 0.7}), box_of({0, -0.05, -0.9}, {0.95, 0.05, 0.9}))}) {
    ASSERT_EQ(fault_of(t), "");
    const TriangleMesh mesh(t);
    int inner = 0;
    for (int n = 0; n < 3000; ++n) {
      const Vec<3> x = (n % 2 == 0 ? 1.0 : 1.4) * Vec<3>(number(random), number(random), number(random));  // some of them out of the grid
      Real least = infinity, winding = 0;
      for (const auto& [i, j, k] : t.corners) {
        least = std::min(least, distance_to(x, t.points[i], t.points[j], t.points[k]));
        const Vec<3> a = t.points[i] - x, b = t.points[j] - x, c = t.points[k] - x;
        winding += 2 * std::atan2(a.dot(cross(b, c)),
                                  a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() + b.dot(c) * a.norm() + c.dot(a) * b.norm());
      }
      const bool inside = winding > 2 * pi;  // 4 pi within, 0 outside
      inner += inside;
      const auto at = mesh.surface_at(x);
      EXPECT_NEAR(at.distance, inside ? -least : least, 1e-13) << x.transpose();
      EXPECT_NEAR(at.normal.norm(), 1, 1e-13);
      EXPECT_NEAR(mesh.surface_at(Vec<3>(x - at.distance * at.normal)).distance, 0, 1e-13);
    }
    EXPECT_GT(inner, 25);  // of the torus: its volume is 0.15 m3 of cubes of 8 and 22 m3
  }
}

TEST(TriangleMesh, at_its_own_points_and_edges_has_a_normal_that_leads_out)
{
  const TriangleMesh mesh(box_of({-1, -1, -1}, {1, 1, 1}));
  EXPECT_NEAR((mesh.surface_at(Vec<3>(1, 1, 1)).normal - Vec<3>(1, 1, 1).normalized()).norm(), 0, 1e-14);
  EXPECT_NEAR((mesh.surface_at(Vec<3>(1, 1, 0.3)).normal - Vec<3>(1, 1, 0).normalized()).norm(), 0, 1e-14);
  EXPECT_NEAR((mesh.surface_at(Vec<3>(1, 0.2, 0.3)).normal - Vec<3>(1, 0, 0)).norm(), 0, 1e-14);
  EXPECT_NEAR((mesh.surface_at(Vec<3>(1.3, 1.4, 0.3)).normal - Vec<3>(0.6, 0.8, 0)).norm(), 0, 1e-14);  // an arc around the edge
}

TEST_F(SurfaceFile, as_a_rigid_body_is_where_and_as_heavy_as_the_box_that_it_is)
{
  TriangulatedSettings settings;
  settings.file = file("box.stl", text_stl(box_of({0, 0, 0}, {1000, 2000, 3000}))).string();
  settings.scale = 1e-3;
  settings.position = {0.1, 0.2, 0.3};
  settings.rotation = {0.3, -0.7, 1.1};
  read_solid(settings);
  const auto surface = make_shape<3>(RigidShapeSettings(settings));
  const Vec<3> center = to_vec<3>(settings.position) + turned_about_axes(settings.rotation) * Vec<3>(0.5, 1, 1.5);
  const auto box = make_shape<3>(RigidShapeSettings(BoxSettings{{center[0], center[1], center[2]}, {1, 2, 3}, 0, settings.rotation}));
  EXPECT_NEAR((center_of<3>(surface) - center).norm(), 0, 1e-14);
  EXPECT_NEAR(width_of<3>(surface), 1, 1e-14);
  EXPECT_NEAR(reach_of<3>(surface), reach_of<3>(box), 1e-14);
  const auto inertia = [](const RigidShape<3>& shape) {
    return Matrix<3>(axes_of<3>(shape) * inertia_over_mass<3>(shape).asDiagonal() * axes_of<3>(shape).transpose());
  };
  EXPECT_NEAR((inertia(surface) - inertia(box)).norm(), 0, 1e-13);
  std::mt19937 random(7);
  std::uniform_real_distribution<Real> number(-2, 2);
  RigidState<3> state;
  state.displacement = {0.4, -0.3, 0.2};
  state.orientation.turn_by(Vec<3>(0.5, 1, -0.7));
  const auto moved_surface = placed<3>(RigidBody<3>{"surface", surface}, state), moved_box = placed<3>(RigidBody<3>{"box", box}, state);
  for (int n = 0; n < 500; ++n) {
    const Vec<3> x = center + Vec<3>(number(random), number(random), number(random));
    EXPECT_NEAR(surface_at<3>(moved_surface, x).distance, surface_at<3>(moved_box, x).distance, 1e-13);
    EXPECT_NEAR(lowest_level<3>(surface, x.normalized()), lowest_level<3>(box, x.normalized()), 1e-13);
  }
}

}  // namespace
}  // namespace berm::bodies::this_file
