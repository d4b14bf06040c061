// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/line/answers_test.cpp
#include "structures/line/answers.hpp"

#include "formulas/strain_limit.hpp"
#include "os/error.hpp"
#include "slices/line_of_case.hpp"
#include "structures/base/still_moving.hpp"
#include "structures/line/buckle.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace berm::line {
namespace {

using run_folder::QuantityKind;

/// The rows over which forces at the end of a stage are means: those of its last twentieth.
Index first_row_of_end(const run_folder::History& history, const StageEnd& end)
{
  constexpr Real last_part = 0.05;
  const std::vector<Real>& time = history["time_s"];
  const auto begin = std::ranges::find(history.stage, end.name) - history.stage.begin();
  const Real from = time[end.row] - last_part * (time[end.row] - time[begin]);
  Index first = end.row;
  while (first > begin && time[first - 1] >= from) --first;
  return first;
}

/// The sum of |H| over that of V of the slices within the buckle, means over the end of the stage; NaN where no slice of the history is there, or soil does not carry them.
Real mobilised_friction(const record::RunRecord& run, const StageEnd& end, const Buckle& buckle)
{
  const std::vector<Real> places = slices::LineOfCase(run.settings).places;
  const Index first = first_row_of_end(run.history, end);
  Real across = 0, down = 0;
  for (std::size_t k = 0; k < places.size() && places[k] <= buckle.half_length; ++k) {
    const std::string slice = k == 0 ? "" : fmt::format("slice_{}_", k);
    if (!run.history.has(slice + "H_N_m") || !run.history.has(slice + "V_N_m")) return nan;
    const std::vector<Real>&H = run.history[slice + "H_N_m"], &V = run.history[slice + "V_N_m"];
    Real sum = 0;
    for (Index row = first; row <= end.row; ++row) sum += H[row], down += V[row];
    across += std::abs(sum);
  }
  return down > 0 ? across / down : nan;
}

/// What an answer may be made from.
struct ReportedQuantity {
  const record::RunRecord& run;
  const StageEnd& end;
  const Shape* shape;       ///< at that moment; null where line.csv has none
  const Shape* like_shape;  ///< at the end of the stage that it is like
  const Buckle& buckle;     ///< of the shape
  Real limit;               ///< of the strain in compression

  Real at_end(const char* column) const { return run.history.has(column) ? run.history[column][static_cast<std::size_t>(end.row)] : nan; }
  /// Strain that makes stress: what the warmed wall would have by itself is none.
  Real compression() const { return run.settings.pipeline->expansion * at_end("line_T_K") - at_end("line_strain_min"); }
};

/// A number of the line at the end of a stage: that of a column of the history, or made.
struct Answer {
  const char *name, *unit, *meaning;
  const char* column;  ///< null: `of` makes it
  Real (*of)(const ReportedQuantity&) = nullptr;
  QuantityKind kind = QuantityKind::answer;
};
constexpr std::array line_answers = {
    Answer{"y", "m", "largest lateral displacement of the line, from its straight axis", "line_y_m"},
    Answer{"x_of_y", "m", "where it is, along the line", "line_x_m"},
    Answer{"crossing", "m", "position beyond it where the line crosses its axis", "line_crossing_m"},
    Answer{"z", "m", "height of the line there, relative to where it was laid", "line_z_m"},
    Answer{"P", "N", "effective compression at x = 0", "line_P_N"},
    Answer{"M", "N m", "largest lateral bending moment", "line_M_Nm"},
    Answer{"strain_max", "1", "largest longitudinal strain", "line_strain_max"},
    Answer{"strain_min", "1", "smallest longitudinal strain: the largest in compression", "line_strain_min"},
    Answer{"feed_in", "m", "axial displacement at the last slice, towards x = 0", "line_feed_in_m"},
    Answer{"springs_y", "m", "largest lateral displacement of the same line on springs", "springs_y_m"},
    Answer{"springs_P", "N", "effective compression of the same line on springs, at x = 0", "springs_P_N"},
    Answer{"springs_M", "N m", "largest lateral bending moment of the same line on springs", "springs_M_Nm"},
    Answer{"lobe_length", "m", "length of the largest lobe", nullptr, [](const ReportedQuantity& t) { return t.buckle.lobe_length; }},
    Answer{"lobes", "1", "lobes of the whole buckle", nullptr,
           [](const ReportedQuantity& t) { return t.shape == nullptr ? nan : static_cast<Real>(t.buckle.lobes); }},
    Answer{"slip_length", "m", "distance from x = 0 to where the line has slipped along its axis", nullptr,
           [](const ReportedQuantity& t) { return t.buckle.slip_length; }},
    Answer{"friction", "1", "mean |H|/V of the slices in the buckle", nullptr,
           [](const ReportedQuantity& t) { return t.shape == nullptr ? nan : mobilised_friction(t.run, t.end, t.buckle); }},
    Answer{"strain_bending", "1", "largest strain by bending, in both planes together", nullptr,
           [](const ReportedQuantity& t) { return t.shape == nullptr ? nan : t.buckle.bending; }},
    Answer{"strain_compressive", "1", "largest stress-inducing longitudinal strain in compression, positive", nullptr,
           [](const ReportedQuantity& t) { return t.compression(); }},
    Answer{"utilisation", "1", "that strain over the strain at which the wall may buckle", nullptr,
           [](const ReportedQuantity& t) { return t.compression() / t.limit; }, QuantityKind::ratio},
    Answer{"ratchet", "m", "growth of |y|", nullptr,
           [](const ReportedQuantity& t) {
             const auto like = std::find(t.run.history.stage.rbegin(), t.run.history.stage.rend(), t.end.like);
             if (t.end.like.empty() || !t.run.history.has("line_y_m")) return nan;
             const std::vector<Real>& y = t.run.history["line_y_m"];
             return std::abs(t.at_end("line_y_m")) - std::abs(y[static_cast<std::size_t>(t.run.history.stage.rend() - like - 1)]);
           }},
    Answer{"walking", "m", "mean axial displacement of the line", nullptr,
           [](const ReportedQuantity& t) {
             return t.shape == nullptr || t.like_shape == nullptr ? nan : mean_axial(*t.shape) - mean_axial(*t.like_shape);
           }},
};

bool is_of_cycle(const Answer& answer)
{
  return std::string_view(answer.name) == "ratchet" || std::string_view(answer.name) == "walking";
}

/// The last row of a stage, or none.
Index last_row_of(const run_folder::History& history, const std::string& stage)
{
  const auto last = std::find(history.stage.rbegin(), history.stage.rend(), stage);
  return static_cast<Index>(history.stage.rend() - last) - 1;
}

/// The shape at a row of the history; null where there is none.
const Shape* shape_at(const std::vector<Shape>& shapes, const run_folder::History& history, const std::string& stage)
{
  const Shape* shape = stage.empty() ? nullptr : last_of(shapes, stage);
  return shape != nullptr && shape->time == history["time_s"][static_cast<std::size_t>(last_row_of(history, stage))] ? shape : nullptr;
}

/// Those of the run, none where its file is damaged: everything else is told.
std::vector<Shape> shapes_of(const record::RunRecord& run)
{
  try {
    return read_shapes(run.folder);
  } catch (const RunError& error) {
    spdlog::warn("{}; results on the shape of the line are left out", error.what());
    return {};
  }
}

}  // namespace

