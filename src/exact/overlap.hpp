// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Decides whether two particles interact, on the caller's own doubles. The kernels ask it only about the few pairs that
// their fast test leaves undecided.
#pragma once

#include "src/exact/domain.hpp"
#include "src/exact/interaction.hpp"
#include "src/exact/lattice.hpp"

#include <cstdint>

namespace hg {

// A ball as the caller gave it. Those of a store stand there in the order of their ids.
struct Ball {
  const double *center;
  double radius;
};

class Overlap {
 public:
  // HG_FLOAT on periodic axes decides as HG_EXACT: pairs accepted undecided could be met through two images.
  Overlap(const Interaction &interaction, int32_t accuracy, const Domain &domain)
      : interaction_(interaction), accuracy_(accuracy == HG_FLOAT && domain.any_periodic ? HG_EXACT : accuracy) {
    set_domain(domain);
  }
  void set_domain(const Domain &domain);

  // Do a, moved by so many edges of the cell from where the caller has it, and b interact? Adds 1 to `exact` if even
  // double arithmetic left it undecided.
  bool holds(const Ball &a, const Ball &b, const Shift &shift, int64_t &exact) const;
  // The same, but where the nearest image alone counts and two hold at the same distance, it is the first of them.
  bool is_pair(const Ball &a, const Ball &b, const Shift &shift, int64_t &exact) const;

  int32_t accuracy() const { return accuracy_; }
  const Interaction &interaction() const { return interaction_; }
  const Domain &domain() const { return domain_; }
  // An image that near is the only one, as doubles reckon distances.
  double surely_nearest() const { return 0.5 * short_.shortest * (1 - 0x1p-20) - rounding_; }

 private:
  bool holds_exactly(const Ball &a, const Ball &b, const Shift &shift) const;
  bool comes_second(const Ball &a, const Ball &b, const Shift &shift, int64_t &exact) const;

  Interaction interaction_;
  int32_t accuracy_;
  Domain domain_;
  ShortVectors short_;
  double rounding_ = 0;  // of what HG_DOUBLE computes across the box, for two images together
};

}  // namespace hg
