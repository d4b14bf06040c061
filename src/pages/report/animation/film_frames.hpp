// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "report/animation/film_fields_of_frames.hpp"
#include "report/animation/film_moment.hpp"

namespace berm::report {

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

}  // namespace berm::report
