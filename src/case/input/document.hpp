// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "os/error.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berm::input {

/// A value of an input file, with its location.
struct Node {
  enum class Kind { boolean, whole, number, text, date, array, table };

  Kind kind = Kind::table;
  std::string key;          ///< in the table that it belongs to; empty in an array
  bool truth = false;       ///< boolean
  std::int64_t whole = 0;   ///< whole
  Real number = 0;          ///< number
  std::string text;         ///< text
  std::vector<Node> items;  ///< of an array in their order; of a table in the order of the file
  int line = 0, column = 0;
  std::string override_key;  ///< the KEY of `--set KEY=VALUE` that made it; empty where the file did
  bool implied = false;      ///< a table that an override passed through and that the file does not have
  bool used = false;         ///< read by some struct
};

/// An input file as written.
struct Document {
  std::string file;
  Node root;
  bool resolved = false;  ///< written by berm with every key in it, whoever gave them
};

/// The first line of a case that berm has written with every key in it.
constexpr std::string_view resolved_heading = "# The whole case: every default filled in, numbers in SI units, angles in radians.\n";

/// Reads a TOML file. Throws InputError "FILE:LINE: ..." where it is not TOML, "FILE: ..." where it cannot be read.
Document parse_file(const std::filesystem::path& file);

/// As parse_file, of a text; `file` is for the messages.
Document parse_text(const std::string& file, const std::string& text);

/// Bytes of a case at most.
constexpr std::size_t max_case_bytes = 1'000'000;

/// The single TOML value that a text is; empty where it is not one.
std::optional<Node> parse_value(const std::string& text);

/// The entry of a table with this key, or null; null also where `table` is no table.
const Node* member(const Node& table, const std::string& key);
Node* member(Node& table, const std::string& key);

/// The text under `name` in an item of an array of tables, by which --set and messages address it; "" where it has none.
std::string name_of(const Node& item);

/// Kind of a node, for messages: "a number", "text in quotes".
std::string kind_of(const Node& node);

/// What is to be said of an input, and of which place.
struct Located {
  std::string file = {};          ///< "" where no file was read
  int line = 0;                   ///< 0: of no line
  std::string override_key = {};  ///< the KEY of `--set KEY=VALUE` that it is about; "" where it is about the file
  std::string key = {};           ///< dotted; "" where it is about no key, such as a text that is not TOML
  std::string message = {};
  std::string word = {};                  ///< that was written instead of one of those that are allowed
  std::vector<std::string> allowed = {};  ///< words; none where it is about no word

  /// "FILE:LINE: KEY: MESSAGE", with "--set KEY" instead of FILE:LINE where an override is meant, and what is allowed behind it.
  std::string text() const;
};

/// A wrong input whose place is known.
struct LocatedError : InputError {
  explicit LocatedError(Located what) : InputError(what.text()), located(std::move(what)) {}
  Located located;
};

/// Of a node; `path` is its key.
Located located(const Document& document, const Node& node, const std::string& path, const std::string& message);

/// Throws LocatedError of a node; `word` was written there instead of one of those that are `allowed`.
[[noreturn]] void refuse(const Document& document, const Node& node, const std::string& path, const std::string& message,
                         const std::string& word = "", const std::vector<std::string>& allowed = {});

}  // namespace berm::input
