// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Unsigned integers of 128 bits: the compiler's own, or two words where it has none, as on machines of 32 bits.
#pragma once

#include <cstdint>

namespace hg {

// What the library asks of such a number, modulo 2^128. A shift is by 0 to 127 bits.
class TwoWords {
 public:
  constexpr TwoWords(uint64_t low = 0) : low_(low) {}
  constexpr TwoWords(uint64_t high, uint64_t low) : high_(high), low_(low) {}

  static constexpr TwoWords product(uint64_t a, uint64_t b) {
    const uint64_t a0 = a & kHalf, a1 = a >> 32, b0 = b & kHalf, b1 = b >> 32;
    const uint64_t lowest = a0 * b0;
    const uint64_t middle = a1 * b0 + (lowest >> 32);  // below 2^64, and so is the next
    const uint64_t other = a0 * b1 + (middle & kHalf);
    return {a1 * b1 + (middle >> 32) + (other >> 32), other << 32 | (lowest & kHalf)};
  }

  explicit constexpr operator uint64_t() const { return low_; }

  constexpr TwoWords operator<<(int bits) const {
    if (bits == 0) return *this;
    if (bits >= 64) return {low_ << (bits - 64), 0};
    return {high_ << bits | low_ >> (64 - bits), low_ << bits};
  }
  constexpr TwoWords operator>>(int bits) const {
    if (bits == 0) return *this;
    if (bits >= 64) return {0, high_ >> (bits - 64)};
    return {high_ >> bits, low_ >> bits | high_ << (64 - bits)};
  }
  constexpr TwoWords operator-() const { return {~high_ + (low_ == 0 ? 1 : 0), ~low_ + 1}; }
  constexpr TwoWords &operator+=(const TwoWords &other) {
    low_ += other.low_;
    high_ += other.high_ + (low_ < other.low_ ? 1 : 0);
    return *this;
  }

  friend constexpr TwoWords operator+(TwoWords a, const TwoWords &b) { return a += b; }
  friend constexpr bool operator==(const TwoWords &a, const TwoWords &b) {
    return a.high_ == b.high_ && a.low_ == b.low_;
  }
  friend constexpr bool operator<(const TwoWords &a, const TwoWords &b) {
    return a.high_ != b.high_ ? a.high_ < b.high_ : a.low_ < b.low_;
  }
  friend constexpr bool operator>(const TwoWords &a, const TwoWords &b) { return b < a; }

 private:
  static constexpr uint64_t kHalf = 0xffffffff;

  uint64_t high_ = 0, low_ = 0;
};

#if defined(__SIZEOF_INT128__)
__extension__ using Wide = unsigned __int128;
inline Wide wide_product(uint64_t a, uint64_t b) { return static_cast<Wide>(a) * b; }
#else
using Wide = TwoWords;
inline Wide wide_product(uint64_t a, uint64_t b) { return TwoWords::product(a, b); }
#endif

}  // namespace hg
