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
  constexpr size_t kMany = size_t{1} << 15;      // entries that are worth many counters
  constexpr size_t kCounters = size_t{1} << 14;  // 64 kB
  const bool few = count < kMany || sizeof(Entry) > sizeof(uint64_t) || bits > 48;
  const int longest = few ? 11 : (bits > 26 ? 12 : 13);
  const int digits = (bits + longest - 1) / longest, width = digits == 0 ? 0 : (bits + digits - 1) / digits;
  uint32_t begin[kCounters];
  std::fill(begin, begin + (static_cast<size_t>(digits) << width), 0u);
  const size_t mask = (size_t{1} << width) - 1;
  const auto digit_of = [&](const Entry &entry, int digit) {
    return static_cast<size_t>(uint64_t{key(entry)} >> (digit * width)) & mask;
  };
  for (size_t i = 0; i < count; i++) {
    for (int digit = 0; digit < digits; digit++)
      begin[(static_cast<size_t>(digit) << width) + digit_of(from[i], digit)]++;
  }
  for (int digit = 0; digit < digits; digit++) {
    uint32_t *of_digit = begin + (static_cast<size_t>(digit) << width);
    if (count == 0 || of_digit[digit_of(from[0], digit)] == count) continue;  // all the same
    uint32_t sum = 0;
    for (size_t n = 0; n <= mask; n++) sum += std::exchange(of_digit[n], sum);
    for (size_t i = 0; i < count; i++) other[of_digit[digit_of(from[i], digit)]++] = from[i];
    std::swap(from, other);
  }
  return from;
}

// The same for numbers that are their own keys and mostly differ in their upper bits: sorts by these, and then what
// they leave together.
inline uint64_t *radix_sort_from_top(uint64_t *from, uint64_t *other, size_t count, int bits) {
  constexpr int kTop = 33;         // three digits
  constexpr size_t kFew = 1 << 8;  // not worth digits
  const int low = bits > kTop ? bits - kTop : 0;
  uint64_t *sorted = radix_sort(from, other, count, bits - low, [low](uint64_t key) { return key >> low; });
  uint64_t *room = sorted == from ? other : from;
  for (size_t first = 0, end = 1; low > 0 && end <= count; end++) {
    if (end < count && sorted[end] >> low == sorted[first] >> low) continue;
    if (end - first > kFew) {
      const uint64_t *run =
          radix_sort(sorted + first, room + first, end - first, low, [](uint64_t key) { return key; });
      if (run != sorted + first) std::copy(run, run + (end - first), sorted + first);
    } else if (end - first > 1) {
      std::sort(sorted + first, sorted + end);
    }
    first = end;
  }
  return sorted;
}

}  // namespace hg
