// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A fuzzer's input taken apart into choices and doubles. Past its end every value is 0.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace fuzz {

class Bytes {
 public:
  Bytes(const uint8_t *data, size_t size) : data_(data), left_(size) {}

  bool empty() const { return left_ == 0; }

  uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }

  // In 0 .. bound - 1, bound <= 256.
  int below(int bound) { return byte() % bound; }

  // Any 64 bits as a double: NaN, infinities and subnormals come.
  double any_double() {
    uint64_t bits = 0;
    for (int k = 0; k < 8; k++) bits = bits << 8 | byte();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  // Mostly eighths, so that particles meet and touch; at times one that came before, moved by a few units in the last
  // place, a power of two, or any bits.
  double number() {
    double value = 0;
    switch (below(8)) {
      case 0:
        value = any_double();
        break;
      case 1:
        value = std::ldexp(below(2) == 0 ? 1 : -1, static_cast<int8_t>(byte()) * 8);
        break;
      case 2:
        value = before_[below(kKept)];
        for (int ulps = below(4); ulps > 0; ulps--) value = std::nextafter(value, 0);
        break;
      case 3:
        value = before_[below(kKept)] + before_[below(kKept)];
        break;
      default:
        value = static_cast<int8_t>(byte()) / 8.0;
    }
    before_[next_++ % kKept] = value;
    return value;
  }

  // As number(), but without a sign unless all its bits were drawn.
  double length() {
    const double value = number();
    return value < 0 && below(16) != 0 ? -value : value;
  }

 private:
  static constexpr int kKept = 8;
  const uint8_t *data_;
  size_t left_;
  double before_[kKept] = {};
  unsigned next_ = 0;
};

}  // namespace fuzz
