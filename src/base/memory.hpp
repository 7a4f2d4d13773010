// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Memory of a grid: every byte comes from the allocator that the grid was created with, and is counted.
#pragma once

#include <hgrid/base.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace hg {

// malloc, realloc and free.
hg_allocator system_allocator();

class Memory {
 public:
  explicit Memory(const hg_allocator &allocator) : allocator_(allocator) {}
  Memory(const Memory &) = delete;
  Memory &operator=(const Memory &) = delete;

  void *allocate(size_t size);  // throws HG_ERR_MEMORY
  void *reallocate(void *memory, size_t old_size, size_t new_size);
  void release(void *memory, size_t size) noexcept;

  const hg_allocator &allocator() const { return allocator_; }
  int64_t bytes() const { return bytes_.load(std::memory_order_relaxed); }

 private:
  hg_allocator allocator_;
  std::atomic<int64_t> bytes_{0};
};

// count * size, or HG_ERR_MEMORY where that overflows.
size_t array_bytes(size_t count, size_t size);

// An array that grows and does not shrink by itself. Its elements are plain values and start undefined.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  explicit Buffer(Memory &memory) : memory_(&memory) {}
  ~Buffer() { release(); }
  Buffer(const Buffer &) = delete;
  Buffer &operator=(const Buffer &) = delete;
  Buffer(Buffer &&other) noexcept
      : memory_(other.memory_),
        data_(std::exchange(other.data_, nullptr)),
        capacity_(std::exchange(other.capacity_, 0)) {}

  T *data() { return data_; }
  const T *data() const { return data_; }
  T &operator[](size_t i) { return data_[i]; }
  const T &operator[](size_t i) const { return data_[i]; }
  size_t capacity() const { return capacity_; }

  // Room for `count` elements; what is there stays. Grows by half at least, so that appending is cheap.
  void grow(size_t count) {
    if (count <= capacity_) return;
    const size_t half_more = capacity_ + capacity_ / 2;
    const size_t wanted = count > half_more ? count : half_more;
    data_ = static_cast<T *>(memory_->reallocate(data_, capacity_ * sizeof(T), array_bytes(wanted, sizeof(T))));
    capacity_ = wanted;
  }

  // Room for `count` elements; what is there is lost.
  void require(size_t count) {
    if (count <= capacity_) return;
    const size_t size = array_bytes(count, sizeof(T));
    release();
    data_ = static_cast<T *>(memory_->allocate(size));
    capacity_ = count;
  }

  // Back to no elements.
  void release() {
    memory_->release(data_, capacity_ * sizeof(T));
    data_ = nullptr;
    capacity_ = 0;
  }

  // As require, with an eighth to spare where it must grow: for sizes that change a little from step to step.
  void require_room(size_t count) {
    if (count > capacity_) require(count + count / 8);
  }

 private:
  Memory *memory_;
  T *data_ = nullptr;
  size_t capacity_ = 0;
};

}  // namespace hg
