// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/exact/exact_sign.hpp"

#include "src/base/ordered_bits.hpp"
#include "src/base/wide.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hg {
namespace {

// A double is m * 2^e with an odd integer m of at most 53 bits and e in [-1074, 1023]. With all exponents taken
// relative to the least one present, sums become integers of at most 2097 + 53 + 33 (factor) + 4 (terms, sign) bits.
constexpr int kMaxLimbs = 35;
using Limb = uint64_t;

struct Parts {
  bool negative;
  Limb mantissa;  // odd, or 0
  int exponent;
};

Parts decompose(double value) {
  const Limb bits = bits_of(value);
  Parts parts{(bits >> 63) != 0, bits & ((Limb{1} << 52) - 1), static_cast<int>(bits >> 52 & 0x7ff)};
  if (parts.exponent != 0) {
    parts.mantissa |= Limb{1} << 52;
    parts.exponent -= 1075;
  } else {
    parts.exponent = -1074;
  }
  if (parts.mantissa != 0) {
    const int zeros = __builtin_ctzll(parts.mantissa);  // round numbers then need one limb or two
    parts.mantissa >>= zeros;
    parts.exponent += zeros;
  }
  return parts;
}

Limb size_of(int64_t factor) { return factor < 0 ? Limb{0} - static_cast<Limb>(factor) : static_cast<Limb>(factor); }

// A two's-complement integer of a run-time number of limbs, least significant first.
struct Integer {
  Limb limb[kMaxLimbs];

  void add(Wide magnitude, int shift, bool negative, int limbs) {
    const int first = shift / 64, bits = shift % 64;
    Limb part[3];
    part[0] = static_cast<Limb>(magnitude << bits);
    part[1] = static_cast<Limb>(magnitude >> 64 << bits);
    if (bits != 0) part[1] |= static_cast<Limb>(magnitude) >> (64 - bits);
    part[2] = bits != 0 ? static_cast<Limb>(magnitude >> 64) >> (64 - bits) : 0;
    Limb carry = 0;
    for (int k = first; k < limbs; k++) {
      const Limb term = k - first < 3 ? part[k - first] : 0;
      Limb result = 0;
      if (negative) {
        const bool borrow = __builtin_sub_overflow(limb[k], term, &result);
        const bool more = __builtin_sub_overflow(result, carry, &result);
        carry = borrow || more;
      } else {
        const bool over = __builtin_add_overflow(limb[k], term, &result);
        const bool more = __builtin_add_overflow(result, carry, &result);
        carry = over || more;
      }
      limb[k] = result;
    }
  }

