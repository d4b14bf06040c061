// SPDX-License-Identifier: BSD-3-Clause
#include "contact/footprint.hpp"

#include "contact/detect.hpp"
#include "core/ranks.hpp"

#include <algorithm>
#include <tuple>

namespace berm::contact {
namespace {

/// Two neighbours share a border where their distance along the surface is less than the sum of their widths.
void meet(Footprint<2>& left, Footprint<2>& right, Real distance)
{
  const Real widths = left.width + right.width;
  if (!(distance < widths)) return;
  left.right = distance * left.width / widths;
  right.left = distance * right.width / widths;
}

/// In axisymmetry a particle that is first or last on its side meets its own mirror image: it ends at the axis, and reaches it where it is nearer than its width.
void meet_axis(const Footprint<2>& f, bool first, bool last, Real& from, Real& to)
{
  if (f.x_slope == 0) return;
  const Real to_axis = f.x / std::abs(f.x_slope), axis = f.along - f.x / f.x_slope;
  const bool reaches = to_axis < f.width;
  if (f.x_slope > 0) from = first && reaches ? std::max(axis, f.begin) : std::max(from, axis);
  if (f.x_slope < 0) to = last && reaches ? std::min(axis, f.end) : std::min(to, axis);
}

}  // namespace

int face_of(const Vec<2>& normal, Real angle)
{
  const Real c = std::cos(angle), s = std::sin(angle), along = c * normal[0] + s * normal[1], across = c * normal[1] - s * normal[0];
  if (std::abs(along) > std::abs(across)) return along > 0 ? 0 : 1;
  return across > 0 ? 2 : 3;
}

void find_footprints(const mesh::Mesh<2>& mesh, const bodies::Particles<2>& particles, const bodies::RigidShape<2>& shape, Real angle,
                     ContactPoints<2>& found)
{
  std::vector<Footprint<2>>& list = found.footprints;
  list.clear();
  list.reserve(found.list.capacity());
  for (std::size_t k = 0; k < found.near_cells.size(); ++k) {
    if (!(found.cells[k].gap < found.cells[k].half_width)) continue;
    const Index cell = found.near_cells[k];
    const mesh::Shape<2> functions = mesh.shape(cell);
    for (const auto& [p, b, count] : particles.blocks_in(cell))
      for (int l = 0; l < count; ++l) {
        const Vec<2> x(p.x[0][l], p.x[1][l]);
        const Real half = half_width<2>(section_of(mesh.metric, p.volume[l], x));
        const auto add = [&](int side, const bodies::OnSide& at) {
          if (at.away < -half || at.away >= 2 * half || at.along < at.begin - half || at.along > at.end + half) return;
          Footprint<2> footprint;
          footprint.nodes = mesh.nodes[cell];
          for (int n = 0; n < 3; ++n) footprint.weights[n] = functions.value(n, x);
          footprint.node_count = 3;
          footprint.side = side;
          if (found.faces > 1) footprint.face = face_of(at.normal, angle);
          footprint.along = at.along;
          footprint.begin = at.begin;
          footprint.end = at.end;
          footprint.width = 2 * half;
          footprint.left = footprint.right = half;
          footprint.x = at.x;
          footprint.x_slope = at.x_slope;
          list.push_back(footprint);
        };
        std::visit([&](const auto& s) { visit_sides(s, x, add); }, shape);
      }
  }
  if (Ranks::of_run().divided()) Ranks::of_run().gather(std::vector(list), list);
  const auto position = [](const Footprint<2>& f) { return std::tie(f.side, f.along, f.width, f.nodes, f.weights); };
  std::sort(list.begin(), list.end(), [&](const Footprint<2>& a, const Footprint<2>& b) { return position(a) < position(b); });
  for (std::size_t k = 1; k < list.size(); ++k)
    if (list[k].side == list[k - 1].side) meet(list[k - 1], list[k], list[k].along - list[k - 1].along);
  const Real around = std::visit([](const auto& s) { return closes_after(s); }, shape);
  if (around < infinity && list.size() > 1) meet(list.back(), list.front(), list.front().along + around - list.back().along);
  for (std::size_t k = 0; k < list.size(); ++k) {
    Footprint<2>& f = list[k];
    Real from = std::max(f.along - f.left, f.begin), to = std::min(f.along + f.right, f.end);
    if (mesh.metric == mesh::Metric::axisymmetric) {
      const bool first = k == 0 || list[k - 1].side != f.side, last = k + 1 == list.size() || list[k + 1].side != f.side;
      meet_axis(f, first, last, from, to);
      const Real radius = f.x + f.x_slope * ((from + to) / 2 - f.along);
      f.area = std::max((to - from) * radius, Real(0));
    } else {
      f.area = std::max(to - from, Real(0));
    }
  }
}

namespace {

/// Calls visit(node, N) for the nodes of a contact point or a footprint.
template <class At, class Visit>
void for_nodes(const At& at, const Visit& visit)
{
  for (int n = 0; n < at.node_count; ++n) visit(at.nodes[n], at.weights[n]);
}

}  // namespace

template <int dim>
void share_surface(ContactPoints<dim>& points)
{
  const auto closed = [](const ContactPoint<dim>& point) { return point.bonded || point.impulse.dot(point.normal) > 0; };
  bool same = points.shared_out, any = false;
  points.closed.resize(points.list.size());
  for (std::size_t k = 0; k < points.list.size(); ++k) {
    const char now = closed(points.list[k]) ? 1 : 0;
    same = same && points.closed[k] == now;
    any = any || now != 0;
    points.closed[k] = now;
  }
  if (same) return;
  points.shared_out = true;
  const auto presses = [&](const ContactPoint<dim>& point) { return !any || closed(point); };

  NodeField<Real>&area = points.node_area, &weight = points.node_weight;
  for (int face = 0; face < points.faces; ++face) {
    for (const ContactPoint<dim>& point : points.list) for_nodes(point, [&](Index i, Real) { area[i] = weight[i] = 0; });
    for (const Footprint<dim>& f : points.footprints) for_nodes(f, [&](Index i, Real) { area[i] = weight[i] = 0; });
    for (const ContactPoint<dim>& point : points.list)
      if (point.face == face && presses(point)) for_nodes(point, [&](Index i, Real N) { weight[i] += N; });
    for (const Footprint<dim>& f : points.footprints) {
      if (f.face != face) continue;
      Real reached = 0;
      for_nodes(f, [&](Index i, Real N) { reached += weight[i] > 0 ? N : 0; });
      if (reached > 0) for_nodes(f, [&](Index i, Real N) { area[i] += weight[i] > 0 ? f.area * N / reached : 0; });
    }
    for (ContactPoint<dim>& point : points.list) {
      if (point.face != face) continue;
      point.area = 0;
      if (presses(point)) for_nodes(point, [&](Index i, Real N) { point.area += weight[i] > 0 ? area[i] * N / weight[i] : 0; });
    }
  }
}

template <int dim>
void find_water_fractions(ContactPoints<dim>& points, const mesh::Mesh<dim>& mesh)
{
  if (points.node_area.size() == 0) points.node_area = points.node_weight = NodeField<Real>::zeros(mesh.node_count());
  NodeField<Real>&water = points.node_area, &total = points.node_weight;
  for (const ContactPoint<dim>& point : points.list) for_nodes(point, [&](Index i, Real) { water[i] = total[i] = 0; });
  for (const ContactPoint<dim>& point : points.list)
    if (point.touching)
      for_nodes(point, [&](Index i, Real N) {
        water[i] += N * point.pore_pressure;
        total[i] += N * point.soil_pressure;
      });
  for (ContactPoint<dim>& point : points.list) {
    point.water_fraction = 0;
    for_nodes(point, [&](Index i, Real N) {
      if (water[i] > 0) point.water_fraction += N * (total[i] > water[i] ? water[i] / total[i] : 1);
    });
  }
}

template void find_water_fractions(ContactPoints<2>&, const mesh::Mesh<2>&);
template void find_water_fractions(ContactPoints<3>&, const mesh::Mesh<3>&);
template void share_surface(ContactPoints<2>&);
template void share_surface(ContactPoints<3>&);

}  // namespace berm::contact
