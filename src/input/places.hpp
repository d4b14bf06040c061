// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/document.hpp"

#include <memory>

namespace berm::input {

/// Where the keys of a case were written, for what is found after reading. Without a document (a case that was made by the program) keys have no place.
class Places {
public:
  Places() = default;
  explicit Places(Document document) : document_(std::make_shared<const Document>(std::move(document))) {}

  /// "FILE:LINE: KEY: MESSAGE" of a key, "stage[2].until"; "--set KEY" instead of FILE:LINE where an override wrote it; the line of the nearest table where
  /// nothing did.
  std::string located(const std::string& key, const std::string& message) const;
  /// The same of "KEY: MESSAGE", as KeyError has it.
  std::string located(const std::string& key_and_message) const;

  /// Whether the file or an override has this key.
  bool has(const std::string& key) const;

private:
  std::shared_ptr<const Document> document_;
};

}  // namespace berm::input
