// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "record/run_record.hpp"
#include "report/animation/film.hpp"
#include "report/animation/film_fields.hpp"
#include "run_folder/history.hpp"

#include <string>
#include <vector>

namespace berm::report {

/// What the history tells of a moment; NaN and "" where it tells nothing.
struct FilmMoment {
  std::string stage;    ///< of the row nearest in time
  Real u = nan, w = u;  ///< m, between two rows on the straight line
  Real H = nan, V = H;  ///< N/m, around an axis and in space N; of the row nearest in time
};

/// The moment of a time, s; before the first row or behind the last one, that row's.
FilmMoment moment_at(const run_folder::History& history, Real time);

/// The length of the driven body's way (u, w) between two times, m; NaN where the history does not tell it.
Real way_between(const run_folder::History& history, Real from, Real to);

/// The frames of a run that could be read, with what the history tells of each.
struct FilmFrames {
  std::vector<FilmField> fields;  ///< that are not zero in all frames; one at the least
  std::vector<FilmFrame> frames;
  std::vector<Real> time;           ///< s, of each
  std::vector<FilmMoment> moments;  ///< of each
  Index step = 1;                   ///< they are every step-th of the run's frames; more than 1 where all would take too much memory

  std::vector<float> sizes;                     ///< m, of the square or cube that each particle stands for at the start
  std::vector<std::array<Index, 6>> triangles;  ///< quadratic, of points; none in MPM
  std::optional<Real> slice;                    ///< z of the slice that is shown of a run in space, m
  Index one_of = 1;                             ///< of the whole of a run in space one of so many particles is shown
  std::string fault;                            ///< why frames are missing, in words, or ""

  std::size_t count() const { return sizes.size(); }
  std::vector<std::string> stages() const;
};

/// bytes
constexpr std::size_t max_memory_of_footage = 1'000'000'000;

/// Reads the frames of a run up to the first that is missing or damaged; no frames where there are none. They are held in memory until it is known how
/// many of them the page can take: where all would take more than `most_memory` bytes, they are left out evenly (never the last of a stage).
FilmFrames read_footage(const record::RunRecord& run, std::size_t max_memory = max_memory_of_footage, FilmPart part = FilmPart::slice);

/// Every `step`th frame, with the first, the last and the last of each stage; `stages` is by frame.
std::vector<Index> kept_frames(const std::vector<std::string>& stages, Index step);

/// "every 2nd frame"; with a step of 1 "".
std::string kept_words(Index step);

/// The film of those frames that are kept, with the first `fields` of the footage's fields, without a note. Ids of blocks begin with `prefix`.
Film encoded_film(const record::RunRecord& run, const FilmFrames& footage, const std::vector<Index>& kept, std::size_t fields,
                  const std::string& prefix);

}  // namespace berm::report
