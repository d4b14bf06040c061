// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/bodies/rigid/triangulated_overlaps_test.cpp
#include "bodies/rigid/surface_overlaps.hpp"

#include "bodies/rigid/fault_count.hpp"
#include "bodies/rigid/triangle_boxes.hpp"
#include "bodies/rigid/triangle_pairs.hpp"
#include "os/interrupt.hpp"

#include <Eigen/Dense>
#include <optional>
#include <random>

namespace berm::bodies {
namespace {

// Of the size. Points of a binary STL file are rounded to 6e-8 of their coordinates.
constexpr Real rounding = 3e-7;
constexpr BigIndex most_pairs = 1'000'000'000;

Real area_of_boxes(const Triangles& t)
{
  Real area = 0;
  for (const auto& corners : t.corners) {
    const Vec<3> sides = box_of(t, corners).sizes();
    area += sides[0] * sides[1] + sides[1] * sides[2] + sides[2] * sides[0];
  }
  return area;
}

/// The triangles in their axes of inertia where their boxes are smaller there: a long pipe is along an axis then, whatever its direction.
Triangles well_aligned(const Triangles& t)
{
  const Contents contents = contents_of(t);
  Triangles along = t, turned = t;
  for (Vec<3>& x : along.points) x -= contents.center;
  for (Vec<3>& x : turned.points) x = contents.axes.transpose() * (x - contents.center);
  return area_of_boxes(turned) < area_of_boxes(along) ? turned : along;
}

/// Where triangles meet others, and how often surfaces surround a point.
class Overlaps {
public:
  Overlaps(const Triangles& original, const std::vector<Index>& surface_of, Real size)
      : original_(original),
        t_(well_aligned(original)),
        surface_of_(surface_of),
        tolerance_(rounding * size),
        boxes_(boxes_of(t_)),
        touched_(t_.corners.size(), 0)
  {
    facets_.reserve(t_.corners.size());
    for (const auto& [a, b, c] : t_.corners) facets_.push_back(facet_of(t_.points[a], t_.points[b], t_.points[c]));
    sign_ = contents_of(t_).volume < 0 ? -1 : 1;
  }

  std::string fault()
  {
    compare_pairs();
    if (cut_.count > 0)
      return cut_.words("pair of triangles that cut through each other", "pairs of triangles that cut through each other");
    if (lying_.count > 0)
      return lying_.words("pair of triangles that lie on each other over an area",
                          "pairs of triangles that lie on each other over an area");
    if (pairs_ > most_pairs)
      return fmt::format(
          "has triangles so long and thin that more than {} pairs of them lie side by side, too many to compare: divide them", most_pairs);
    look_at_windings();
    if (twice_.count > 0)
      return twice_.words("closed surface within another, so that its volume counts twice (that of a cavity faces inwards)",
                          "closed surfaces within others, so that their volume counts twice (those of cavities face inwards)");
    return inwards_.words("closed surface that faces inwards and is not a cavity of another",
                          "closed surfaces that face inwards and are not cavities of others");
  }

private:
  Vec<3> middle_of(Index triangle) const
  {
    const auto& [a, b, c] = original_.corners[triangle];
    return (original_.points[a] + original_.points[b] + original_.points[c]) / 3;
  }

  void compare(Index one, Index other)
  {
    const auto &corners = t_.corners[one], &others = t_.corners[other];
    std::array<Index, 3> shared;
    for (int k = 0; k < 3; ++k) {
      const auto found = std::find(others.begin(), others.end(), corners[k]);
      shared[k] = found == others.end() ? none : static_cast<Index>(found - others.begin());
    }
    switch (intersection_of(facets_[one], facets_[other], shared, tolerance_)) {
    case Intersection::apart:
      break;
    case Intersection::touch:
      touched_[one] = touched_[other] = 1;
      break;
    case Intersection::cut:
      cut_.add(middle_of(one));
      break;
    case Intersection::overlap:
      lying_.add(middle_of(one));
    }
  }

