// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/contact_point.hpp"
#include "core/ranks.hpp"
#include "core/select.hpp"

namespace berm::contact {

/// Puts near_cells, which ascend, in the order of strips: runs of 32 that follow each other along the space-filling curve of the mesh. Each strip gets the first colour of which no
/// strip before it shares a node with it, and strips of one colour come together. Corrections of particles found in this order do not depend on the number of threads.
template <int dim>
void order_by_strips(const mesh::Mesh<dim>& mesh, ContactPoints<dim>& found);

/// Memory for so many points, so that a step allocates none.
template <int dim>
void reserve(ContactPoints<dim>& found, Index points);

/// Makes strips of points that are a node each and share none with each other: equally long, all of one colour.
template <int dim>
void set_strips_of_nodes(ContactPoints<dim>& found);

/// Lists as points the candidates for which `keep` is true, each a node.
template <int dim, class Keep>
void keep_candidates(ContactPoints<dim>& found, const Keep& keep)
{
  select(
      "contact: select", static_cast<Index>(found.candidates.size()), [&](Index k) { return keep(found.candidates[k]); }, found.kept);
  found.list.resize(found.kept.size());
  for_each("contact: select", static_cast<Index>(found.kept.size()), [&](Index k) { found.list[k] = found.candidates[found.kept[k]]; });
  set_strips_of_nodes(found);
}

/// Gives all ranks what the owners of points that are particles know of them: get(point, T&) is called for a rank's own, set(T, point) for the others.
template <class T, int dim, class Get, class Set>
void share_points(ContactPoints<dim>& points, const Get& get, const Set& set)
{
  Ranks::of_run().share<T>(
      static_cast<Index>(points.list.size()), [&](Index p) { return points.owner[p]; },
      [&](Index p, T& value) { get(points.list[p], value); }, [&](Index p, const T& value) { set(value, points.list[p]); });
}

/// Below so many points one thread is faster than several that wait for each other.
constexpr Index min_points_for_threads = 128;

/// Calls body(strip) for all strips, by all threads of the parallel region that this is called in, colour after colour. A thread does strips that follow each other and hold its share of
/// the points, so that from colour to colour it stays where it is in space.
template <int dim, class Body>
void for_each_strip(const ContactPoints<dim>& points, const Body& body)
{
  const BigIndex threads = omp_get_num_threads(), thread = omp_get_thread_num();
  for (std::size_t c = 0; c + 1 < points.color_begin.size(); ++c) {
    const auto first = points.strip_begin.begin() + points.color_begin[c], last = points.strip_begin.begin() + points.color_begin[c + 1];
    const BigIndex count = *last - *first;
    if (count == 0) continue;
    // The strips that begin in this thread's share; those without points begin where the next does.
    const auto strip_at = [&](BigIndex part) { return std::lower_bound(first, last, static_cast<Index>(*first + part * count / threads)); };
    for (auto strip = strip_at(thread), end = strip_at(thread + 1); strip != end; ++strip)
      body(static_cast<Index>(strip - points.strip_begin.begin()));
#pragma omp barrier
  }
}

/// Calls body(point) for all points; what it does to the point's nodes is done by no other at the same time, and in the same order on any number of threads.
template <class Points, class Body>
void for_each_point(Points& points, const Body& body)
{
  const bool many = static_cast<Index>(points.list.size()) >= min_points_for_threads;
#pragma omp parallel if (many)
  for_each_strip(points, [&](Index s) {
    for (Index k = points.strip_begin[s]; k < points.strip_begin[s + 1]; ++k) body(points.list[k]);
  });
}

}  // namespace berm::contact
