// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of whole systems, on large pages where the system has them: contacts jump through memory, and to find a small
// page takes as long as to read it.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace dem {

template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class Other>
  LargePages(const LargePages<Other> &) {}  // NOLINT: allocators convert

  T *allocate(size_t count) {
    constexpr size_t kPage = size_t{2} << 20, kLine = 64;
    if (count > (static_cast<size_t>(-1) - kPage) / sizeof(T)) throw std::bad_alloc();
    const size_t bytes = count * sizeof(T), alignment = bytes < kPage / 2 ? kLine : kPage;
    void *block = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    if (block == nullptr) throw std::bad_alloc();
#ifdef __linux__
    if (alignment == kPage) madvise(block, bytes, MADV_HUGEPAGE);  // advice: nothing is lost if it is not taken
#endif
    return static_cast<T *>(block);
  }
  void deallocate(T *block, size_t) { std::free(block); }

  template <class Other>
  bool operator==(const LargePages<Other> &) const {
    return true;
  }
  template <class Other>
  bool operator!=(const LargePages<Other> &) const {
    return false;
  }
};

template <class T>
using LargeArray = std::vector<T, LargePages<T>>;

}  // namespace dem
