// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The vectors and shifts of a whole list of pairs.
#pragma once

#include "src/base/memory.hpp"
#include "src/search/pair_geometry.hpp"

#include <hgrid/types.h>

#include <cstddef>

namespace hg {

class PairVectors {
 public:
  explicit PairVectors(Memory &memory) : vectors_(memory), shifts_(memory), order_(memory) {}

  // Of pairs of ids. With many images the k-th of equal pairs is that with the k-th shift.
  void find(const PairGeometry &geometry, const ParticleStore &store, const hg_pair *pairs, size_t count, int dimension,
            int threads);
  void forget() { found_ = false; }

  bool found() const { return found_; }
  const double *vectors() const { return vectors_.data(); }
  const int32_t *shifts() const { return shifts_.data(); }

 private:
  void find_many(const PairGeometry &geometry, const ParticleStore &store, const hg_pair *pairs, size_t count,
                 int dimension);

  Buffer<double> vectors_;
  Buffer<int32_t> shifts_;
  Buffer<size_t> order_;
  bool found_ = false;
};

}  // namespace hg
