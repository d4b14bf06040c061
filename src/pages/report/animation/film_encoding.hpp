// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/animation/film.hpp"
#include "report/animation/film_frames.hpp"

namespace berm::report {

/// The film of those frames that are kept, with the first `fields` of the footage's fields, without a note. Ids of blocks begin with `prefix`.
Film encoded_film(const record::RunRecord& run, const FilmFrames& footage, const std::vector<Index>& kept, std::size_t fields,
                  const std::string& prefix);

}  // namespace berm::report
