// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Four lanes: NEON, which every 64-bit ARM has.
#pragma once

#include "src/kernels/points.hpp"

#include <hgrid/types.h>

#include <arm_neon.h>

namespace hg {
namespace {

// For each mask of 4 lanes, the bytes of the lanes that are set, in order, and their number.
struct CompressTable {
  uint8_t bytes[16][16];
  uint8_t count[16];
  constexpr CompressTable() : bytes(), count() {
    for (unsigned mask = 0; mask < 16; mask++) {
      for (unsigned lane = 0; lane < 4; lane++) {
        if ((mask >> lane & 1u) == 0) continue;
        for (unsigned byte = 0; byte < 4; byte++) {
          bytes[mask][4 * count[mask] + byte] = static_cast<uint8_t>(4 * lane + byte);
        }
        count[mask]++;
      }
    }
  }
};
alignas(64) constexpr CompressTable kCompress;

struct NeonLanes {
  static constexpr uint32_t kLanes = 4;
  using Float = float32x4_t;
  using Int = int32x4_t;
  using Mask = uint32x4_t;

  static Float load(const float *p) { return vld1q_f32(p); }
  static Int load(const int32_t *p) { return vld1q_s32(p); }
  static Float set(float a) { return vdupq_n_f32(a); }
  static Int set(int32_t a) { return vdupq_n_s32(a); }
  static Int iota() {
    alignas(16) static constexpr int32_t kLane[4] = {0, 1, 2, 3};
    return vld1q_s32(kLane);
  }

  // As in lanes_sse2.hpp.
  static Int load_points(const Point *points, const int32_t *index) { return load(&points[index[0]].x); }
  static Int low_words(Int a, Int b) { return vzip1q_s32(a, b); }
  static Int high_words(Int a, Int b) { return vzip2q_s32(a, b); }
  static Int low_doubles(Int a, Int b) {
    return vreinterpretq_s32_s64(vzip1q_s64(vreinterpretq_s64_s32(a), vreinterpretq_s64_s32(b)));
  }
  static Int high_doubles(Int a, Int b) {
    return vreinterpretq_s32_s64(vzip2q_s64(vreinterpretq_s64_s32(a), vreinterpretq_s64_s32(b)));
  }
  static Float as_float(Int a) { return vreinterpretq_f32_s32(a); }

  // No fused operations: the other sets have none, and pairs must not depend on the set.
  static Float add(Float a, Float b) { return vaddq_f32(a, b); }
  static Float sub(Float a, Float b) { return vsubq_f32(a, b); }
  static Float mul(Float a, Float b) { return vmulq_f32(a, b); }
  // These differ from the other sets in the sign of a zero and for NaN. No NaN comes here, and all that follows gives
  // the same for both zeros.
  static Float min(Float a, Float b) { return vminq_f32(a, b); }
  static Float max(Float a, Float b) { return vmaxq_f32(a, b); }
  static Float sqrt(Float a) { return vsqrtq_f32(a); }
  static Float to_float(Int a) { return vcvtq_f32_s32(a); }
  static Int truncate(Float a) { return vcvtq_s32_f32(a); }

  static Int add(Int a, Int b) { return vaddq_s32(a, b); }
  static Int sub(Int a, Int b) { return vsubq_s32(a, b); }
  static Int mul(Int a, Int b) { return vmulq_s32(a, b); }
  static Int bit_and(Int a, Int b) { return vandq_s32(a, b); }
  static Int halve(Int a) { return vshrq_n_s32(a, 1); }

  static Mask less(Float a, Float b) { return vcltq_f32(a, b); }
  static Mask greater(Int a, Int b) { return vcgtq_s32(a, b); }
  static Mask equal(Int a, Int b) { return vceqq_s32(a, b); }
  static Mask both(Mask a, Mask b) { return vandq_u32(a, b); }
  static Mask either(Mask a, Mask b) { return vorrq_u32(a, b); }
  static Mask without(Mask a, Mask b) { return vbicq_u32(a, b); }
  static uint32_t bits(Mask a) {
    alignas(16) static constexpr uint32_t kBit[4] = {1, 2, 4, 8};
    return vaddvq_u32(vandq_u32(a, vld1q_u32(kBit)));
  }
  static uint32_t count(Mask a) { return vaddvq_u32(vshrq_n_u32(a, 31)); }

  static int32_t first(Int a) { return vgetq_lane_s32(a, 0); }
  static int32_t greatest(Int a, Mask m) { return vmaxvq_s32(vandq_s32(a, vreinterpretq_s32_u32(m))); }
  static Int gather(const uint32_t *p, Int i, Mask m) {
    const uint32x4_t at = vandq_u32(vreinterpretq_u32_s32(i), m);
    uint32x4_t values = vdupq_n_u32(p[vgetq_lane_u32(at, 0)]);
    values = vsetq_lane_u32(p[vgetq_lane_u32(at, 1)], values, 1);
    values = vsetq_lane_u32(p[vgetq_lane_u32(at, 2)], values, 2);
    values = vsetq_lane_u32(p[vgetq_lane_u32(at, 3)], values, 3);
    return vreinterpretq_s32_u32(values);
  }
  static Int gather_near(const uint32_t *p, Int i, Mask m) { return gather(p, i, m); }
  static void compress(uint32_t *to, Int a, Mask m) { vst1q_u32(to, lanes_of(vreinterpretq_u32_s32(a), bits(m))); }

  static hg_pair *emit(hg_pair *next, uint32_t slot, const uint32_t *others, uint32_t found, int32_t offset) {
    const uint32x4_t other = lanes_of(vld1q_u32(others), found), mine = vdupq_n_u32(slot);
    const int32x4_t base = vdupq_n_s32(offset);
    int32x4x2_t pairs;
    pairs.val[0] = vaddq_s32(vreinterpretq_s32_u32(vminq_u32(mine, other)), base);
    pairs.val[1] = vaddq_s32(vreinterpretq_s32_u32(vmaxq_u32(mine, other)), base);
    vst2q_s32(&next->a, pairs);
    return next + kCompress.count[found];
  }

 private:
  static uint32x4_t lanes_of(uint32x4_t a, uint32_t set) {
    return vreinterpretq_u32_u8(vqtbl1q_u8(vreinterpretq_u8_u32(a), vld1q_u8(kCompress.bytes[set])));
  }
};

}  // namespace
}  // namespace hg
