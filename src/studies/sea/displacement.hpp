// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "sea/march.hpp"
#include "sea/sea_answer.hpp"

namespace berm::sea {

/// A load history of the largest waves, one after the other: rows at equal times between ramps from still water.
struct WaveRow {
  Real time = 0, velocity = 0;  ///< s, m/s
  Real H = 0, V = 0;            ///< N/m, on a pipe at rest
};
std::vector<WaveRow> load_history_of(const SeaCase& c, const LoadRecord& record, const std::vector<LoadWave>& waves);

/// A run through the largest waves of a seed.
struct RunBeside {
  std::string name, method;
  int seed = 0;
  Track track;
};

/// The stage of the largest waves of a seed (from 0).
settings::StageSettings stage_of_waves(const SeaCase& c, const SeaAnswer& answer, std::size_t seed);

/// A run with a stage through one of these with the same water and pipe, by seed. Throws RunError where it has none, or has not gone through it.
RunBeside run_beside(const record::RunRecord& run, const std::vector<settings::StageSettings>& waves, Real mass, Real diameter);

/// How far the pipe moves on its macro-element, and in runs.
struct Displacements {
  std::vector<Track> seeds;  ///< of the whole duration
  std::vector<Track> waves;  ///< of the largest waves, by seed
  std::vector<RunBeside> runs;
  Real wall_s = 0;  ///< of the seeds over the whole duration
};

/// kg/m, with added mass.
Real mass_of(const SeaCase& c);

/// Empty where the input names no soil. Throws RunError where the macro-element carries the pipe in no equilibrium, and where a run is not of these waves.
std::optional<Displacements> displacements_of(const SeaCase& c, const SeaAnswer& answer);

}  // namespace berm::sea