std::vector<StageEnd> stage_ends(const record::RunRecord& run)
{
  std::vector<StageEnd> ends;
  if (!run.history.has("line_P0_N")) return ends;
  const std::vector<Real>& P0 = run.history["line_P0_N"];
  const auto force = [&](const StageEnd& end) { return P0[static_cast<std::size_t>(end.row)]; };
  Real largest = 0, before = 0;
  for (const problem::StageSettings& stage : run.settings.stage) {
    const Index row = last_row_of(run.history, stage.name);
    if (stage.kind != problem::StageKind::pipeline || row == none) continue;
    StageEnd end{stage.name, row, false};
    largest = std::max(largest, std::abs(force(end)));
    constexpr Real same = 0.01;  // of the largest constrained force
    const auto differs = [&](const StageEnd& other) { return std::abs(force(other) - force(end)) > same * largest; };
    const auto other = std::find_if(ends.rbegin(), ends.rend(), differs);
    const auto like = std::find_if_not(other, ends.rend(), differs);
    if (like != ends.rend()) end.like = like->name;
    end.heated = force(end) >= before;
    before = force(end);
    ends.push_back(std::move(end));
  }
  return ends;
}

std::vector<run_folder::Quantity> line_quantities(const record::RunRecord& run)
{
  std::vector<run_folder::Quantity> list;
  const std::vector<StageEnd> ends = stage_ends(run);
  if (ends.empty()) return list;
  const std::vector<base::StillMoving> moving = base::still_moving(run);
  const std::vector<Shape> shapes = shapes_of(run);
  const formulas::Formula strain = strain_limit(run.settings);
  const Real limit = strain.valid ? strain.value : nan;
  for (const StageEnd& end : ends) {
    const auto moves = std::ranges::find(moving, end.name, &base::StillMoving::stage);
    const std::string still = moves == moving.end() ? "" : "; " + still_moving_words(*moves);
    const Shape* shape = shape_at(shapes, run.history, end.name);
    const Buckle buckle = shape == nullptr ? Buckle{} : buckle_of(*shape, *run.settings.pipeline);
    const ReportedQuantity told{run, end, shape, shape_at(shapes, run.history, end.like), buckle, limit};
    for (const Answer& answer : line_answers)
      if (const Real value = answer.column != nullptr ? told.at_end(answer.column) : answer.of(told); std::isfinite(value))
        list.push_back({fmt::format("{}.{}", end.name, answer.name), value, answer.unit,
                        (is_of_cycle(answer) ? fmt::format("{} since the end of {}, a cycle before", answer.meaning, end.like)
                                             : fmt::format("{} at the end of the stage", answer.meaning)) +
                            still,
                        answer.kind, end.name});
  }
  return list;
}

std::vector<std::string> line_quantity_names(const std::string& stage)
{
  std::vector<std::string> names;
  for (const Answer& answer : line_answers) names.push_back(fmt::format("{}.{}", stage, answer.name));
  return names;
}

formulas::Formula strain_limit(const problem::Case& c)
{
  formulas::Formula strain =
      formulas::f101_compressive_strain(slices::LineOfCase(c).diameter, c.pipeline->wall.value_or(nan), formulas::f101_yield_over_tensile);
  strain.value /= formulas::f101_strain_factor_medium * formulas::f101_load_factor;
  return strain;
}

HobbsLine::HobbsLine(const problem::Case& c, Real friction)
    : mode(c.pipeline->half == problem::LineHalf::symmetric ? formulas::HobbsMode::three : formulas::HobbsMode::four)
{
  const problem::PipelineSettings& p = *c.pipeline;
  const beam::Section section = slices::LineOfCase(c).line.section.front();
  line = {section.bending_stiffness, section.axial_stiffness, friction * p.submerged_weight,
          p.far_soil.axial_friction * p.submerged_weight};
}

}  // namespace berm::line
