// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "desk/folder.hpp"

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>

namespace berm::desk {

/// The last bytes of a text file, whole lines of it.
std::string tail_of(const std::filesystem::path& file, std::size_t bytes);

/// A word that is another where the run began anew, was resumed or ended: what was read of it before may not hold.
std::string identity_of(const std::filesystem::path& run);

/// With what the log adds: a run writes it to its very end.
std::string identity_with_log(const std::filesystem::path& run);

/// How far a run is, as the last line of its log has it.
struct Advance {
  double done = 0;    ///< 0 ... 1
  double left_s = 0;  ///< NaN: not said
};
std::optional<Advance> advance_in(const std::string& log_tail);

/// What grows while runs are at work. A history is read from where the last answer ended, so that asking once a second costs what was written since.
class Live {
public:
  explicit Live(const Folder& folder) : folder_(folder) {}

  /// {of, columns, rows, from_row, more}: rows of history.csv from that number on, some thousands at most; `of` is another word where the run began anew or was resumed.
  Json rows(const std::filesystem::path& run, std::size_t from_row);

private:
  /// Where a row begins.
  struct Place {
    std::size_t row = 0;
    std::uintmax_t offset = 0;
    std::string of{};
  };
  const Folder& folder_;
  std::mutex mutex_;
  std::map<std::string, Place> places_;
};

/// The last frame of a run when there are more than `after` + 1 of them; nothing where there are not. `field`: the one to colour by; "": the first of a usual list.
std::optional<Json> soil_of(const Folder& folder, const std::filesystem::path& run, long after, const std::string& field);

}  // namespace berm::desk
