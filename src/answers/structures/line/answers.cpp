// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/line/answers_test.cpp
#include "structures/line/answers.hpp"

#include "formulas/strain_limit.hpp"
#include "io/log.hpp"
#include "os/error.hpp"
#include "slices/line_of_case.hpp"
#include "structures/base/still_moving.hpp"
#include "structures/line/buckle.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::line {
namespace {

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

/// A stage at its end.
struct AtEnd {
  const record::RunRecord& run;
  const StageEnd& end;
  const Shape* shape;       ///< at that moment; null where line.csv has none
  const Shape* like_shape;  ///< at the end of the stage that it is like
  const Buckle& buckle;     ///< of the shape
  Real limit;               ///< of the strain in compression

  Real at(const char* column) const { return run.history.has(column) ? run.history[column][static_cast<std::size_t>(end.row)] : nan; }
  Real of_shape(Real value) const { return shape == nullptr ? nan : value; }
  /// Strain that makes stress: what the warmed wall would have by itself is none.
  Real compression() const { return run.settings.pipeline->expansion * at("line_T_K") - at("line_strain_min"); }
};

/// Growth of |y| since the end of the stage that it is like.
Real ratchet_of(const AtEnd& e)
{
  const std::vector<std::string>& stages = e.run.history.stage;
  const auto like = std::find(stages.rbegin(), stages.rend(), e.end.like);
  if (e.end.like.empty() || !e.run.history.has("line_y_m")) return nan;
  return std::abs(e.at("line_y_m")) - std::abs(e.run.history["line_y_m"][static_cast<std::size_t>(stages.rend() - like - 1)]);
}

Real walking_of(const AtEnd& e)
{
  return e.shape == nullptr || e.like_shape == nullptr ? nan : mean_axial(*e.shape) - mean_axial(*e.like_shape);
}

using enum base::AnswerUnit;
using Row = base::Answer<AtEnd>;

constexpr Row load_answers[] = {
    Row{"y", length, "largest lateral displacement of the line, from its straight axis", [](const AtEnd& e) { return e.at("line_y_m"); }}
        .headed({"y", "m"}),
    {"x_of_y", length, "where it is, along the line", [](const AtEnd& e) { return e.at("line_x_m"); }},
    {"crossing", length, "position beyond it where the line crosses its axis", [](const AtEnd& e) { return e.at("line_crossing_m"); }},
    Row{"z", length, "height of the line there, relative to where it was laid", [](const AtEnd& e) { return e.at("line_z_m"); }}.headed(
        {"z", "mm", 1e-3}),
    Row{"P", force, "effective compression at x = 0", [](const AtEnd& e) { return e.at("line_P_N"); }}.headed({"P", "kN", 1e3}),
    Row{"M", moment, "largest lateral bending moment", [](const AtEnd& e) { return e.at("line_M_Nm"); }}.headed({"M", "kN m", 1e3}),
    Row{"strain_max", ratio, "largest longitudinal strain", [](const AtEnd& e) { return e.at("line_strain_max"); }}.headed(
        {"max strain", "%", 0.01}),
    Row{"strain_min", ratio, "smallest longitudinal strain: the largest in compression",
        [](const AtEnd& e) { return e.at("line_strain_min"); }}
        .headed({"min strain", "%", 0.01}),
    Row{"feed_in", length, "axial displacement at the last slice, towards x = 0", [](const AtEnd& e) { return e.at("line_feed_in_m"); }}
        .headed({"feed-in", "m"}),
    {"springs_y", length, "largest lateral displacement of the same line on springs", [](const AtEnd& e) { return e.at("springs_y_m"); }},
    {"springs_P", force, "effective compression of the same line on springs, at x = 0", [](const AtEnd& e) { return e.at("springs_P_N"); }},
    {"springs_M", moment, "largest lateral bending moment of the same line on springs",
     [](const AtEnd& e) { return e.at("springs_M_Nm"); }},
};
constexpr Row shape_answers[] = {
    Row{"lobe_length", length, "length of the largest lobe", [](const AtEnd& e) { return e.buckle.lobe_length; }}.headed({"lobe", "m"}),
    Row{"lobes", ratio, "lobes of the whole buckle", [](const AtEnd& e) { return e.of_shape(e.buckle.lobes); }}.headed(
        {.words = "lobes", .whole = true}),
    Row{"slip_length", length, "distance from x = 0 to where the line has slipped along its axis",
        [](const AtEnd& e) { return e.buckle.slip_length; }}
        .headed({"slip", "m"}),
    Row{"friction", ratio, "mean |H|/V of the slices in the buckle",
        [](const AtEnd& e) { return e.shape == nullptr ? nan : mobilised_friction(e.run, e.end, e.buckle); }}
        .headed({"H/V of the slices"}),
    Row{"strain_bending", ratio, "largest strain by bending, in both planes together",
        [](const AtEnd& e) { return e.of_shape(e.buckle.bending); }}
        .headed({"bending strain", "%", 0.01}),
    Row{"strain_compressive", ratio, "largest stress-inducing longitudinal strain in compression, positive",
        [](const AtEnd& e) { return e.compression(); }}
        .headed({"compressive", "%", 0.01}),
    Row{"utilisation", ratio, "that strain over the strain at which the wall may buckle",
        [](const AtEnd& e) { return e.compression() / e.limit; }, run_folder::QuantityKind::ratio}
        .headed({"utilisation"}),
};
/// Since the end of the stage that it is like.
constexpr Row cycle_answers[] = {
    Row{"ratchet", length, "growth of |y|", ratchet_of}.headed({"ratchet", "m"}),
    Row{"walking", length, "mean axial displacement of the line", walking_of}.headed({"walking", "mm", 1e-3}),
};

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
    io::warn("{}; results on the shape of the line are left out", error.what());
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
  for (const settings::StageSettings& stage : run.settings.stage) {
    const Index row = last_row_of(run.history, stage.name);
    if (stage.kind != settings::StageKind::pipeline || row == none) continue;
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
  base::AnswerList list(3);
  const std::vector<StageEnd> ends = stage_ends(run);
  if (ends.empty()) return {};
  const std::vector<base::StillMoving> moving = base::still_moving(run);
  const std::vector<Shape> shapes = shapes_of(run);
  const formulas::Formula strain = strain_limit(run.settings);
  const Real limit = strain.valid ? strain.value : nan;
  for (const StageEnd& end : ends) {
    const auto moves = std::ranges::find(moving, end.name, &base::StillMoving::stage);
    const std::string still = moves == moving.end() ? "" : "; " + still_moving_words(*moves);
    const Shape* shape = shape_at(shapes, run.history, end.name);
    const Buckle buckle = shape == nullptr ? Buckle{} : buckle_of(*shape, *run.settings.pipeline);
    const AtEnd at_end{run, end, shape, shape_at(shapes, run.history, end.like), buckle, limit};
    list.of(end.name, end.name + ".");
    list.behind(" at the end of the stage" + still);
    list.add(load_answers, at_end);
    list.add(shape_answers, at_end);
    list.behind(fmt::format(" since the end of {}, a cycle before{}", end.like, still));
    list.add(cycle_answers, at_end);
  }
  return list.list();
}

std::vector<std::string> line_names(const settings::Case& c)
{
  base::AnswerList list(3);
  for (const settings::StageSettings& stage : c.stage) {
    if (stage.kind != settings::StageKind::pipeline) continue;
    list.of(stage.name, stage.name + ".");
    list.add_names(load_answers), list.add_names(shape_answers), list.add_names(cycle_answers);
  }
  return list.names();
}

std::array<base::AnswerTable, 2> answer_tables(const record::RunRecord& run, const std::string& id)
{
  std::array tables{base::AnswerTable({id + "-line", run.name + ": the line at the end of each of its stages"}, 3, load_answers),
                    base::AnswerTable({id + "-shape", run.name + ": shape, strain and cycles at the end of each stage"}, 3, shape_answers,
                                      cycle_answers)};
  for (const StageEnd& end : stage_ends(run))
    for (base::AnswerTable& table : tables) table.add(end.name, run, end.name + ".");
  return tables;
}

formulas::Formula strain_limit(const settings::Case& c)
{
  formulas::Formula strain =
      formulas::f101_compressive_strain(slices::LineOfCase(c).diameter, c.pipeline->wall.value_or(nan), formulas::f101_yield_over_tensile);
  strain.value /= formulas::f101_strain_factor_medium * formulas::f101_load_factor;
  return strain;
}

HobbsLine::HobbsLine(const settings::Case& c, Real friction)
    : mode(c.pipeline->half == settings::LineHalf::symmetric ? formulas::HobbsMode::three : formulas::HobbsMode::four)
{
  const settings::PipelineSettings& p = *c.pipeline;
  const beam::Section section = slices::LineOfCase(c).line.section.front();
  line = {section.bending_stiffness, section.axial_stiffness, friction * p.submerged_weight,
          p.far_soil.axial_friction * p.submerged_weight};
}

}  // namespace berm::line
