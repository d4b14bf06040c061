// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "desk/refusal.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace berm::desk {

/// The folder that a desk serves. Nothing outside of it is read or written for a client.
class Folder {
public:
  /// Throws InputError where there is none.
  explicit Folder(const std::filesystem::path& root);

  const std::filesystem::path& root() const { return root_; }
  /// The real path of what a client calls `name` ("bay/case.toml"; "" is the folder itself), whether it is there or not. Throws Refusal where it is no relative path, has
  /// "..", a hidden folder or a name that an option could have, or leaves the folder by a link.
  std::filesystem::path inside(const std::string& name) const;
  /// The path without links of one in the folder, whether it is there or not. Throws Refusal 403 where a link leads out of the folder.
  std::filesystem::path real(const std::filesystem::path& path) const;
  /// Throws Refusal 403 where a link in an inner folder, which a command is about to read, leads out of this one.
  void refuse_links_out(const std::filesystem::path& inner) const;
  /// The same of a case or another input, NAME.toml; of a run.
  std::filesystem::path input(const std::string& name) const;
  std::filesystem::path run(const std::string& name) const;
  /// What a client calls a real path inside.
  std::string name_of(const std::filesystem::path& path) const;

  /// {cases, studies, runs, folders} of an inner folder: what lies in it, not deeper.
  Json contents(const std::string& name) const;
  /// The folders of all runs inside, but for those inside of other runs.
  std::vector<std::filesystem::path> runs() const;

  /// The text of an input, with a mark that changes with it.
  Json read(const std::string& name) const;
  /// Writes {text, modified}, whole; Refusal 409 where the file is another than that of the mark, or is there and no mark is given.
  Json write(const std::string& name, const Json& body) const;

private:
  std::filesystem::path root_;
};

/// A text in the body of a request; Refusal where it is missing or none.
std::string text_in(const Json& body, const char* key);
std::string text_in(const Json& body, const char* key, const std::string& otherwise);
/// Several of them; none where there are none.
std::vector<std::string> texts_in(const Json& body, const char* key);

}  // namespace berm::desk
