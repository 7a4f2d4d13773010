// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/base/memory.hpp"

#include "src/base/error.hpp"

#include <cstdlib>
#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace hg {

namespace {

// Building scatters over all of memory, where small pages cost a table walk each: asks for large ones. Advice only. It
// is given for the whole of the pages that malloc mapped, as realloc must copy memory of which only a part has it.
void *with_large_pages(void *memory, size_t size) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr size_t kPage = 4096;
  constexpr size_t kWorthIt = size_t{1} << 20;
  if (memory == nullptr || size < kWorthIt) return memory;
  const size_t into_page = reinterpret_cast<uintptr_t>(memory) % kPage;
  const size_t pages = (into_page + size + kPage - 1) / kPage;
  madvise(static_cast<char *>(memory) - into_page, pages * kPage, MADV_HUGEPAGE);
#else
  (void)size;
#endif
  return memory;
}

}  // namespace

hg_allocator system_allocator() {
  hg_allocator allocator;
  allocator.context = nullptr;
  allocator.allocate = [](void *, size_t size) { return with_large_pages(std::malloc(size), size); };
  allocator.reallocate = [](void *, void *memory, size_t, size_t size) {
    return with_large_pages(std::realloc(memory, size), size);
  };
  allocator.release = [](void *, void *memory, size_t) { std::free(memory); };
  return allocator;
}

void *Memory::allocate(size_t size) {
  if (size == 0) return nullptr;
  void *memory = allocator_.allocate(allocator_.context, size);
  if (memory == nullptr) fail(HG_ERR_MEMORY, "no memory for %zu bytes", size);
  bytes_ += static_cast<int64_t>(size);
  return memory;
}

void *Memory::reallocate(void *memory, size_t old_size, size_t new_size) {
  if (memory == nullptr) return allocate(new_size);
  void *moved = allocator_.reallocate(allocator_.context, memory, old_size, new_size);
  if (moved == nullptr) fail(HG_ERR_MEMORY, "no memory to grow from %zu to %zu bytes", old_size, new_size);
  bytes_ += static_cast<int64_t>(new_size) - static_cast<int64_t>(old_size);
  return moved;
}

void Memory::release(void *memory, size_t size) noexcept {
  if (memory == nullptr) return;
  allocator_.release(allocator_.context, memory, size);
  bytes_ -= static_cast<int64_t>(size);
}

size_t array_bytes(size_t count, size_t size) {
  size_t bytes = 0;
  if (__builtin_mul_overflow(count, size, &bytes)) fail(HG_ERR_MEMORY, "no memory for %zu elements", count);
  return bytes;
}

}  // namespace hg
