// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Positions along an axis in bins, of which only those that hold any are kept: whatever the extent, they are as many as
// there are positions at most, and few where most positions lie together.
#pragma once

#include "src/base/memory.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

class AxisBins {
 public:
  explicit AxisBins(Memory &memory)
      : table_{Buffer<Place>(memory), Buffer<Place>(memory)},
        bins_(memory),
        of_(memory),
        sorted_(memory),
        other_(memory) {}

  // For so many positions that bins hold positions less than `width` apart.
  void begin(double width, size_t positions);
  // Positions number, number + 1, ..., up to kTogether of them; in any order, each once.
  static constexpr size_t kTogether = 64;
  void add(size_t number, const double *x, size_t positions);
  void sort();

  size_t count() const { return count_; }
  uint32_t bin_of(size_t number) const { return of_[number]; }
  // The bin at that place along the axis.
  uint32_t sorted(size_t at) const { return order_[at].bin; }
  double least(uint32_t bin) const { return bins_[bin].least; }
  double greatest(uint32_t bin) const { return bins_[bin].greatest; }

 private:
  struct Place {
    double low;  // of the bin; ascends with the bins
    uint32_t bin;
  };
  struct Bin {
    double least, greatest;
  };
  struct Key {
    uint64_t bits;
    uint32_t bin;
  };
  static constexpr uint32_t kNone = ~uint32_t{0};

  double low_of(double x) const;
  size_t hash(double low) const;
  uint32_t find_or_add(double low, double x);
  void make_places(size_t places);

  double width_ = 0, inverse_ = 0;
  size_t count_ = 0;
  int place_bits_ = 0;
  uint64_t spread_ = 0;     // of the hash
  int spreads_ = 0;         // that were tried
  Buffer<Place> table_[2];  // by hash: that in use, and room for a longer one
  Place *place_ = nullptr;
  Buffer<Bin> bins_;
  Buffer<uint32_t> of_;  // of each position
  Buffer<Key> sorted_, other_;
  const Key *order_ = nullptr;
};

}  // namespace hg
