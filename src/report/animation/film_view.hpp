// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/animation/film_quantization.hpp"
#include "structures/pipe/run_record.hpp"

namespace berm::report {

/// What a film shows first: the surroundings of the pipe's whole path, as far as there is soil or room for it; all of the soil without a pipe. `soil` is
/// the box of the soil in all frames.
FilmBox film_view(const pipe::RunRecord& run, const FilmBox& soil);

/// The level of the soil's original surface, m; none where it is not flat or not known.
std::optional<Real> film_surface(const problem::Case& settings);

}  // namespace berm::report
