// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A number of each particle that most callers never give: it takes neither memory nor time until one does.
#pragma once

#include "src/base/memory.hpp"

#include <algorithm>
#include <cstddef>

namespace hg {

template <class T>
class OptionalColumn {
 public:
  // What particles have of which nothing is said.
  OptionalColumn(Memory &memory, T nothing) : values_(memory), nothing_(nothing) {}

  // By slot; NULL while nothing is said of any.
  const T *data() const { return given_ ? values_.data() : nullptr; }

  void forget() { given_ = false; }
  // Room for more slots, of which nothing is said yet once they count.
  void grow(size_t slots, size_t more) {
    if (!given_) return;
    values_.grow(slots + more);
    std::fill_n(values_.data() + slots, more, nothing_);
  }
  void give(size_t slots, const T *values) {
    values_.grow(slots);
    std::copy_n(values, slots, values_.data());
    given_ = true;
  }
  bool is(size_t slots, const T *values) const { return given_ && std::equal(values, values + slots, values_.data()); }
  void move(size_t from, size_t to) {
    if (given_) values_[to] = values_[from];
  }

 private:
  Buffer<T> values_;
  T nothing_;
  bool given_ = false;
};

}  // namespace hg
