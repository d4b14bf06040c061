// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace berm::desk {

using Json = nlohmann::ordered_json;

/// A request is not answered: the status of HTTP, and why in one sentence.
struct Refusal : std::runtime_error {
  Refusal(int status_, const std::string& why, Json more_ = Json::object())
      : std::runtime_error(why),
        status(status_),
        more(std::move(more_))
  {
  }

  int status;
  Json more;  ///< file, line and key, where they are known
};

}  // namespace berm::desk
