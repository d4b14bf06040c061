// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sea/displacement.hpp"

namespace berm::sea {

struct MeanAndScatter {
  Real mean = 0, deviation = 0;  ///< NaN of one value
};
MeanAndScatter mean_and_scatter(const std::vector<Real>& values);

/// Numbers of displacements, m: of all seeds over the whole duration, and of the largest waves of the first one.
struct MovedPipe {
  MeanAndScatter largest, end, half_cycle, embedment;
  Real largest_of_all = 0;
  TrackNumbers waves_of_first;
};
MovedPipe moved_pipe(const SeaCase& c, const Displacements& moved);

/// The answer.
std::vector<std::string> words_of(const SeaCase& c, const Displacements& moved);

/// Draws track.png and distribution.png into a folder, and gives the part of the page that has them.
std::string displacement_section(const SeaCase& c, const Displacements& moved, const std::filesystem::path& folder);

/// A picture of a folder, for a page.
std::string picture(const std::filesystem::path& folder, const char* name, const char* alt);

/// time_s,u_m,w_m.
std::string csv_of(const Track& track);

}  // namespace berm::sea
