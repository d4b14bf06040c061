// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/io/revision_test.cpp
#pragma once

#include <string>

namespace berm::io {

/// The commit that the sources are of, with a + where files were changed since; "" where it is not known. cmake/Revision.cmake writes it.
extern const char* const revision;

/// "0.1.0 (1a2b3c4d5e)".
inline std::string version_words()
{
  const std::string version = BERM_VERSION;
  return *revision == '\0' ? version : version + " (" + revision + ")";
}

}  // namespace berm::io
