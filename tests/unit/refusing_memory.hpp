// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// An allocator that refuses, once told to.
#pragma once

#include "src/base/memory.hpp"

#include <cstdlib>
#include <limits>

namespace hgtest {

inline int requests_left = std::numeric_limits<int>::max();

inline bool is_granted() { return requests_left == std::numeric_limits<int>::max() || requests_left-- > 0; }

inline hg_allocator refusing_allocator() {
  hg_allocator allocator = hg::system_allocator();
  allocator.allocate = [](void *, size_t size) { return is_granted() ? std::malloc(size) : nullptr; };
  allocator.reallocate = [](void *, void *memory, size_t, size_t size) {
    return is_granted() ? std::realloc(memory, size) : nullptr;
  };
  return allocator;
}

// While it lives, only so many requests are granted.
class RefuseMemory {
 public:
  explicit RefuseMemory(int granted) { requests_left = granted; }
  ~RefuseMemory() { requests_left = std::numeric_limits<int>::max(); }
  RefuseMemory(const RefuseMemory &) = delete;
  RefuseMemory &operator=(const RefuseMemory &) = delete;
};

}  // namespace hgtest
