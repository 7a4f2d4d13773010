// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/pair_vectors.hpp"

#include "src/base/parallel.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace hg {

void PairVectors::find(const PairGeometry &geometry, const ParticleStore &store, const hg_pair *pairs, size_t count,
                       int dimension, int threads) {
  vectors_.require_room(array_bytes(count, static_cast<size_t>(dimension)));
  shifts_.require_room(array_bytes(count, static_cast<size_t>(dimension)));
  if (geometry.many_images()) {
    find_many(geometry, store, pairs, count, dimension);
  } else {
    const size_t parts = parts_of(count);
    parallel_for(count < kWorthThreads ? 1 : threads, parts, [&](size_t part, int) {
      for (size_t p = count * part / parts; p < count * (part + 1) / parts; p++) {
        const size_t at = p * static_cast<size_t>(dimension);
        const Shift shift = geometry.find(store.slot(pairs[p].a), store.slot(pairs[p].b), vectors_.data() + at);
        std::copy_n(shift.n, dimension, shifts_.data() + at);
      }
    });
  }
  found_ = true;
}

// Equal pairs, which may stand anywhere, take turns with their shifts.
void PairVectors::find_many(const PairGeometry &geometry, const ParticleStore &store, const hg_pair *pairs,
                            size_t count, int dimension) {
  order_.require_room(count);
  std::iota(order_.data(), order_.data() + count, size_t{0});
  const auto key = [&](size_t p) { return std::pair(pairs[p].a, pairs[p].b); };
  std::sort(order_.data(), order_.data() + count,
            [&](size_t p, size_t q) { return std::pair(key(p), p) < std::pair(key(q), q); });
  std::vector<Shift> shifts;
  for (size_t first = 0, end = 0; first < count; first = end) {
    while (end < count && key(order_[end]) == key(order_[first])) end++;
    const size_t a = store.slot(pairs[order_[first]].a), b = store.slot(pairs[order_[first]].b);
    geometry.list_shifts(a, b, shifts);
    for (size_t k = first; k < end; k++) {
      const size_t at = order_[k] * static_cast<size_t>(dimension);
      geometry.vector(a, b, shifts[k - first], vectors_.data() + at);
      std::copy_n(shifts[k - first].n, dimension, shifts_.data() + at);
    }
  }
}

}  // namespace hg
