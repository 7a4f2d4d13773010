// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a search has found the pairs that it must find.
#pragma once

#include "programs/bench/search.hpp"

#include <hgrid/types.h>

#include <string>
#include <vector>

namespace bench {

// The pairs of one system as the library finds them. Peers and plain searches that agree with it are the proof that it
// is right: they share no code with it.
class Reference {
 public:
  // Searches in processes of their own. `particles` must outlive the reference.
  explicit Reference(const particles::ParticleSet &particles);

  // "" if `pairs`, sorted, are what a search of this accuracy must find, else what is wrong with them.
  std::string fault(Accuracy accuracy, const std::vector<hg_pair> &pairs) const;

  // Why the library disagrees with itself, or "": its exact and its double decision may differ only for pairs that
  // touch within rounding.
  const std::string &own_fault() const { return own_fault_; }
  size_t rounded() const { return rounded_; }  // the number of these
  size_t pair_count() const { return exact_.size(); }

 private:
  const particles::ParticleSet *particles_;
  std::vector<hg_pair> exact_, as_doubles_;
  std::string own_fault_;
  size_t rounded_ = 0;
};

}  // namespace bench
