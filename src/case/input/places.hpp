// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/document.hpp"

#include <memory>

namespace berm::input {

/// Where the keys of a case were written, for what is found after reading. Without a document (a case that was made by the program) keys have no place.
class Places {
public:
  Places() = default;
  /// `stages`: for each stage of the case the number of the one in the document, where that has others (settings::expand_sweeps).
  explicit Places(Document document, std::vector<std::size_t> stages = {})
      : document_(std::make_shared<const Document>(std::move(document))),
        stages_(std::move(stages))
  {
  }

  /// Where a key was written, "stage[2].until"; the line of the nearest table where it was not. Of a drag of a sweep it is the sweep's own key: what ends it
  /// is `amplitude`.
  Located located(const std::string& key, const std::string& message) const;
  Located located(const KeyError& error) const;

  /// Whether the file or an override has this key.
  bool has(const std::string& key) const;
  /// Whether somebody wrote it: in a case that berm has written whole, an override.
  bool is_given(const std::string& key) const;

private:
  std::string written(const std::string& key) const;

  std::shared_ptr<const Document> document_;
  std::vector<std::size_t> stages_;
};

}  // namespace berm::input
