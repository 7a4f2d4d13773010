// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Sorts a short row of partners without vector instructions.
#pragma once

#include <hgrid/types.h>

#include <cstdint>

namespace hg {
namespace {

struct PlainSorter {
  // Writes the pairs of `a` with its partners, ascending, plus at most 8 behind them. Reads as many.
  static void write(const uint32_t *partners, uint32_t count, int32_t a, uint32_t offset, hg_pair *to) {
    if (count <= 8) {
      write_8(partners, count, a, offset, to);
    } else {
      insert(partners, count, a, offset, to);
    }
  }

 private:
  // A sorting network: most rows are that short, and no branch predictor knows their order.
  static void write_8(const uint32_t *partners, uint32_t count, int32_t a, uint32_t offset, hg_pair *to) {
    uint32_t v[8];
    for (uint32_t k = 0; k < 8; k++) v[k] = k < count ? partners[k] : UINT32_MAX;
    const auto sort = [&v](int i, int j) {
      const uint32_t low = v[i] < v[j] ? v[i] : v[j], high = v[i] < v[j] ? v[j] : v[i];
      v[i] = low;
      v[j] = high;
    };
    sort(0, 2), sort(1, 3), sort(4, 6), sort(5, 7);
    sort(0, 4), sort(1, 5), sort(2, 6), sort(3, 7);
    sort(0, 1), sort(2, 3), sort(4, 5), sort(6, 7);
    sort(2, 4), sort(3, 5);
    sort(1, 4), sort(3, 6);
    sort(1, 2), sort(3, 4), sort(5, 6);
    for (int k = 0; k < 8; k++) to[k] = {a, static_cast<int32_t>(v[k] + offset)};
  }

  static void insert(const uint32_t *partners, uint32_t count, int32_t a, uint32_t offset, hg_pair *to) {
    for (uint32_t k = 0; k < count; k++) {
      const int32_t b = static_cast<int32_t>(partners[k] + offset);
      uint32_t place = k;
      for (; place > 0 && to[place - 1].b > b; place--) to[place] = to[place - 1];
      to[place] = {a, b};
    }
  }
};

}  // namespace
}  // namespace hg
