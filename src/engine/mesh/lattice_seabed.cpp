// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/lattice_seabed.hpp"

#include "mesh/coarsening.hpp"

#include <numbers>

namespace berm::mesh {
namespace {

constexpr Real row_height = std::numbers::sqrt3 / 2;  // of an equilateral triangle, over its side
constexpr Real slack = 1e-9;
constexpr Real thinnest = 0.7;  // step beside a wall, over the equal ones

/// Equal steps from 0, and steps that grow beyond them up to a wall.
struct Steps {
  Real step;        ///< m, of the equal ones
  Index equal = 0;  ///< number of these
  Index all = 0;    ///< with the growing ones
  Real wall;        ///< m from 0
  Coarsening growth;

  /// Distance from 0 after so many steps, m.
  Real at(Index n) const
  {
    if (n == all) return wall;
    if (n <= equal) return step * n;
    const Real begin = step * equal, cells = growth.count(wall - begin);
    return begin + growth.distance(cells * (n - equal) / (all - equal));
  }
};

/// Steps from 0 that are equal to `near` at least and end at `wall`, m; of cells that have their first size in equal steps.
Steps steps_to(Real near, Real wall, const Coarsening& growth, Real steps_a_cell)
{
  const auto whole = [](Real count) { return static_cast<Index>(std::min(count, max_seabed_cells)); };
  Steps steps{growth.first / steps_a_cell, 0, 0, wall, growth};
  steps.equal = whole(std::ceil(std::max(Real(0), near) / steps.step - slack));
  const auto left_over = [&] { return steps_a_cell * growth.count(wall - steps.step * steps.equal); };
  if (left_over() < thinnest && steps.equal > 0) --steps.equal;
  steps.all = steps.equal + whole(std::max(Real(1), std::round(left_over())));
  return steps;
}

/// Half sides along x to both sides of x = 0, where the lattice is fixed, and rows below and above the surface.
struct Lattice {
  bool half;  ///< the left wall is at x = 0
  Steps left, right, down, up;

  Index half_sides() const { return (half ? 0 : left.all) + right.all; }
  Index rows() const { return down.all + up.all; }
};

Lattice lattice_of(const SeabedMesh& bed)
{
  const SeabedLayout at = layout_of(bed);
  const Coarsening growth{bed.near_size, bed.growth, at.far_size};
  return {bed.near_left == 0, steps_to(-bed.near_left, -at.left, growth, 2), steps_to(bed.near_right, at.right, growth, 2),
          steps_to(bed.near_depth, bed.depth, growth, 1 / row_height), steps_to(bed.near_height, bed.headroom, growth, 1 / row_height)};
}

/// The level side of a triangle: its row of nodes, and the column of its left end.
struct Base {
  Index row, column;
};

/// A row's nodes stand on every second of the columns, which are half a side apart, and on both walls.
class Rows {
public:
  Rows(const Lattice& lattice, const SeabedMesh& bed, Mesh<2>& mesh) : lattice_(lattice), columns_(lattice.half_sides() + 1)
  {
    const Index middle = lattice.half ? 0 : lattice.left.all;
    for (Index k = 0; k < columns_; ++k) x_.push_back(k < middle ? -lattice.left.at(middle - k) : lattice.right.at(k - middle));
    for (Index row = 0; row <= lattice.rows(); ++row)
      y_.push_back(row < lattice.down.all ? -lattice.down.at(lattice.down.all - row) : lattice.up.at(row - lattice.down.all));
    for (Index row = 0; row <= lattice.rows(); ++row) {
      number_.emplace_back(columns_, none);
      for (Index k = 0; k < columns_; ++k) {
        const bool is_of_row = (k - middle + row - lattice.down.all) % 2 != 0;  // none of the surface stands on the middle
        if (!is_of_row && k > 0 && k + 1 < columns_) continue;
        number_.back()[k] = mesh.node_count();
        mesh.position.push_back(Vec<2>(x_[k], y_[row] + std::tan(bed.slope) * x_[k]));
      }
    }
  }

  /// Calls visit(corners, center, base) for each triangle between a row and the next, from the left to the right; the centre is that on a level bed, m.
  template <class Visit>
  void for_each_triangle(Index row, const Visit& visit) const
  {
    const auto &below = number_[row], &above = number_[row + 1];
    Index last_below = 0, last_above = 0;
    const auto make = [&](Index to, bool upwards) {
      Index& last = upwards ? last_above : last_below;
      const Real base = upwards ? y_[row + 1] : y_[row], apex = upwards ? y_[row] : y_[row + 1];
      visit(Mesh<2>::Corners{below[last_below], above[last_above], upwards ? above[to] : below[to]},
            Vec<2>((x_[last_below] + x_[last_above] + x_[to]) / 3, (2 * base + apex) / 3), Base{upwards ? row + 1 : row, last});
      last = to;
    };
    for (Index k = 1; k + 1 < columns_; ++k) make(k, below[k] == none);
    const bool above_first = below[columns_ - 2] != none;  // both rows end at the wall
    make(columns_ - 1, above_first);
    make(columns_ - 1, !above_first);
  }

