// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/frame_reader.hpp"

namespace berm::report {

/// A field that colours the soil of a film: what it is in the frames' files, and what FilmData of web/src/data.ts calls it.
struct FilmField {
  std::string source;             ///< name in the files
  std::string name, label, unit;  ///< on the page
  Real factor;                    ///< of the files' numbers; of a vector's length
  bool summed;                    ///< the files tell it since the frame before
  bool spare;                     ///< goes where the page has no room, before frames do
};

/// The fields of a film, of all that the files hold numbers and vectors of: first those that are wanted most, the last ones go where the page has no room.
/// `body` is the word of the rigid body that is driven; "" where none is.
std::vector<FilmField> film_fields(const std::vector<run_folder::FieldValues<float>>& fields, const std::string& body);

}  // namespace berm::report
