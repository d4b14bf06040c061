// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formulas/hobbs.hpp"
#include "structures/base/answer_table.hpp"

#include <array>

namespace berm::line {

/// A loaded stage of a run, at its end.
struct StageEnd {
  std::string name;
  Index row;    ///< the last of the history in this stage
  bool heated;  ///< the constrained force did not fall in it
  std::string
      like{};  ///< the latest stage before that ended under the same constrained force, with another one between; "" where there is none
};

/// Of the stages that loaded the line, in their order; those without rows are left out.
std::vector<StageEnd> stage_ends(const record::RunRecord& run);

/// The key results of the line at the ends of its stages: of the history, of the shapes in line.csv, and of cycles.
std::vector<run_folder::Quantity> line_quantities(const record::RunRecord& run);

/// The names of all that a run of a case may have of these.
std::vector<std::string> line_names(const settings::Case& c);

/// The same as tables of the log and of the page, whose names begin with `id`: of loads, and of shapes, strains and cycles.
std::array<base::AnswerTable, 2> answer_tables(const record::RunRecord& run, const std::string& id);

/// The strain in compression that utilisation is of: f101_compressive_strain of the wall over its factors; NaN of a line without a wall.
formulas::Formula strain_limit(const settings::Case& c);

/// The line of a case on a plane with a lateral friction (over its weight), as Hobbs has it: with three lobes, and four of a line whose halves are images by half a turn. Along the line it has that
/// of its far soil.
struct HobbsLine {
  HobbsLine(const settings::Case& c, Real friction);

  formulas::HotLine line;
  formulas::HobbsMode mode;

  formulas::HobbsBuckle at(Real P0) const { return hobbs_buckle_at(mode, line, P0); }
  Real smallest_force() const { return hobbs_smallest_force(mode, line); }
};

}  // namespace berm::line
