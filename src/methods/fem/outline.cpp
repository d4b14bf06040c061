// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/remesher_test.cpp
#include "fem/outline.hpp"

#include "fem/cut_mesh.hpp"

#include <algorithm>
#include <utility>

namespace berm::fem {
namespace {

constexpr int samples_of_side = 16;
constexpr Real small_gap = 1e-3;        // over the width: of such nodes
constexpr int open_within_contact = 2;  // nodes between closed ones that count as closed
constexpr Real kink = 40 * degree;      // between two sides of the ground: a corner that stays
constexpr Real closed_distance = 1e-4;  // over the width: of points between nodes in contact

/// The parabola through the values at the three nodes of a side; on a wall it stays on the wall to the last bit.
template <class T>
T on_side(const T& from, const T& middle, const T& to, Real part)
{
  return from + (middle - from) * (4 * part * (1 - part)) + (to - from) * (part * (2 * part - 1));
}

/// A point of a loop that was sampled, and the length of the loop up to it.
struct Sample {
  Vec<2> x;
  std::size_t side;
  Real part, length;
};

/// Divides one loop of sides.
class Divider {
public:
  Divider(const FemModel& model, const FemState& state, const ElementSizes& sizes)
      : model_(model),
        sizes_(sizes),
        position_(positions_with(model, state.displacement)),
        closed_(nodes_in_contact(model, state)),
        overlap_(model.mesh.node_count(), 0),
        poses_(poses_of(state))
  {
    if (model.contact_count() == 0) return;
    for (std::size_t k = 0; k < model.contact.size(); ++k)
      if (const Index node = model.contact[k].node; closed_[node]) overlap_[node] = -state.contact[k].gap;
    // A node on the axis has no contact point.
    for (const BoundarySide& side : model.contact_sides)
      for (const Index node : {side.from, side.to})
        if (is_on_axis(node)) closed_[node] = closed_[side.middle];
    for (const bodies::RigidShape<2>& shape : shapes_in_contact(model, state))
      if (const auto* profile = std::get_if<bodies::Profile<2>>(&shape))
        for (const Vec<2>& corner : corners_of(profile->core)) corners_.push_back(corner);
    for (const BoundarySide& side : model.mesh.boundary_sides)
      if (is_ground(model.model.mesh, side))
        for (const Index node : {side.from, side.middle, side.to})
          position_[node] = put_beside_body(position_[node], closed_[node] != 0, overlap_[node]);
  }

  /// `sides`: numbers of boundary sides, each of which begins where the one before ends, the first where the last ends.
  OutlineLoop divide(std::vector<std::size_t> sides)
  {
    close_small_gaps(sides);
    start_at_kept(sides);
    sample(sides);
    const std::vector<Real> kept = kept_lengths(sides);
    OutlineLoop loop;
    for (std::size_t k = 0; k + 1 < kept.size(); ++k) divide_piece(kept[k], kept[k + 1], loop);
    return loop;
  }

private:
  const BoundarySide& side(std::size_t k) const { return model_.mesh.boundary_sides[k]; }
  bool is_ground_at(std::size_t k) const { return is_ground(model_.model.mesh, side(k)); }
  NearestSurface nearest(const Vec<2>& x) const { return nearest_surface(model_, poses_, x); }
  Real distance(const Vec<2>& x) const { return nearest(x).distance; }

  /// `overlap`: m, of what is closed: the compression of its contact spring.
  Vec<2> put_beside_body(const Vec<2>& x, bool closed, Real overlap = 0) const
  {
    const NearestSurface surface = nearest(x);
    if (surface.contact == none || (!closed && surface.distance >= 0)) return x;
    Vec<2> beside = x - (surface.distance + overlap) * surface.normal;
    if (x[0] == 0 && model_.model.mesh.metric == mesh::Metric::axisymmetric) beside[0] = 0;
    return beside;
  }

  bool is_on_axis(Index node) const { return model_.model.mesh.metric == mesh::Metric::axisymmetric && model_.mesh.position[node][0] == 0; }

  void close_small_gaps(const std::vector<std::size_t>& sides)
  {
    std::vector<Index> nodes;
    for (const std::size_t k : sides) nodes.insert(nodes.end(), {side(k).from, side(k).middle});
    const std::size_t n = nodes.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t gap = 1; gap <= open_within_contact; ++gap)
        if (closed_[nodes[k]] && closed_[nodes[(k + gap + 1) % n]])
          for (std::size_t j = 1; j <= gap; ++j)
            if (Index node = nodes[(k + j) % n]; !closed_[node] && distance(position_[node]) < small_gap * model_.width) {
              closed_[node] = 1;
              position_[node] = put_beside_body(position_[node], true);
            }
  }

