// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace berm {

/// Zeroed memory whose pages are committed when first written. Large blocks come from the system itself: the C library may
/// reuse freed memory, which it has to clear. alignment: at most a page. Throws std::bad_alloc.
void* zero_memory(std::size_t bytes, std::size_t alignment);
void free_zero_memory(void* memory, std::size_t bytes) noexcept;

/// Advises pages of 2 MiB between the two ends of memory that is not yet written and will all be used: a step visits more
/// particles than the processor's TLB covers with pages of 4 KiB.
void ask_for_huge_pages(void* memory, std::size_t bytes);

}  // namespace berm
