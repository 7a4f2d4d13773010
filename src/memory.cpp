// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "memory.hpp"

#include "error.hpp"

#include <cstdlib>

namespace hg {

hg_allocator system_allocator() {
  hg_allocator allocator;
  allocator.context = nullptr;
  allocator.allocate = [](void *, size_t size) { return std::malloc(size); };
  allocator.reallocate = [](void *, void *memory, size_t, size_t size) { return std::realloc(memory, size); };
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
