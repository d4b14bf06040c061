// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

#include <optional>

namespace berm::uncertainty {

/// A run that a band is made of.
struct Variant {
  std::string name;  ///< of its folder: cells_0.5, cells_1.5_fast, cells_1.5_d50_0.1_mm
  Real size;         ///< of its cells over those of the case
  Real speed;        ///< of its drives over that of the case; of finite elements the length of its increments
  settings::Case settings;
  std::optional<Real> d50 = {};  ///< m, of its sand, which has none in the case: no part of the band
};

/// What the band of a case is made of, and what it cannot hold.
struct VariantPlan {
  std::vector<Variant> variants;      ///< those of other cells, then the fast one, then those with grains
  std::vector<std::string> left_out;  ///< parts that the band will not hold, and why
};

/// In the plane and around an axis: where the driven body is less than 16 cells wide, a run of half the cells and one of 1.5 times the cells of the case, or of .7 where
/// fewer than five would remain. Else, and in space, runs of 2.1 and 3 times the cells, less where fewer than five would remain or they would be larger than a layer of the
/// bed. And one more of the largest cells at twice the speed (finite elements: with increments twice and relaxation four times as long) where the soil does not know
/// speed. Where it loses strength in shear bands that have no width of their own, two more of the largest cells, with grains of fine and of medium to coarse sand.
/// Throws KeyError where no band can be made of the case: no body is driven, the mesh is a file, or cells are too large already.
VariantPlan choose_variants(const settings::Case& c);

/// What the variants take over what the run of the case takes, about, on as many threads: there are fewer cells and, but for finite elements, longer time steps. Source:
/// docs/decisions/0117.
Real work_of(const VariantPlan& plan, const settings::Case& c);

/// The case with all cells `ratio` times as large, and the particles of blocks and disks as far apart; without frames on the way. The fine zone of a bed stays clear of
/// walls and base. The size that it came to, which differs where a box is cut into whole cells.
std::pair<settings::Case, Real> with_other_cells(settings::Case c, Real ratio);

/// The case with every drive at twice the speed over the same travel.
settings::Case at_twice_the_speed(settings::Case c);

}  // namespace berm::uncertainty