  Index node(Index row, Index column) const { return number_[row][column]; }
  Index columns() const { return columns_; }

private:
  const Lattice& lattice_;
  Index columns_;
  std::vector<Real> x_, y_;
  std::vector<std::vector<Index>> number_;  ///< of a node, by row and column; none where the row has none
};

/// Patches that are mirror images left and right: the two triangles on one base, of one region. A triangle whose base is one of the surface or of a border of its region joins the patch of the next one of its
/// row outwards, and stays alone where there is none: in the middle, at the end of a region, and in one of a single row.
class Patching {
public:
  Patching(const Lattice& lattice, Index columns)
      : cells_of_row_(lattice.half_sides() + 1),
        first_(lattice.rows() + 1, std::vector<Index>(columns, none))
  {
  }

  /// The last of these cells, which were added from left to right; x from the middle.
  void add(const CellField<Index>& region, const Base& base, Real x)
  {
    const Index cell = region.size() - 1;
    patch_.push_back(cell);
    outwards_.push_back(x > 0 ? cell + 1 : x < 0 ? cell - 1 : none);
    Index& first = first_[base.row][base.column];
    if (first == none)
      first = cell;
    else if (region[first] == region[cell])
      patch_[cell] = first, is_pair_[first] = true;
    is_pair_.push_back(patch_[cell] != cell);
  }
  CellField<Index> patches(const CellField<Index>& region) &&
  {
    for (Index cell = 0; cell < patch_.size(); ++cell) {
      const Index next = outwards_[cell];
      const bool has_next = next >= 0 && next < patch_.size() && next / cells_of_row_ == cell / cells_of_row_;
      if (!is_pair_[cell] && has_next && is_pair_[next] && region[next] == region[cell]) patch_[cell] = patch_[next];
    }
    return std::move(patch_);
  }

private:
  Index cells_of_row_;
  std::vector<std::vector<Index>> first_;  ///< cell on a base, by row and column, or none
  CellField<Index> patch_;                 ///< the first cell of each cell's patch
  std::vector<Index> outwards_;            ///< the next cell outwards, which at a wall is of another row
  std::vector<bool> is_pair_;
};

}  // namespace

Real cells_in_lattice(const SeabedMesh& bed)
{
  const Lattice lattice = lattice_of(bed);
  return static_cast<Real>(lattice.rows()) * static_cast<Real>(lattice.half_sides() + 1);
}

Mesh<2> make_lattice_seabed(const SeabedMesh& bed)
{
  check(bed);
  const Lattice lattice = lattice_of(bed);
  const SeabedLayout at = layout_of(bed);
  Mesh<2> mesh;
  mesh.region_names = {"near", "bed", "headroom"};
  if (bed.layer > 0) mesh.region_names.emplace_back("layer");
  mesh.boundary_names = {"left", "right", "base", "top", "surface"};
  mesh.boundary_nodes.resize(mesh.boundary_names.size());
  const Rows rows(lattice, bed, mesh);
  for (Index row = 0; row <= lattice.rows(); ++row)
    for (Index k = 0; k < rows.columns(); ++k) {
      const bool on[] = {k == 0, k + 1 == rows.columns(), row == 0, row == lattice.rows(), row == lattice.down.all};
      for (std::size_t b = 0; b < mesh.boundary_nodes.size(); ++b)
        if (on[b] && rows.node(row, k) != none) mesh.boundary_nodes[b].push_back(rows.node(row, k));
    }
  const bool at_left_wall = bed.near_left == at.left;
  const Real near_left = at_left_wall ? -infinity : -lattice.left.at(lattice.left.equal),
             near_right = lattice.right.at(lattice.right.equal), near_base = -lattice.down.at(lattice.down.equal);
  const auto beyond = [&](Real distance) { return distance > 1e-6 * bed.near_size; };  // on both sides alike, however rounded
  const auto region_of = [&](Real x, Real y) -> Index {
    if (y > 0) return 2;
    const bool in_layer =
        beyond(bed.layer - bed.depth - y) || (beyond(at.left + bed.layer - x) && !at_left_wall) || beyond(x - at.right + bed.layer);
    if (bed.layer > 0 && in_layer) return 3;
    return beyond(y - near_base) && beyond(x - near_left) && beyond(near_right - x) ? 0 : 1;
  };
  Patching patching(lattice, rows.columns());
  for (Index row = 0; row < lattice.rows(); ++row)
    rows.for_each_triangle(row, [&](const Mesh<2>::Corners& corners, const Vec<2>& center, const Base& base) {
      mesh.nodes.push_back(corners);
      mesh.region.push_back(region_of(center[0], center[1]));
      patching.add(mesh.region, base, center[0]);
    });
  mesh.patch = std::move(patching).patches(mesh.region);
  mesh.complete();
  return mesh;
}

}  // namespace berm::mesh