  void make_positive(int limbs) {
    if (limb[limbs - 1] >> 63 == 0) return;
    Limb carry = 1;
    for (int k = 0; k < limbs; k++) {
      limb[k] = ~limb[k] + carry;
      carry = carry != 0 && limb[k] == 0;
    }
  }
};

// square += value * value, schoolbook; square has 2 * limbs + 1 limbs.
void add_square(Limb *square, const Integer &value, int limbs) {
  for (int i = 0; i < limbs; i++) {
    if (value.limb[i] == 0) continue;
    Limb carry = 0;
    for (int j = 0; j < limbs; j++) {
      const Wide sum = wide_product(value.limb[i], value.limb[j]) + square[i + j] + carry;
      square[i + j] = static_cast<Limb>(sum);
      carry = static_cast<Limb>(sum >> 64);
    }
    for (int k = i + limbs; carry != 0; k++) carry = __builtin_add_overflow(square[k], carry, &square[k]);
  }
}

// `negative`: of the sum, if asked for.
Integer to_integer(const ExactSum &sum, int least_exponent, int limbs, bool *negative = nullptr) {
  Integer integer;
  std::memset(integer.limb, 0, sizeof(Limb) * static_cast<size_t>(limbs));
  for (int k = 0; k < sum.count; k++) {
    const Parts parts = decompose(sum.terms[k].value);
    const int64_t factor = sum.terms[k].factor;
    if (parts.mantissa == 0 || factor == 0) continue;
    integer.add(wide_product(parts.mantissa, size_of(factor)), parts.exponent - least_exponent,
                parts.negative != (factor < 0), limbs);
  }
  if (negative != nullptr) *negative = integer.limb[limbs - 1] >> 63 != 0;
  integer.make_positive(limbs);
  return integer;
}

struct ExponentRange {
  int least = 4096, greatest = -4096;
  void include(const ExactSum &sum) {
    for (int k = 0; k < sum.count; k++) {
      const Parts parts = decompose(sum.terms[k].value);
      if (parts.mantissa == 0 || sum.terms[k].factor == 0) continue;
      least = std::min(least, parts.exponent);
      greatest = std::max(greatest, parts.exponent);
    }
  }
};

// Terms of 53 + 33 bits that lie at most this far apart have a sum of 126 bits.
constexpr int kWordShift = 37;

// |sum| in units of 2^least_exponent if it is below 2^63: nearly always so for particles that nearly touch, whose
// coordinates cancel.
bool fits_word(const ExactSum &sum, int least_exponent, Limb &size) {
  Wide total = 0;
  for (int k = 0; k < sum.count; k++) {
    const Parts parts = decompose(sum.terms[k].value);
    if (parts.mantissa == 0 || sum.terms[k].factor == 0) continue;
    const Wide term = wide_product(parts.mantissa, size_of(sum.terms[k].factor)) << (parts.exponent - least_exponent);
    total += parts.negative != (sum.terms[k].factor < 0) ? -term : term;
  }
  const Wide positive = total >> 127 == 0 ? total : -total;
  size = static_cast<Limb>(positive);
  return positive >> 63 == 0;
}

// Decides with squares of single words where it can.
bool decide_in_words(const ExactSum *difference, int dimension, const ExactSum &reach, const ExponentRange &range,
                     int &order) {
  if (range.greatest - range.least > kWordShift) return false;
  Limb size = 0;
  if (!fits_word(reach, range.least, size)) return false;
  const Wide reach2 = wide_product(size, size);
  Wide distance2 = 0;  // three squares below 2^126 each
  for (int axis = 0; axis < dimension; axis++) {
    if (!fits_word(difference[axis], range.least, size)) return false;
    distance2 += wide_product(size, size);
  }
  order = distance2 < reach2 ? -1 : (distance2 > reach2 ? 1 : 0);
  return true;
}

int limbs_for(const ExponentRange &range) { return (range.greatest - range.least + 53 + 33 + 4) / 64 + 1; }

// The highest bit that is set and the 63 below it; `more` if any other is set.
Limb leading_bits(const Integer &integer, int limbs, int &highest, bool &more) {
  int top = limbs - 1;
  while (top > 0 && integer.limb[top] == 0) top--;
  const int zeros = __builtin_clzll(integer.limb[top]);
  highest = 64 * top + 63 - zeros;
  const Limb below = top > 0 ? integer.limb[top - 1] : 0;
  more = false;
  for (int k = 0; k < top - 1; k++) more = more || integer.limb[k] != 0;
  if (zeros == 0) {
    more = more || below != 0;
    return integer.limb[top];
  }
  more = more || below << zeros != 0;
  return integer.limb[top] << zeros | below >> (64 - zeros);
}

}  // namespace

double round_exactly(const ExactSum &sum) {
  ExponentRange range;
  range.include(sum);
  if (range.greatest < range.least) return 0;  // every term is zero
  const int limbs = limbs_for(range);
  bool negative = false, more = false;
  const Integer integer = to_integer(sum, range.least, limbs, &negative);
  const bool is_zero = std::all_of(integer.limb, integer.limb + limbs, [](Limb limb) { return limb == 0; });
  if (is_zero) return 0;
  int highest = 0;
  const Limb bits = leading_bits(integer, limbs, highest, more);
  // 53 of 64 bits, to nearest. No number here has digits below the least subnormal one, so those never round.
  const Limb kept = bits >> 11, rest = bits & 0x7ff, half = 0x400;
  const bool up = rest > half || (rest == half && (more || (kept & 1) != 0));
  const double size = std::ldexp(static_cast<double>(kept + (up ? 1 : 0)), range.least + highest - 52);
  return negative ? -size : size;
}

int exact_order(const ExactSum *difference, int dimension, const ExactSum &reach) {
  ExponentRange range;
  range.include(reach);
  for (int axis = 0; axis < dimension; axis++) range.include(difference[axis]);
  if (range.greatest < range.least) return 0;  // every term is zero
  int order = 0;
  if (decide_in_words(difference, dimension, reach, range, order)) return order;
  const int limbs = limbs_for(range);

  Limb left[2 * kMaxLimbs + 1], right[2 * kMaxLimbs + 1];
  const size_t size = sizeof(Limb) * static_cast<size_t>(2 * limbs + 1);
  std::memset(left, 0, size);
  std::memset(right, 0, size);
  for (int axis = 0; axis < dimension; axis++)
    add_square(left, to_integer(difference[axis], range.least, limbs), limbs);
  add_square(right, to_integer(reach, range.least, limbs), limbs);
  for (int k = 2 * limbs; k >= 0; k--) {
    if (left[k] != right[k]) return left[k] < right[k] ? -1 : 1;
  }
  return 0;
}

}  // namespace hg
