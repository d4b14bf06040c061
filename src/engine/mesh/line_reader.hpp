// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace berm::mesh {

/// Reads the lines of a text file, word by word. Blank lines are skipped. Anything unexpected is an InputError with file and
/// line.
class Lines {
public:
  /// Reads the whole file. Throws InputError where it does not exist.
  explicit Lines(const std::filesystem::path& path);

  /// Goes to the next line; false at the end of the file.
  bool next();
  /// Goes to the next line; `expected` describes what it should hold.
  void need(const char* expected);
  /// The line without leading and trailing blanks.
  std::string_view text() const { return line_; }

  /// The next word of this line as a whole number from `min` to `max`, or as a finite number.
  BigIndex integer(const char* expected, BigIndex min, BigIndex max);
  Real real(const char* expected);
  /// A count of items that take at least `bytes` of the file each: more than the rest of the file can hold are refused
  /// before memory is allocated.
  BigIndex count(const char* expected, BigIndex bytes);
  bool at_end() const { return rest_.empty(); }
  void need_end(const char* expected) const;

  /// Throws an InputError at this line: "FILE:LINE: MESSAGE".
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail_expected(const char* expected) const;

private:
  std::string_view word(const char* expected);

  std::string name_, content_;
  std::size_t position_ = 0;
  BigIndex number_ = 0;
  std::string_view line_, rest_;
};

}  // namespace berm::mesh
