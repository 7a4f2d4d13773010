// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What the caller's arrays must fulfil. All numbers are looked at once, by a kernel that copies them on the way; only
// where something is wrong they are looked at again, to name it.
#pragma once

#include "src/exact/domain.hpp"
#include "src/exact/interaction.hpp"
#include "src/kernels/kernel_set.hpp"

#include <cstddef>

namespace hg {

// Of two sets of particles together.
void include(InputSummary &all, const InputSummary &more);

class InputCheck {
 public:
  // `largest_diameter`: what the coarsest user-given cell can hold; infinite if cells follow the particles.
  InputCheck(const Domain &domain, const Interaction &interaction, double largest_diameter, int threads)
      : domain_(domain), interaction_(interaction), largest_diameter_(largest_diameter), threads_(threads) {}

  void set_domain(const Domain &domain) { domain_ = domain; }

  // Copies and summarises. Checks nothing.
  InputSummary summarise(const InputArrays &input) const;
  // The same, but throws an Error that names index and value if something is wrong. The copies are made all the same.
  InputSummary check(const InputArrays &input) const;

  // The part of the check that a new domain asks for, too.
  void check_wraps(const InputArrays &input, const InputSummary &found) const;

 private:
  void check_numbers(const InputArrays &input, const InputSummary &found) const;
  bool may_be_outside(const InputSummary &found) const;
  void check_largest(const InputArrays &input, double radius) const;

  Domain domain_;
  Interaction interaction_;
  double largest_diameter_;
  int threads_;
};

}  // namespace hg
