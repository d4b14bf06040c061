// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace berm {

/// Memory that is zero and of which the machine gives no page before it is written. A large one is asked of the system itself: the C library may hand out
/// what was used and freed before, and has to write zeros into it. alignment: at most that of a page. Throws std::bad_alloc.
void* zero_memory(std::size_t bytes, std::size_t alignment);
void free_zero_memory(void* memory, std::size_t bytes) noexcept;

/// Asks for pages of 2 MiB where such fit between the two ends of this memory, which should not have been written yet and will be all of it: a step goes
/// through more particles than the processor remembers the places of in pages of 4 KiB.
void ask_for_huge_pages(void* memory, std::size_t bytes);

}  // namespace berm
