// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/core/fields_test.cpp
#include "os/lazy_memory.hpp"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <sys/mman.h>

namespace berm {
namespace {

constexpr std::size_t large = 1 << 17, huge_page = 1 << 21;

}  // namespace

void* zero_memory(std::size_t bytes, std::size_t alignment)
{
  if (bytes < large) {
    const std::size_t room = (bytes + alignment - 1) / alignment * alignment;
    void* const memory = std::aligned_alloc(alignment, room);
    if (memory == nullptr) throw std::bad_alloc();
    return std::memset(memory, 0, room);
  }
  void* const memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  return memory;
}

void free_zero_memory(void* memory, std::size_t bytes) noexcept
{
  if (bytes < large)
    std::free(memory);
  else
    ::munmap(memory, bytes);
}

void ask_for_huge_pages(void* memory, std::size_t bytes)
{
  const std::size_t before = (huge_page - reinterpret_cast<std::uintptr_t>(memory) % huge_page) % huge_page;
  if (bytes < before + huge_page) return;
  // Failure is harmless: the run is only slower.
  ::madvise(static_cast<char*>(memory) + before, (bytes - before) / huge_page * huge_page, MADV_HUGEPAGE);
}

}  // namespace berm
