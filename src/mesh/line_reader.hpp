// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace berm::mesh {

/// The lines of a text file, read one after the other and word by word. Blank lines are passed over. Everything that is not as expected becomes
/// an InputError that names file and line.
class Lines {
public:
  /// Reads the whole file. Throws InputError where there is none.
  explicit Lines(const std::filesystem::path& path);

  /// Goes to the next line; false at the end of the file.
  bool next();
  /// Goes to the next line; `expected` says in words what it should hold.
  void need(const char* expected);
  /// The line without blanks at its ends.
  std::string_view text() const { return line_; }

  /// The next word of this line as a whole number from `least` to `most`, or as a finite number.
  BigIndex integer(const char* expected, BigIndex min, BigIndex max);
  Real real(const char* expected);
  /// A number of things that need at least `bytes` of file each: more than could follow is refused before any memory is taken for them.
  BigIndex count(const char* expected, BigIndex bytes);
  bool at_end() const { return rest_.empty(); }
  void need_end(const char* expected) const;

  /// Throws an InputError at this line: "FILE:LINE: MESSAGE".
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail_expected(const char* expected) const;

private:
  std::string_view word(const char* expected);

  std::string name_, content_;
  std::size_t place_ = 0;
  BigIndex number_ = 0;
  std::string_view line_, rest_;
};

}  // namespace berm::mesh
