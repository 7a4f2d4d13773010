// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Decides whether two particles interact, on the caller's own doubles. The kernels ask it only about the few pairs that
// their fast test leaves undecided.
#pragma once

#include "src/exact/domain.hpp"
#include "src/exact/interaction.hpp"

#include <cstdint>

namespace hg {

// A ball as the caller gave it.
struct Ball {
  const double *center;
  double radius;
};

class Overlap {
 public:
  // HG_FLOAT on periodic axes decides as HG_EXACT: pairs accepted undecided could be met through two images.
  Overlap(const Interaction &interaction, int32_t accuracy, const Domain &domain)
      : interaction_(interaction),
        accuracy_(accuracy == HG_FLOAT && domain.any_periodic ? HG_EXACT : accuracy),
        domain_(domain) {}

  // Do a, moved by `image` box lengths from where it lies in the box, and b interact? Adds 1 to `exact` if even double
  // arithmetic left it undecided.
  bool holds(const Ball &a, const Ball &b, Image image, int64_t &exact) const;

  int32_t accuracy() const { return accuracy_; }
  const Interaction &interaction() const { return interaction_; }

 private:
  bool holds_exactly(const Ball &a, const Ball &b, const double *boxes) const;

  Interaction interaction_;
  int32_t accuracy_;
  Domain domain_;
};

}  // namespace hg
