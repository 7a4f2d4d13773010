// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles that are so far apart that no grid of cells spans them: wherever nothing lies for several largest diameters
// along an axis, the axis is cut short. Near particles keep their distances, others stay out of each other's reach.
#pragma once

#include "src/base/memory.hpp"
#include "src/exact/domain.hpp"
#include "src/index/axis_bins.hpp"
#include "src/particles/participants.hpp"
#include "src/space/bounds.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

class SqueezedAxes {
 public:
  explicit SqueezedAxes(Memory &memory)
      : centers_(memory),
        bins_(memory),
        bin_run_(memory),
        runs_{Buffer<Run>(memory), Buffer<Run>(memory), Buffer<Run>(memory)} {}

  // As many gaps as there may be particles (ChunkRows::kMostParticles) are no infinite length.
  static constexpr double kLongestGap = 0x1p990;

  // Squeezes all open axes so that no gap is longer than `gap`, up to kLongestGap, and tells the bounds that centers()
  // have then.
  Bounds squeeze(const Participants &particles, const Domain &domain, double gap);
  void release() { in_use_ = false; }

  bool in_use() const { return in_use_; }
  // Squeezed, slot by slot; as given on periodic axes.
  const double *centers() const { return centers_.data(); }
  // Of any position on an open axis; monotone.
  double position(int axis, double x) const;

 private:
  // Particles along an axis without a long gap between them.
  struct Run {
    double begin, squeezed_begin;
  };

  double squeeze_axis(const Participants &particles, int axis, size_t dimension, double gap);

  bool in_use_ = false;
  Buffer<double> centers_;
  AxisBins bins_;        // of the axis that is being squeezed
  Buffer<Run> bin_run_;  // that each of them lies in
  Buffer<Run> runs_[3];
  size_t run_count_[3] = {0, 0, 0};
};

}  // namespace hg
