// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "run_folder/frame_reader.hpp"

namespace berm::base {

/// How many cells lie across the soil that has sheared: the smallest side of the box that holds the middle 98 % of these points along each axis, over the side of
/// the square (cube) whose half (sixth) is as large as their mean cell. A side along which all the soil has sheared, between the same ends as at the start, does not
/// count: a column between walls may be one cell wide. A point has sheared where its deviatoric strain is over a tenth of what one point in a hundred exceeds.
/// `points_of_cell`: points that a cell of each body had at the start; bodies with NaN do not count. NaN where no point or no side counts.
Real cells_across_mechanism(const run_folder::SavedSoil& start, const run_folder::SavedSoil& now, const std::vector<Real>& points_of_cell,
                            int dim);

/// The same at the last frame of a run, in its bodies that can yield and were filled cell by cell; NaN without such a body, or a frame that can be read.
Real cells_across_mechanism(const record::RunRecord& run);

/// The smallest and the largest cell, m (Mesh::size), in which soil whose shear bands have a width has sheared so by the last frame, from the volume of its points; empty
/// as NaN above, and where regions have numbers of particles a cell of their own.
struct CellSizes {
  Real smallest = infinity, largest = 0;
};
std::optional<CellSizes> sheared_cell_sizes(const record::RunRecord& run);

/// Whether a run of the material point method has such a body.
bool has_mechanism_cells(const record::RunRecord& run);

}  // namespace berm::base
