// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/animation/film_fields_of_frames.hpp"

namespace berm::report {

/// What colours the soil of a film.
enum class FilmField { deviatoric_strain, incremental_deviatoric_strain, mean_stress, speed, displacement };

/// A field by its name in FilmData of web/src/data.ts, in words, and its unit.
struct FieldWords {
  std::string name, label, unit;
};
FieldWords words_of(FilmField field, bool with_pipe);

/// Values of a field by frame, then point. The increments count from the frame before, times `increment_factor` of the frame; 0 in the first.
std::vector<float> field_values(FilmField field, const std::vector<const FilmFrame*>& frames, const std::vector<Real>& increment_factor);

}  // namespace berm::report
