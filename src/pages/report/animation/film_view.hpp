// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "report/animation/film_quantization.hpp"

namespace berm::report {

/// What a film shows first: the surroundings of the driven body's whole path, as far as there is soil or room for it; all of the soil without one. `soil` is
/// the box of the soil in all frames.
FilmBox film_view(const record::RunRecord& run, const FilmBox& soil);

/// The level of the soil's original surface, m; none where it is not flat or not known.
std::optional<Real> film_surface(const record::RunRecord& run);

}  // namespace berm::report
