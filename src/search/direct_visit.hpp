// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Hands the direct candidates that interact to a visitor of contacts, straight from the kernel that tests them.
#pragma once

#include "src/base/memory.hpp"
#include "src/search/candidate_filter.hpp"

#include <hgrid/types.h>

namespace hg {

class DirectVisit {
 public:
  DirectVisit(const CandidateFilter &filter, const StoredCandidates &candidates, const ParticleStore &store,
              Memory &memory, hg_contact_visitor *visit, void *context);

  void run();
  const SearchCounts &counts() const { return counts_; }
  size_t visited() const { return visited_; }

 private:
  bool hand_over(const ContactColumns &columns);

  const CandidateFilter &filter_;
  const StoredCandidates &candidates_;
  const ParticleStore &store_;
  Buffer<int32_t> slots_;   // a, then b
  Buffer<double> numbers_;  // of each axis, then reaches
  hg_contact_visitor *visit_;
  void *context_;
  SearchCounts counts_;
  size_t visited_ = 0;
};

}  // namespace hg