  /// Whether the corner at which a side begins after another must stay.
  bool stays(std::size_t before, std::size_t after) const
  {
    if (is_ground_at(before) != is_ground_at(after)) return true;
    if (!is_ground_at(after)) return side(before).boundary != side(after).boundary;
    const Vec<2> in = 3 * position_[side(before).to] - 4 * position_[side(before).middle] + position_[side(before).from],
                 out = 4 * position_[side(after).middle] - 3 * position_[side(after).from] - position_[side(after).to];
    const bool inside_contact = closed_[side(after).from] && closed_[side(before).middle] && closed_[side(after).middle];
    return !inside_contact && in.dot(out) < std::cos(kink) * in.norm() * out.norm();
  }

  void start_at_kept(std::vector<std::size_t>& sides) const
  {
    const std::size_t n = sides.size();
    for (std::size_t k = 0; k < n; ++k)
      if (stays(sides[(k + n - 1) % n], sides[k])) {
        std::rotate(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(k), sides.end());
        return;
      }
  }

  void sample(const std::vector<std::size_t>& sides)
  {
    samples_.clear();
    for (const std::size_t k : sides)
      for (int j = 0; j <= samples_of_side; ++j) {
        if (j == 0 && !samples_.empty()) continue;
        const Real part = static_cast<Real>(j) / samples_of_side;
        const Vec<2> x = on_side(position_[side(k).from], position_[side(k).middle], position_[side(k).to], part);
        samples_.push_back({x, k, part, samples_.empty() ? 0 : samples_.back().length + (x - samples_.back().x).norm()});
      }
  }

  /// Lengths at which corners stay: also where the contact begins and ends.
  std::vector<Real> kept_lengths(const std::vector<std::size_t>& sides)
  {
    edges_.clear();
    std::vector<Real> kept = {0};
    const std::size_t n = sides.size();
    const auto keep = [&](std::size_t sample, bool edge) {
      const Real length = samples_[sample].length;
      if (edge) edges_.push_back(samples_[sample].x);
      if (length > kept.back() && length < samples_.back().length) kept.push_back(length);
    };
    for (std::size_t k = 0; k < n; ++k) {
      const BoundarySide &now = side(sides[k]), &before = side(sides[(k + n - 1) % n]);
      const bool from = closed_[now.from], middle = closed_[now.middle], to = closed_[now.to];
      const bool ends_at_from = from && closed_[before.middle] != closed_[now.middle];
      if (ends_at_from || (k > 0 && stays(sides[k - 1], sides[k]))) keep(k * samples_of_side, ends_at_from);
      if (middle && from != to) keep(k * samples_of_side + samples_of_side / 2, true);
    }
    note_nearest();
    kept.push_back(samples_.back().length);
    return kept;
  }

  /// Where nothing is in contact with a body yet, what will be first.
  void note_nearest()
  {
    std::vector<Vec<2>> first;
    for (Index k = 0; k < model_.contact_count(); ++k) {
      if (std::ranges::any_of(edges_, [&](const Vec<2>& edge) { return nearest(edge).contact == k; })) continue;
      const auto away = [&](const Sample& sample) {
        return std::abs(surface_now(model_, k, poses_[model_.model.contacts[k].rigid], sample.x).distance);
      };
      const Sample& there = *std::ranges::min_element(samples_, {}, away);
      if (away(there) < sizes_.fine) first.push_back(there.x);
    }
    edges_.insert(edges_.end(), first.begin(), first.end());
  }

  Real size_at(const OutlinePoint& point) const
  {
    if (!is_ground_at(point.side)) return sizes_.at(distance(point.x));
    const auto from = [&](const std::vector<Vec<2>>& places) {
      Real nearest = infinity;
      for (const Vec<2>& place : places) nearest = std::min(nearest, (point.x - place).norm());
      return nearest;
    };
    return sizes_.of_side(distance(point.x), from(edges_), from(corners_));
  }

  bool in_contact(std::size_t k) const { return closed_[side(k).from] || closed_[side(k).middle] || closed_[side(k).to]; }

  OutlinePoint at_length(Real length) const
  {
    const auto after = std::lower_bound(samples_.begin() + 1, samples_.end() - 1, length,
                                        [](const Sample& sample, Real value) { return sample.length < value; });
    const Sample &b = *after, &a = *(after - 1);
    const Real step = b.length - a.length, fraction = step > 0 ? std::clamp((length - a.length) / step, Real(0), Real(1)) : 0;
    const Real first = a.side == b.side ? a.part : 0, part = first + fraction * (b.part - first);
    OutlinePoint point{on_side(position_[side(b.side).from], position_[side(b.side).middle], position_[side(b.side).to], part), b.side,
                       part};
    if (is_ground_at(b.side)) {
      const BoundarySide& of = side(b.side);
      const std::array<Real, 3> overlaps = {overlap_[of.from], overlap_[of.middle], overlap_[of.to]};
      const auto [least, most] = std::ranges::minmax(overlaps);
      const Real overlap = std::clamp(on_side(overlaps[0], overlaps[1], overlaps[2], part), least, most);
      point.x = put_beside_body(point.x, in_contact(b.side) && distance(point.x) < closed_distance * model_.width, overlap);
    }
    return point;
  }

