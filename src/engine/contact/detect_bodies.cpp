// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/particle_position.hpp"
#include "contact/detect.hpp"
#include "contact/strips.hpp"
#include "core/ranks.hpp"

#include <Eigen/Geometry>

namespace berm::contact {
namespace {

/// Extent of the particles in a node's cells along a direction, m from the node: of their centres, or (with their half widths) of their
/// rims.
template <int dim>
Real reach(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Index node, const Vec<dim>& direction, bool rims)
{
  const Vec<dim>& at = mesh.position[node];
  Lanes farthest = all_lanes(-infinity);
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
    const Index cell = mesh.entries[e] / (dim + 1);
    for (const auto& [p, b, count] : particles.blocks_in(cell)) {
      Lanes along = direction[0] * (p.x[0] - at[0]);
      for (int d = 1; d < dim; ++d) along += direction[d] * (p.x[d] - at[d]);
      if (rims)
        for (int l = 0; l < count; ++l) along[l] += half_width<dim>(section_of(mesh.metric, p.volume[l], position_of(p, l)));
      farthest = lane_numbers < all_lanes(count) ? larger(farthest, along) : farthest;
    }
  }
  Real max = farthest[0];
  for (int l = 1; l < lanes; ++l) max = std::max(max, farthest[l]);
  return max;
}

/// The particles of two bodies around a node, and the gap between them along a direction n out of `other`.
template <int dim>
struct NodeNeighbourhood {
  const mesh::Mesh<dim>& mesh;
  const bodies::Particles<dim>&body, &other;
  Index node;

  Real gap(const Vec<dim>& n, bool rims) const { return -reach<dim>(mesh, body, node, -n, rims) - reach(mesh, other, node, n, rims); }

  /// The direction along which the centres of the two bodies' particles are farthest apart: for two convex clouds, that of
  /// the shortest line between them. A coarse search over all directions, refined by golden sections (in space: about two
  /// axes in turn).
  Vec<dim> max_gap_direction() const
  {
    Vec<dim> best = Vec<dim>::Zero();
    Real max = -infinity;
    const auto attempt = [&](Vec<dim> n) {
      n.normalize();
      if (const Real wide = gap(n, false); wide > max) max = wide, best = n;
    };
    if constexpr (dim == 2) {
      for (int k = 0; k < 16; ++k) attempt(Vec<2>(std::cos(k * pi / 8), std::sin(k * pi / 8)));
    } else {
      for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
          for (int x = -1; x <= 1; ++x)
            if (x != 0 || y != 0 || z != 0) attempt(Vec<3>(x, y, z));
    }
    const Real reach = dim == 2 ? pi / 8 : pi / 4;
    for (int turn = 0; turn < (dim == 2 ? 1 : 4); ++turn) best = refine_by_golden_section(best, turn, reach);
    return best;
  }

  Vec<dim> refine_by_golden_section(const Vec<dim>& n, int turn, Real max_angle) const
  {
    constexpr Real golden = 0.6180339887498949, narrow = 1e-3;
    Vec<dim> side;
    if constexpr (dim == 2) {
      side = Vec<2>(-n[1], n[0]);
    } else {
      const Vec<3> across = n.unitOrthogonal();
      side = turn % 2 == 0 ? across : Vec<3>(n.cross(across));
    }
    const auto rotated = [&](Real angle) { return Vec<dim>(std::cos(angle) * n + std::sin(angle) * side); };
    Real from = -max_angle, to = max_angle;
    Real a = to - golden * (to - from), b = from + golden * (to - from), at_a = gap(rotated(a), false), at_b = gap(rotated(b), false);
    while (to - from > narrow) {
      if (at_a > at_b) {
        to = b, b = a, at_b = at_a;
        a = to - golden * (to - from), at_a = gap(rotated(a), false);
      } else {
        from = a, a = b, at_a = at_b;
        b = from + golden * (to - from), at_b = gap(rotated(b), false);
      }
    }
    return rotated(0.5 * (from + to)).normalized();
  }
};

}  // namespace

template <int dim>
void detect(const mesh::Mesh<dim>& mesh, const BodyView<dim>& body, const BodyView<dim>& other, Detection detection,
            ContactPoints<dim>& found)
{
  if (found.candidates.capacity() == 0) {
    found.candidate_nodes.reserve(mesh.node_count());
    found.candidates.reserve(mesh.node_count());
    found.kept.reserve(mesh.node_count());
    reserve(found, mesh.node_count());
  }
  Ranks& ranks = Ranks::of_run();
  const auto is_shared = [&](Index k) {
    return body.mass[body.nodes[k]] > 0 && other.mass[body.nodes[k]] > 0 && ranks.owns_node(body.nodes[k]);
  };
  select("contact: two bodies", static_cast<Index>(body.nodes.size()), is_shared, found.candidate_nodes);
  found.candidates.resize(found.candidate_nodes.size());
  for_each("contact: two bodies", static_cast<Index>(found.candidates.size()), [&](Index k) {
    const Index node = body.nodes[found.candidate_nodes[k]];
    ContactPoint<dim> point;
    point.nodes[0] = node;
    point.weights[0] = 1;
    point.position = mesh.position[node];
    const NodeNeighbourhood<dim> neighbourhood{mesh, body.particles, other.particles, node};
    point.normal = neighbourhood.max_gap_direction();
    point.gap = neighbourhood.gap(point.normal, true);
    point.distance = neighbourhood.gap(point.normal, false);
    const Real width = point.distance - point.gap;  // half a particle of each
    point.touching = point.gap < 0.5 * width;
    if (detection == Detection::overlap) point.gap = 0, point.touching = true;
    found.candidates[k] = point;
  });
  if (ranks.divided()) ranks.gather(std::vector(found.candidates), found.candidates);  // ascending, as ranks have ranges of nodes
  keep_candidates(found, [&](const ContactPoint<dim>& point) { return detection != Detection::distance || point.gap <= 0; });
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void detect(const mesh::Mesh<dim>&, const BodyView<dim>&, const BodyView<dim>&, Detection, ContactPoints<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::contact
