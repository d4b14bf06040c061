// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

#include <nlohmann/json.hpp>

namespace berm::report {

/// A named piece of compressed numbers: base64 of a zlib stream.
struct FilmBlock {
  std::string id, base64;
};

/// The soil of a run, frame by frame, as the page shows it.
struct Film {
  nlohmann::ordered_json json;  ///< FilmData of web/src/data.ts; null where there is nothing to show
  std::vector<FilmBlock> blocks;
  std::vector<std::string> faults;  ///< frames that are missing or damaged, in words
};

/// Reads the frames of a run; `most_bytes` is how much the blocks may take together: where they would take more, frames are left out evenly
/// (never the last of a stage). Ids begin with `prefix`. In space the film shows the
/// slice in the middle, and has a film of the whole, `space`.
Film make_film(const record::RunRecord& run, const std::string& prefix, std::size_t max_bytes);

}  // namespace berm::report
