// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "record/travel_curve.hpp"
#include "structures/base/answer.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/driven/driven.hpp"

namespace berm::anchor {

/// An anchor, plough or grapnel that is dragged through the bed: depth of its lowest point and tow force over travel. What it has in common with any driven body is that
/// of driven::Driven, such as the uplift resistance of a plate that is pulled out. It is named in the input.
class Anchor : public driven::Driven {
public:
  const char* word() const override { return "anchor"; }
  std::vector<run_folder::Quantity> quantities(const record::RunRecord& run, const std::vector<Real>& held_forces) const override;
  std::vector<std::string> quantity_names(const problem::Case& c) const override;
  std::string table_of(const record::RunRecord& run) const override;
  std::string in_words(const record::RunRecord& run, const base::DisplayUnits& shown) const override;
  std::string key_results(const base::Runs& runs, const base::DisplayUnits& shown) const override;
  std::string quality_note(const base::Runs&) const override { return ""; }
  std::vector<std::string> draw_report_curves(const base::Runs& runs, const base::PublishedPoints& published,
                                              const std::filesystem::path& folder) const override;
};

/// What a body that is dragged through the bed meets on its way: all drags of a run, one after the other, by row.
struct TowPath {
  std::vector<Real> travel;  ///< m, from where the first drag began
  std::vector<Real> depth;   ///< m, of the lowest point below the bed's surface
  std::vector<Real> H, V;    ///< N (plane strain N/m): against the drag; upwards on the body
};

TowPath tow_path(const record::RunRecord& run);

/// Numbers of a tow. Forces are averaged over +-0.05 D of travel.
struct TowResults {
  Real travel = nan;                     ///< m
  Real first_depth = nan, depth = nan;   ///< m, at the begin and the end
  Real max_depth = nan, at_depth = nan;  ///< m, and the travel to it
  Real max_force = nan, at_force = nan;  ///< N, largest H, m
  Real last_travel = nan;                ///< m, the end over which the following are taken: D, a third of a short way
  Real force = nan, vertical = nan;      ///< N, means of H and V
  Real depth_change = nan;               ///< m, how much deeper the straight line fitted to the depth goes there
  Real work = nan;                       ///< J, of H
};

TowResults tow_results(const TowPath& path, const base::BodyScale& scale);

template <auto Number>
constexpr base::Access<TowResults> of_tow = base::finite_number<TowResults, Number>;

inline constexpr base::Answer<TowResults> tow_answers[] = {
    {"tow_travel", base::AnswerUnit::length, "travel of all drags", of_tow<&TowResults::travel>},
    {"tow_depth_begin", base::AnswerUnit::length, "depth of the lowest point where the first drag begins",
     of_tow<&TowResults::first_depth>},
    {"tow_depth_end", base::AnswerUnit::length, "depth of the lowest point at the end of the drags", of_tow<&TowResults::depth>},
    {"tow_depth_max", base::AnswerUnit::length, "largest depth of the lowest point in the drags", of_tow<&TowResults::max_depth>},
    {"u_at_tow_depth_max", base::AnswerUnit::length, "travel to that depth", of_tow<&TowResults::at_depth>},
    {"tow_force_max", base::AnswerUnit::force, "largest tow force, averaged", of_tow<&TowResults::max_force>},
    {"u_at_tow_force_max", base::AnswerUnit::length, "travel to that force", of_tow<&TowResults::at_force>},
    {"tow_force_end", base::AnswerUnit::force, "mean tow force over the end of the drags", of_tow<&TowResults::force>},
    {"tow_V_end", base::AnswerUnit::force, "mean vertical reaction over the end of the drags", of_tow<&TowResults::vertical>},
    {"tow_depth_change", base::AnswerUnit::length, "how much deeper the body goes over the end of the drags",
     of_tow<&TowResults::depth_change>},
    {"tow_work", base::AnswerUnit::work, "work of the tow force", of_tow<&TowResults::work>},
};

}  // namespace berm::anchor
