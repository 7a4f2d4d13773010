// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows of partners become pairs in ascending order, one source for all instruction sets. How a short row is sorted
// while it is written is given by its Sorter: sort_plain.hpp, sort_avx2.hpp.
#pragma once

#include "src/kernels/kernel_set.hpp"

namespace hg {
namespace {

template <class Sorter>
hg_pair *order(const PartnerRows &rows, hg_pair *next) {
  const uint32_t *partners = rows.partners;
  const auto offset = static_cast<uint32_t>(rows.id_offset);
  uint32_t begin = 0;
  for (size_t row = 0; row < rows.count; row++) {
    const uint32_t count = rows.end[row] - begin;
    const int32_t a = rows.first_id + static_cast<int32_t>(row);
    if (count <= kMostSorted) {
      Sorter::write(partners, count, a, offset, next);
    } else {
      for (uint32_t k = 0; k < count; k++) next[k] = {a, static_cast<int32_t>(partners[k] + offset)};
    }
    next += count;
    partners += count;
    begin = rows.end[row];
  }
  return next;
}

}  // namespace
}  // namespace hg
