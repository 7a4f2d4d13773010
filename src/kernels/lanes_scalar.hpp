// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// One lane, no vector instructions: what the other instruction sets are held against.
#pragma once

#include "src/kernels/points.hpp"

#include <hgrid/types.h>

#include <cmath>

namespace hg {
namespace {

struct ScalarLanes {
  static constexpr uint32_t kLanes = 1;
  using Float = float;
  using Int = int32_t;
  using Mask = bool;

  static Float load(const float *p) { return *p; }
  static Int load(const int32_t *p) { return *p; }
  static Float set(float a) { return a; }
  static Int set(int32_t a) { return a; }
  static Int iota() { return 0; }

  static Float add(Float a, Float b) { return a + b; }
  static Float sub(Float a, Float b) { return a - b; }
  static Float mul(Float a, Float b) { return a * b; }
  static Float min(Float a, Float b) { return a < b ? a : b; }
  static Float max(Float a, Float b) { return a > b ? a : b; }
  static Float sqrt(Float a) { return std::sqrt(a); }
  static Float to_float(Int a) { return static_cast<float>(a); }
  static Int truncate(Float a) { return static_cast<int32_t>(a); }

  // Modulo 2^32, as vectors do.
  static Int add(Int a, Int b) { return static_cast<Int>(static_cast<uint32_t>(a) + static_cast<uint32_t>(b)); }
  static Int sub(Int a, Int b) { return static_cast<Int>(static_cast<uint32_t>(a) - static_cast<uint32_t>(b)); }
  static Int mul(Int a, Int b) { return static_cast<Int>(static_cast<uint32_t>(a) * static_cast<uint32_t>(b)); }
  static Int bit_and(Int a, Int b) { return a & b; }
  static Int halve(Int a) { return a >> 1; }

  static Mask less(Float a, Float b) { return a < b; }
  static Mask greater(Int a, Int b) { return a > b; }
  static Mask equal(Int a, Int b) { return a == b; }
  static Mask both(Mask a, Mask b) { return a && b; }
  static Mask either(Mask a, Mask b) { return a || b; }
  static Mask without(Mask a, Mask b) { return a && !b; }
  static uint32_t bits(Mask a) { return a ? 1u : 0u; }
  static uint32_t count(Mask a) { return a ? 1u : 0u; }

  static int32_t first(Int a) { return a; }
  static int32_t greatest(Int a, Mask m) { return m ? a : 0; }
  static Int gather(const uint32_t *p, Int i, Mask m) { return m ? static_cast<int32_t>(p[i]) : 0; }
  // Of a table that is kCellPadding longer; indices mostly lie close to each other.
  static Int gather_near(const uint32_t *p, Int i, Mask m) { return gather(p, i, m); }
  static void compress(uint32_t *to, Int a, Mask) { *to = static_cast<uint32_t>(a); }

  // Writes the pairs of `slot` with the slots whose bit is set, smaller first, each plus `offset`.
  static hg_pair *emit(hg_pair *next, uint32_t slot, const uint32_t *others, uint32_t found, int32_t offset) {
    const uint32_t other = *others;
    const uint32_t low = slot < other ? slot : other, high = slot < other ? other : slot;
    *next = {static_cast<int32_t>(low) + offset, static_cast<int32_t>(high) + offset};
    return next + found;
  }
};

}  // namespace
}  // namespace hg
