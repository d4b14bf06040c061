// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sanity/finding.hpp"
#include "sanity/scene.hpp"

namespace berm::sanity {

/// Asks all questions (questions.hpp): does what is asked make sense? Refusals come first.
std::vector<Finding> ask(const Scene& scene);

/// About what frames and history take of the disk, bytes; stages of unknown duration are counted with their begin and end.
Real disk_of(const Scene& scene);

/// "322 MB".
std::string words_of_bytes(Real bytes);

/// "FILE:LINE: KEY: MESSAGE" of a finding.
std::string words_of(const Finding& finding, const input::Places& places);

}  // namespace berm::sanity
