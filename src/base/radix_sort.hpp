// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Sorts by unsigned keys, digit by digit from the least: O(N), stable.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace hg {

// How many bits a number has.
inline int bit_width(uint64_t n) { return n == 0 ? 0 : 64 - __builtin_clzll(n); }

// Sorts from[0 .. count) by `bits` bits of key(entry). `other` has as much room; what is returned is that of the two
// that holds the sorted entries.
template <class Entry, class Key>
Entry *radix_sort(Entry *from, Entry *other, size_t count, int bits, Key &&key) {
  constexpr int kDigit = 11, kMostDigits = 6;  // of 64 bits
  const int digits = (bits + kDigit - 1) / kDigit;
  uint32_t begin[kMostDigits][1 << kDigit];
  std::fill(begin[0], begin[0] + (static_cast<size_t>(digits) << kDigit), 0u);
  const auto digit_of = [&](const Entry &entry, int digit) {
    return static_cast<size_t>(uint64_t{key(entry)} >> (digit * kDigit)) & ((size_t{1} << kDigit) - 1);
  };
  for (size_t i = 0; i < count; i++) {
    for (int digit = 0; digit < digits; digit++) begin[digit][digit_of(from[i], digit)]++;
  }
  for (int digit = 0; digit < digits; digit++) {
    if (count == 0 || begin[digit][digit_of(from[0], digit)] == count) continue;  // all the same
    uint32_t sum = 0;
    for (uint32_t &here : begin[digit]) sum += std::exchange(here, sum);
    for (size_t i = 0; i < count; i++) other[begin[digit][digit_of(from[i], digit)]++] = from[i];
    std::swap(from, other);
  }
  return from;
}

}  // namespace hg