  void compare_pairs()
  {
    struct Search {
      Overlaps& here;
      Index triangle;
      AlignedBox box;

      bool intersectVolume(const AlignedBox& volume) const { return volume.intersects(box); }
      bool intersectObject(Index other) const
      {
        if (other <= triangle || !box_of(here.t_, here.t_.corners[other]).intersects(box)) return false;
        here.compare(triangle, other);
        return ++here.pairs_ > most_pairs;
      }
    };
    const Vec<3> margin = Vec<3>::Constant(tolerance_);
    for (Index n = 0; n < static_cast<Index>(facets_.size()) && pairs_ <= most_pairs; ++n) {
      stop_if_asked("triangles of a surface were compared");
      AlignedBox box = box_of(t_, t_.corners[n]);
      box.min() -= margin, box.max() += margin;
      Search search{*this, n, box};
      Eigen::BVIntersect(boxes_, search);
    }
  }

  /// How often the surfaces surround what lies at a triangle, outside of it: 0 where all is well. Along a line from a point of the triangle each triangle that it meets from
  /// within is one more, each from outside one less; another line is taken where one meets an edge.
  std::optional<int> windings_outside(Index triangle)
  {
    struct Search {
      const Overlaps& here;
      Index triangle;
      Vec<3> start, direction;
      int windings = 0;
      bool doubtful = false;

      bool intersectVolume(const AlignedBox& volume) const
      {
        Real from = 0, to = infinity;
        for (int d = 0; d < 3; ++d) {
          const Real one = (volume.min()[d] - start[d]) / direction[d], other = (volume.max()[d] - start[d]) / direction[d];
          from = std::max(from, std::min(one, other)), to = std::min(to, std::max(one, other));
        }
        return from <= to + here.tolerance_;
      }
      bool intersectObject(Index other)
      {
        if (other == triangle) return false;
        const Hit hit = hit_of(here.facets_[other], start, direction, here.tolerance_);
        if (hit.hit) windings += hit.out ? 1 : -1;
        return doubtful = hit.doubtful;
      }
    };
    const auto number = [&] { return static_cast<Real>(random_()) / static_cast<Real>(std::mt19937::max()); };
    const Facet& facet = facets_[triangle];
    constexpr int most_lines = 50;
    for (int line = 0; line < most_lines; ++line) {
      const Real one = 0.2 + 0.3 * number(), other = 0.2 + 0.3 * number();
      const Vec<3> start = facet.corners[0] + one * (facet.corners[1] - facet.corners[0]) + other * (facet.corners[2] - facet.corners[0]);
      // Across the shortest side of most bodies: along a pipe it would meet more boxes.
      const Vec<3> direction = Vec<3>(0.1 + 0.3 * number(), 0.1 + 0.3 * number(), 1).normalized();
      if (std::abs(direction.dot(facet.normal)) < 1e-3) continue;
      Search search{*this, triangle, start, direction};
      Eigen::BVIntersect(boxes_, search);
      if (search.doubtful) continue;
      const bool from_outside = direction.dot(facet.normal) > 0;
      return sign_ > 0 ? search.windings - (from_outside ? 0 : 1) : -search.windings - (from_outside ? 1 : 0);
    }
    return std::nullopt;
  }

  /// Without triangles that cut, what lies outside of a surface is alike at all of its triangles, but where others touch it.
  void look_at_windings()
  {
    std::vector<char> is_told(facets_.size(), 0);
    for (Index n = 0; n < static_cast<Index>(facets_.size()); ++n) {
      const Index surface = surface_of_[n];
      if (is_told[surface] || (surface != n && !touched_[n])) continue;
      stop_if_asked("surfaces within others were looked for");
      const std::optional<int> windings = windings_outside(n);
      if (!windings || *windings == 0) continue;
      is_told[surface] = 1;
      (*windings > 0 ? twice_ : inwards_).add(middle_of(n));
    }
  }

  const Triangles& original_;
  Triangles t_;
  const std::vector<Index>& surface_of_;
  Real tolerance_;  ///< m
  int sign_ = 1;    ///< -1: all of it is turned the other way round
  TriangleBoxes boxes_;
  std::vector<char> touched_;
  std::vector<Facet> facets_;
  std::mt19937 random_{1};
  BigIndex pairs_ = 0;
  FaultCount cut_, lying_, twice_, inwards_;
};

}  // namespace

std::string overlaps_of(const Triangles& triangles, const std::vector<Index>& surface_of, Real size)
{
  return Overlaps(triangles, surface_of, size).fault();
}

}  // namespace berm::bodies
