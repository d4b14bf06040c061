// SPDX-License-Identifier: BSD-3-Clause
#include "contact/detect.hpp"
#include "core/for_each.hpp"

namespace berm {
namespace {

/// sum V grad N of a node over the cells of one body: along the body's outward normal there, and vanishing inside. m2 (per metre run: m)
template <int dim>
Vec<dim> volume_gradient(const Mesh<dim>& mesh, const Particles<dim>& particles, Index node)
{
  Vec<dim> gradient = Vec<dim>::Zero();
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
    const Index cell = mesh.entries[e] / (dim + 1), corner = mesh.entries[e] % (dim + 1);
    Lanes volume{};
    Index left = particles.count_in(cell);
    for (Index b = particles.first_block(cell); left > 0; b = particles.block(b).next, left -= lanes) volume += particles.block(b).volume;
    gradient += sum(volume) * mesh.shape[cell].gradient(corner);
  }
  return gradient;
}

/// How far the particles in a node's cells reach along a direction: their centres, or (with their half widths) their rims. m
template <int dim>
Real reach(const Mesh<dim>& mesh, const Particles<dim>& particles, Index node, const Vec<dim>& direction, bool rims)
{
  Lanes farthest = all_lanes(-infinity);
  for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
    const Index cell = mesh.entries[e] / (dim + 1);
    Index left = particles.count_in(cell);
    for (Index b = particles.first_block(cell); left > 0; b = particles.block(b).next, left -= lanes) {
      const Block<dim>& p = particles.block(b);
      Lanes along = direction[0] * p.x[0];
      for (int d = 1; d < dim; ++d) along += direction[d] * p.x[d];
      if (rims)
        for (int l = 0; l < lanes; ++l) along[l] += half_width<dim>(p.volume[l]);
      farthest = lane_numbers < all_lanes(left) ? larger(farthest, along) : farthest;
    }
  }
  Real most = farthest[0];
  for (int l = 1; l < lanes; ++l) most = std::max(most, farthest[l]);
  return most;
}

/// The particles of two bodies around a node, and the gap between them as seen along a direction n out of `other`.
template <int dim>
struct Meeting {
  const Mesh<dim>& mesh;
  const Particles<dim>&body, &other;
  Index node;

  Real gap(const Vec<dim>& n, bool rims) const { return -reach<dim>(mesh, body, node, -n, rims) - reach(mesh, other, node, n, rims); }

  /// The direction along which the centres of the two bodies' particles are farthest apart, sought within 45 degrees of `start` by golden sections
  /// (in space: of two angles in turn). For two convex clouds the gap has one maximum, and their nearest points lie along it.
  Vec<dim> widest(Vec<dim> n) const
  {
    constexpr Real golden = 0.6180339887498949, narrow = 1e-3;
    for (int turn = 0; turn < (dim == 2 ? 1 : 4); ++turn) {
      Vec<dim> side = Vec<dim>::Unit(turn % dim);
      if constexpr (dim == 2) side = Vec<2>(-n[1], n[0]);
      side -= side.dot(n) * n;
      if (side.norm() < 0.1) continue;
      side.normalize();
      const auto turned = [&](Real angle) { return Vec<dim>(std::cos(angle) * n + std::sin(angle) * side); };
      Real from = -pi / 4, to = pi / 4;
      Real a = to - golden * (to - from), b = from + golden * (to - from), at_a = gap(turned(a), false), at_b = gap(turned(b), false);
      while (to - from > narrow) {
        if (at_a > at_b) {
          to = b, b = a, at_b = at_a;
          a = to - golden * (to - from), at_a = gap(turned(a), false);
        } else {
          from = a, a = b, at_a = at_b;
          b = from + golden * (to - from), at_b = gap(turned(b), false);
        }
      }
      n = turned(0.5 * (from + to)).normalized();
    }
    return n;
  }
};

}  // namespace

template <int dim>
void detect(const Mesh<dim>& mesh, const BodyView<dim>& body, const BodyView<dim>& other, Detection detection, ContactPoints<dim>& found)
{
  found.shared_nodes.clear();
  for (Index node : body.nodes)
    if (body.mass[node] > 0 && other.mass[node] > 0) found.shared_nodes.push_back(node);
  found.shared.resize(found.shared_nodes.size());
  for_each("contact: two bodies", static_cast<Index>(found.shared.size()), [&](Index k) {
    const Index node = found.shared_nodes[k];
    ContactPoint<dim> point;
    point.nodes[0] = node;
    point.weights[0] = 1;
    point.place = mesh.position[node];
    const Vec<dim> out_of_body = volume_gradient(mesh, body.particles, node), out_of_other = volume_gradient(mesh, other.particles, node);
    // The body whose surface fills more of the cells tells its direction best.
    const Vec<dim> start = out_of_body.squaredNorm() > out_of_other.squaredNorm() ? Vec<dim>(-out_of_body) : out_of_other;
    const Meeting<dim> meeting{mesh, body.particles, other.particles, node};
    if (start.norm() > 0) {
      point.normal = meeting.widest(start.normalized());
      point.gap = meeting.gap(point.normal, true);
      point.distance = meeting.gap(point.normal, false);
      const Real width = point.distance - point.gap;  // half a particle of each
      point.touching = point.gap < 0.5 * width;
    }
    if (detection == Detection::overlap) point.gap = 0, point.touching = true;
    found.shared[k] = point;
  });
  // Where a node has no direction to press in, both bodies fill its cells alike: they are mixed there already.
  found.list.clear();
  for (const ContactPoint<dim>& point : found.shared)
    if (!point.normal.isZero() && (detection != Detection::distance || point.gap <= 0)) found.list.push_back(point);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void detect(const Mesh<dim>&, const BodyView<dim>&, const BodyView<dim>&, Detection, ContactPoints<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm
