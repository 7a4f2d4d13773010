// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of callers, who may pack bytes: one that does not lie on the boundary of its type is copied to where it does,
// as reading it in place would be undefined.
#pragma once

#include "bindings/c/guard.hpp"
#include "src/base/memory.hpp"

#include <cstdint>
#include <cstring>

namespace hg {

template <class T>
class Aligned {
 public:
  // `count` rows of `width` values, not NULL unless there are none. The copy, if it takes one, comes from the allocator
  // of the grid.
  Aligned(const Grid &grid, const char *name, const T *values, size_t count, size_t width = 1)
      : memory_(grid.allocator()), copy_(memory_), values_(values) {
    if (count > 0) check_pointer(values, name);
    if (reinterpret_cast<uintptr_t>(values) % alignof(T) == 0) return;
    copy_.require(array_bytes(count, width));
    std::memcpy(copy_.data(), static_cast<const void *>(values), count * width * sizeof(T));
    values_ = copy_.data();
  }

  const T *get() const { return values_; }

 private:
  Memory memory_;
  Buffer<T> copy_;
  const T *values_;
};

}  // namespace hg