  /// So that each side of a piece has its size: the integral of length over size is the same in all.
  void divide_piece(Real begin, Real end, OutlineLoop& loop) const
  {
    const int steps = std::max(50, static_cast<int>(16 * (end - begin) / sizes_.contact));
    const Real step = (end - begin) / steps;
    std::vector<Real> sum = {0};
    for (int k = 0; k < steps; ++k) sum.push_back(sum.back() + step / size_at(at_length(begin + (k + 0.5) * step)));
    const int count = std::max(1, static_cast<int>(std::lround(sum.back())));
    const auto division = [&](int k) {
      if (k == count) return end;
      const Real wanted = sum.back() * k / count;
      const auto after = std::upper_bound(sum.begin(), sum.end(), wanted);
      const auto j = after - sum.begin() - 1;
      return begin +
             step * (static_cast<Real>(j) + (wanted - sum[static_cast<std::size_t>(j)]) / (*after - sum[static_cast<std::size_t>(j)]));
    };
    Real from = begin;
    for (int k = 1; k <= count; ++k) {
      const Real to = division(k);
      const OutlinePoint middle = at_length((from + to) / 2);
      const bool ground = is_ground_at(middle.side), contact = ground && in_contact(middle.side);
      loop.push_back({at_length(from), middle, contact ? none : side(middle.side).boundary, ground && !contact});
      from = to;
    }
  }

  const FemModel& model_;
  const ElementSizes& sizes_;
  NodeField<Vec<2>> position_;
  NodeField<char> closed_;   ///< nodes in contact
  NodeField<Real> overlap_;  ///< m, of these: the compression of their springs; negative where tension stretches them
  std::vector<bodies::Pose<2>> poses_;
  std::vector<Sample> samples_;
  std::vector<Vec<2>> edges_;    ///< of the contact
  std::vector<Vec<2>> corners_;  ///< of the bodies
};

/// The boundary sides in their order, loop by loop.
std::vector<std::vector<std::size_t>> loops_of(const QuadraticMesh& mesh)
{
  NodeField<Index> next(mesh.node_count(), none);
  for (std::size_t k = 0; k < mesh.boundary_sides.size(); ++k) next[mesh.boundary_sides[k].from] = static_cast<Index>(k);
  std::vector<std::vector<std::size_t>> loops;
  for (const BoundarySide& first : mesh.boundary_sides) {
    std::vector<std::size_t> loop;
    for (Index node = first.from; next[node] != none; node = mesh.boundary_sides[loop.back()].to)
      loop.push_back(static_cast<std::size_t>(std::exchange(next[node], none)));
    if (!loop.empty()) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace

void straighten(OutlineLoop& loop, std::size_t side)
{
  loop[side].middle = loop[side].corner;
  loop[side].middle.x = (loop[side].corner.x + loop[(side + 1) % loop.size()].corner.x) / 2;
}

NodeField<char> nodes_in_contact(const FemModel& model, const FemState& state)
{
  NodeField<char> closed(model.mesh.node_count(), 0);
  for (std::size_t k = 0; k < model.contact.size(); ++k) {
    const FemContactPoint& point = model.contact[k];
    const FemContactState& now = state.contact[k];
    const bool bonded = model.interfaces[point.contact].tension > 0 && now.parted == 0;
    closed[point.node] = static_cast<char>(now.traction.dot(point.normal) > 0 || bonded);
  }
  return closed;
}

Real area_within(const OutlineLoop& loop)
{
  Real twice = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec<2>&a = loop[k].corner.x, &b = loop[(k + 1) % loop.size()].corner.x;
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

std::vector<OutlineLoop> divide_outline(const FemModel& model, const FemState& state, const ElementSizes& sizes, int& folds)
{
  Divider divider(model, state, sizes);
  std::vector<OutlineLoop> loops;
  for (std::vector<std::size_t>& sides : loops_of(model.mesh)) loops.push_back(divider.divide(std::move(sides)));
  folds = join_walls(loops, walls_of(model, state));
  folds += close_folds(loops);
  std::stable_sort(loops.begin(), loops.end(), [](const OutlineLoop& a, const OutlineLoop& b) { return area_within(a) > area_within(b); });
  return loops;
}

}  // namespace berm::fem
