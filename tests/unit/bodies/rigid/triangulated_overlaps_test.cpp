// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid/rigid_body.hpp"
#include "bodies/rigid/triangle_faults.hpp"
#include "bodies/rigid/triangle_file.hpp"
#include "os/error.hpp"
#include "os/interrupt.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>

namespace berm::bodies::this_file {
namespace {

/// A prism over a square, whose sides have rings of points at these heights, from the lowest.
Triangles tower(const Vec<3>& lower, Real width, const std::vector<Real>& heights)
{
  Triangles t;
  for (const Real z : heights)
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      t.points.emplace_back(lower[0] + width * x, lower[1] + width * y, z);
  const Index top = 4 * static_cast<Index>(heights.size() - 1);
  const auto square = [&](Index a, Index b, Index c, Index d) { t.corners.push_back({a, b, c}), t.corners.push_back({a, c, d}); };
  for (Index level = 0; level < top; level += 4)
    for (Index k = 0; k < 4; ++k) square(level + k, level + (k + 1) % 4, level + 4 + (k + 1) % 4, level + 4 + k);
  square(0, 3, 2, 1);
  square(top, top + 1, top + 2, top + 3);
  return t;
}

Triangles cube(const Vec<3>& lower, Real width)
{
  return tower(lower, width, {lower[2], lower[2] + width});
}

Triangles both(Triangles t, const Triangles& other)
{
  const Index first = static_cast<Index>(t.points.size());
  t.points.insert(t.points.end(), other.points.begin(), other.points.end());
  for (const auto& [a, b, c] : other.corners) t.corners.push_back({a + first, b + first, c + first});
  return t;
}

Triangles inside_out(Triangles t)
{
  for (auto& corners : t.corners) std::swap(corners[1], corners[2]);
  return t;
}

/// Turned about the origin.
Triangles turned(Triangles t, const std::vector<Real>& angles)
{
  for (Vec<3>& x : t.points) x = turned_about_axes(angles) * x;
  return t;
}

/// As a binary STL file has it: with points of seven digits.
Triangles rounded(Triangles t)
{
  for (Vec<3>& x : t.points)
    for (Real& number : x) number = static_cast<float>(number);
  return t;
}

const Triangles outer = cube({0, 0, 0}, 1);

struct Sample {
  const char* what;
  Triangles triangles;
  std::string fault;  ///< a part of the message; "" where there is none
};

std::vector<Sample> samples()
{
  const std::string on_each_other = "that lie on each other over an area", twice = "so that its volume counts twice",
                    inwards = "that faces inwards and is not a cavity";
  return {
      {"overlap with coplanar sides", both(outer, cube({0.5, 0, 0}, 1)), on_each_other},
      {"one within the other, with a side in common", both(outer, cube({0.3, 0.3, 0}, 0.4)), on_each_other},
      {"one on the other", both(outer, cube({0.3, 0.3, 1}, 0.4)), on_each_other},
      {"a cavity that reaches a side", both(outer, inside_out(cube({0.3, 0.3, 0}, 0.4))), on_each_other},
      {"one within the other", both(outer, cube({0.3, 0.3, 0.3}, 0.4)), twice},
      {"two within another", both(both(outer, cube({0.2, 0.2, 0.2}, 0.2)), cube({0.6, 0.6, 0.6}, 0.2)), "2 closed surfaces within others"},
      {"a cavity within a cavity", both(outer, both(inside_out(cube({0.2, 0.2, 0.2}, 0.6)), inside_out(cube({0.4, 0.4, 0.4}, 0.2)))),
       inwards},
      {"one that faces inwards beside another", both(outer, inside_out(cube({2, 0, 0}, 0.5))), inwards},
      {"a tower through a plate whose points lie on its sides",
       both(tower({-2, -2, 0}, 4, {0, 1}), tower({0.2, 0.1, -1}, 0.5, {-1, 0, 1, 2})), "counts twice"},
      {"one turned into the other", both(outer, turned(cube({0.1, 0.1, 0.1}, 1), {0.1, 0.2, 0.3})), "that cut through each other"},
      {"a cavity", both(outer, inside_out(cube({0.3, 0.3, 0.3}, 0.4))), ""},
      {"a body within a cavity", both(outer, both(inside_out(cube({0.2, 0.2, 0.2}, 0.6)), cube({0.4, 0.4, 0.4}, 0.2))), ""},
      {"one beside the other", both(outer, cube({1.001, 0, 0}, 1)), ""},
      {"one at a part of the other's edge", both(outer, cube({1, 1, 0.25}, 0.5)), ""},
      {"one at a corner of the other", both(outer, cube({1, 1, 1}, 0.5)), ""},
      {"one that stands on the other with an edge", both(cube({-1, -1, -2}, 2), turned(cube({-0.5, 0, 0}, 1), {pi / 4, 0, 0})), ""},
  };
}

TEST(Overlaps, are_found_in_any_direction_and_with_seven_digits)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> angle(-pi, pi);
  for (const Sample& sample : samples())
    for (int n = 0; n < 40; ++n) {
      Triangles t = sample.triangles;
      if (n > 0) t = turned(t, {angle(random), angle(random), angle(random)});
      if (n % 2 == 1) t = rounded(t);
      if (n % 3 == 2) t = inside_out(t);
      const std::string fault = fault_of(t);
      if (sample.fault.empty())
        EXPECT_EQ(fault, "") << sample.what << ", " << n;
      else
        EXPECT_NE(fault.find(sample.fault), std::string::npos) << sample.what << ", " << n << ": " << fault;
    }
}

TEST(Overlaps, are_told_with_their_number_and_a_place)
{
  EXPECT_EQ(fault_of(both(outer, cube({0.3, 0.3, 0.3}, 0.4))), "1 closed surface within another, so that its volume counts twice (that of "
                                                               "a cavity faces inwards), such as at (0.566667, 0.3, 0.433333) m");
  EXPECT_EQ(fault_of(both(outer, inside_out(cube({2, 0, 0}, 0.5)))),
            "1 closed surface that faces inwards and is not a cavity of another, such as at (2.33333, 0, 0.166667) m");
  EXPECT_EQ(fault_of(both(outer, cube({0.5, 0, 0}, 1))).substr(0, 72),
            "12 pairs of triangles that lie on each other over an area, such as at (0");
}

TEST(Overlaps, of_a_cavity_are_none_and_it_lies_outside_of_the_body)
{
  const Triangles t = both(outer, inside_out(cube({0.3, 0.3, 0.3}, 0.4)));
  const Contents contents = contents_of(t);
  EXPECT_NEAR(contents.volume, 1 - 0.064, 1e-15);
  EXPECT_NEAR(contents.inertia[0], (1 - 0.064 * 0.16) / 6 / (1 - 0.064), 1e-15);
  const TriangleMesh mesh{Triangles(t)};
  EXPECT_NEAR(mesh.surface_at(Vec<3>(0.5, 0.5, 0.6)).distance, 0.1, 1e-15);
  EXPECT_NEAR(mesh.surface_at(Vec<3>(0.5, 0.5, 0.8)).distance, -0.1, 1e-15);
}

/// How reading a file that is written so ends.
std::string reading_of(const std::string& name, const std::string& text)
{
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / name;
  std::ofstream(file, std::ios::binary) << text;
  try {
    return fmt::format("{} triangles", read_triangles(file).corners.size());
  } catch (const InputError& error) {
    const std::string message = error.what();
    return message.substr(message.find(name));
  }
}

TEST(TriangleFiles, may_have_numbers_with_a_plus)
{
  EXPECT_EQ(reading_of("plus.obj", "v +1.0 +2e0 -0\nv 0 0 0\nv 0 +.5 0\nf 1 2 3\n"), "1 triangles");
  EXPECT_EQ(reading_of("sign.obj", "v +-1.0 0 0\n"), "sign.obj:1: needs three numbers after \"v\"");
  EXPECT_EQ(reading_of("alone.obj", "v + 0 0\n"), "alone.obj:1: needs three numbers after \"v\"");
}

TEST(TriangleFiles, leave_out_points_of_no_triangle)
{
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "spare.obj";
  std::ofstream(file) << "v 0 0 0\nv 0 -9 0\nv 1 0 0\nv 0 0 1\nf 1 3 4\n";
  EXPECT_EQ(read_triangles(file).points.size(), 3u);
}

TEST(TriangleFiles, say_no_word_of_a_file_that_moves_a_cursor)
{
  EXPECT_EQ(reading_of("word.obj", "v 0 0 0\nf \x1b[2J 1 1\n"),
            "word.obj:2: \" [2J\" is not a vertex before this line, which has 1 of them");
  EXPECT_EQ(reading_of("more.stl", "solid\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0\n"),
            "more.stl:5: a facet of an STL file has three vertices, and this one more");
}

TEST(TriangleFiles, of_too_many_triangles_are_refused_before_they_are_read)
{
  constexpr std::uint32_t count = 2'000'001;
  std::string head(80, ' ');
  head.append(reinterpret_cast<const char*>(&count), sizeof count);
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "many.stl";
  std::ofstream(file, std::ios::binary) << head;
  std::filesystem::resize_file(file, head.size() + std::uintmax_t(50) * count);
  try {
    read_triangles(file);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("many.stl: has more than 2000000 triangles"), std::string::npos) << error.what();
  }
  std::filesystem::remove(file);
}

TEST(TriangleFilesDeathTest, stop_at_a_signal)
{
  const auto stopped = [](auto&& work) {
    catch_interrupts();
    std::raise(SIGTERM);
    try {
      work();
    } catch (const Interrupted& error) {
      fmt::print(stderr, "{}", error.what());
      std::exit(75);
    }
    std::exit(0);
  };
  EXPECT_EXIT(stopped([] { fault_of(outer); }), testing::ExitedWithCode(75), "stopped while triangles of a surface were compared");
  EXPECT_EXIT(stopped([] { TriangleMesh{Triangles(outer)}; }), testing::ExitedWithCode(75),
              "stopped while distances from a surface were prepared");
  EXPECT_EXIT(stopped([] { reading_of("stopped.obj", "v 0 0 0\nf 1 1 1\n"); }), testing::ExitedWithCode(75),
              "stopped while the triangles of a surface were read");
}

}  // namespace
}  // namespace berm::bodies::this_file
