// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm {

/// Vector unit that the loaded engine was compiled for: "x86-64-v4", "x86-64-v3" or "baseline". Results differ between them
/// in the last bits.
const char* vector_unit();

}  // namespace berm
