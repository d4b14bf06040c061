// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_frames.hpp"

#include "core/for_each_task.hpp"
#include "os/error.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace berm::report {
namespace {

std::vector<std::string> stages_of(const std::vector<FilmMoment>& moments)
{
  std::vector<std::string> stages;
  for (const FilmMoment& moment : moments) stages.push_back(moment.stage);
  return stages;
}

/// The history with u of the point that the page names.
run_folder::History with_named_u(const record::RunRecord& run)
{
  run_folder::History history = run.history;
  const auto u = std::ranges::find(history.columns, "u_m", &run_folder::Column::name);
  if (u == history.columns.end()) return history;
  if (std::optional<base::PointTravel> point = structures::structure_of(run.settings).point_travel(run))
    history.values[u - history.columns.begin()] = std::move(point->u);
  return history;
}

/// Fields that are zero in all frames, such as the speed of finite elements, are not worth their room.
void leave_out_zeros(FilmFrames& footage)
{
  for (std::size_t f = footage.fields.size(); f-- > 0 && footage.fields.size() > 1;) {
    const bool zero = std::all_of(footage.frames.begin(), footage.frames.end(), [&](const FilmFrame& frame) {
      return std::all_of(frame.fields[f].begin(), frame.fields[f].end(), [](float value) { return value == 0; });
    });
    if (!zero) continue;
    const auto place = static_cast<std::ptrdiff_t>(f);
    footage.fields.erase(footage.fields.begin() + place);
    for (FilmFrame& frame : footage.frames) frame.fields.erase(frame.fields.begin() + place);
  }
}

/// Reads those of the files that are wanted, until one cannot be read.
void read_frames(FilmFrames& footage, const record::RunRecord& run, const std::vector<run_folder::FrameFiles>& files,
                 const FilmReader& reader, std::size_t max_memory)
{
  std::vector<FilmMoment> moments;
  const run_folder::History history = with_named_u(run);
  for (const run_folder::FrameFiles& frame : files) moments.push_back(moment_at(history, frame.time));
  const std::size_t bytes_of_point =
      2 * sizeof(Real) + (reader.fields().size() + (reader.has_flow() ? 2 : 0)) * sizeof(float);  // the lists of a FilmFrame
  footage.step = static_cast<Index>(files.size() * reader.count() * bytes_of_point / max_memory) + 1;
  const std::vector<Index> wanted = kept_frames(stages_of(moments), footage.step);

  footage.frames.resize(wanted.size());
  std::vector<std::string> refusals(wanted.size());
  for_each_task("read frames", static_cast<Index>(wanted.size()), [&](Index k) {
    try {
      footage.frames[k] = reader.read(files[wanted[k]]);
      for (Index left_out = k > 0 ? wanted[k - 1] + 1 : wanted[k]; left_out < wanted[k]; ++left_out)
        reader.add_summed(files[left_out], footage.frames[k]);
    } catch (const RunError& error) {
      refusals[k] = error.what();
    }
  });
  std::size_t good = 0;
  for (; good < wanted.size() && refusals[good].empty(); ++good) {
    footage.time.push_back(files[wanted[good]].time);
    footage.moments.push_back(moments[wanted[good]]);
  }
  footage.frames.resize(good);
  for (std::size_t f = 0; f < reader.fields().size(); ++f)
    for (std::size_t k = 1; k < good && reader.fields()[f].summed; ++k) {
      const std::vector<float>& before = footage.frames[k - 1].fields[f];
      std::vector<float>& now = footage.frames[k].fields[f];
      std::transform(now.begin(), now.end(), before.begin(), now.begin(), std::plus<>());
    }
  footage.fields = reader.fields();
  leave_out_zeros(footage);
  if (good < wanted.size())
    footage.fault =
        fmt::format("frame {} of {} cannot be read: {}; the film ends before it", wanted[good] + 1, files.size(), refusals[good]);
}

}  // namespace

std::vector<std::string> FilmFrames::stages() const
{
  return stages_of(moments);
}

