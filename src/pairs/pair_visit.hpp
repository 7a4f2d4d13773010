// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Hands pairs to a visitor in batches, in bounded memory.
#pragma once

#include "src/pairs/pair_list.hpp"

#include <hgrid/types.h>

namespace hg {

inline constexpr size_t kVisitBatch = 8192;

struct VisitResult {
  SearchCounts counts;
  size_t pairs = 0;
};

// Visits the pairs of a source as they come. Stops when the visitor returns nonzero.
VisitResult visit_source(const PairSource &source, const ParticleStore &store, Memory &memory, hg_pair_visitor *visit,
                         void *context);

// Visits pairs that are there already.
void visit_list(const hg_pair *pairs, size_t count, hg_pair_visitor *visit, void *context);

}  // namespace hg
