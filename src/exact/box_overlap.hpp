// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Decides whether a particle meets an axis-aligned box, on the caller's own doubles: whether the box is nearer to its
// centre, or to that of any periodic image, than radius and margin reach. No cell is tilted here.
#pragma once

#include "src/exact/overlap.hpp"

namespace hg {

// low <= high on each axis; either may be infinite.
struct AlignedBox {
  const double *low, *high;

  // So wide that on this axis it meets an image of every particle, wherever it lies.
  bool covers(const Domain &domain, int axis) const {
    return domain.periodic[axis] && high[axis] - low[axis] >= 2 * domain.length[axis];
  }
};

class BoxOverlap {
 public:
  BoxOverlap(const Interaction &interaction, const Domain &domain)
      : margin_(interaction.margin), touching_(interaction.touching), domain_(domain) {}

  // A centre in the closed box counts whatever its radius.
  bool holds(const AlignedBox &box, const Ball &ball) const;

 private:
  bool holds_exactly(const AlignedBox &box, const Ball &ball) const;
  ExactSum nearest_gap(const AlignedBox &box, const Ball &ball, int axis) const;
  int64_t nearest_image(const AlignedBox &box, const Ball &ball, int axis) const;
  ExactSum gap(const AlignedBox &box, const Ball &ball, int axis, int64_t image) const;

  double margin_;
  bool touching_;
  const Domain &domain_;
};

}  // namespace hg