FilmFrames read_footage(const record::RunRecord& run, std::size_t max_memory, FilmPart part)
{
  FilmFrames footage;
  if (run.settings.method == settings::Method::fem && run.settings.fem.large_deformation) {
    footage.fault = "there is no film of the soil: its mesh changes in the run. ParaView shows frames/frames.pvd";
    return footage;
  }
  std::vector<run_folder::FrameFiles> files;
  try {
    files = run_folder::frame_files(run.folder / "frames");
    if (files.empty()) {
      if (run.history.rows() > 0) footage.fault = "there is no film of the soil: frames/ lists no frames";
      return footage;
    }
    const auto& bodies = run.settings.body;
    const bool earthworks = std::any_of(bodies.begin(), bodies.end(),
                                        [](const auto& body) { return !body.second.fill.empty() || !body.second.excavation.empty(); });
    const FilmReader reader(files, run.settings.dimension(), base::drives_a_body(run.settings) ? base::body_word(run.settings) : "",
                            earthworks || (run.origin && run.origin->lengthened), part);
    footage.sizes = reader.sizes();
    footage.triangles = reader.triangles();
    footage.one_of = reader.one_of();
    if (run.settings.dimension() == 3 && part == FilmPart::slice) footage.slice = reader.middle();
    read_frames(footage, run, files, reader, max_memory);
  } catch (const RunError& error) {
    footage.fault = files.empty() ? fmt::format("there is no film of the soil: {}", error.what())
                                  : fmt::format("frame 1 of {} cannot be read: {}; there is no film", files.size(), error.what());
  }
  return footage;
}

std::vector<Index> kept_frames(const std::vector<std::string>& stages, Index step)
{
  std::vector<Index> kept;
  const Index count = static_cast<Index>(stages.size());
  for (Index k = 0; k < count; ++k)
    if (k % step == 0 || k + 1 == count || stages[k] != stages[k + 1]) kept.push_back(k);
  return kept;
}

std::string kept_words(Index step)
{
  if (step == 1) return "";
  const bool teen = step / 10 % 10 == 1;
  const char* ending = teen ? "th" : step % 10 == 1 ? "st" : step % 10 == 2 ? "nd" : step % 10 == 3 ? "rd" : "th";
  return fmt::format("every {}{} frame", step, ending);
}

namespace {

/// A column at a time, on the straight line between the rows around it; `after` is the first row that is not before that time.
Real between_rows(const std::vector<Real>& times, const std::vector<Real>& column, std::size_t after, Real time)
{
  if (after == 0) return column.front();
  if (after == times.size()) return column.back();
  const Real begin = times[after - 1], end = times[after];
  return column[after - 1] + (column[after] - column[after - 1]) * (time - begin) / (end - begin);
}

std::size_t first_row_from(const std::vector<Real>& times, Real time)
{
  return static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
}

}  // namespace

FilmMoment moment_at(const run_folder::History& history, Real time)
{
  FilmMoment moment;
  if (history.rows() == 0 || !history.has("time_s")) return moment;
  const std::vector<Real>& times = history["time_s"];
  const std::size_t after = first_row_from(times, time);
  std::size_t nearest = std::min(after, times.size() - 1);
  if (nearest > 0 && time - times[nearest - 1] <= std::abs(times[nearest] - time)) --nearest;
  moment.stage = history.stage[nearest];
  if (history.has("u_m")) moment.u = between_rows(times, history["u_m"], after, time);
  if (history.has("w_m")) moment.w = between_rows(times, history["w_m"], after, time);
  if (history.has_label("H")) moment.H = history.by_label("H")[nearest];
  if (history.has_label("V")) moment.V = history.by_label("V")[nearest];
  return moment;
}

Real way_between(const run_folder::History& history, Real from, Real to)
{
  if (history.rows() == 0 || !history.has("time_s") || !history.has("u_m") || !history.has("w_m")) return nan;
  const std::vector<Real>&times = history["time_s"], &u = history["u_m"], &w = history["w_m"];
  const FilmMoment begin = moment_at(history, from), end = moment_at(history, to);
  Real way = 0, u_before = begin.u, w_before = begin.w;
  const auto go_to = [&](Real u_now, Real w_now) {
    way += std::hypot(u_now - u_before, w_now - w_before);
    u_before = u_now;
    w_before = w_now;
  };
  for (std::size_t row = first_row_from(times, from); row < times.size() && times[row] < to; ++row) go_to(u[row], w[row]);
  go_to(end.u, end.w);
  return way;
}

}  // namespace berm::report
