// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/direct_visit.hpp"

namespace hg {
namespace {

constexpr size_t kBatch = 512;  // contacts: with what a force wants to know of them, in the nearest cache
static_assert(kBatch <= HG_MAX_BATCH);

constexpr size_t kColumn = kBatch + kPadding;

}  // namespace

DirectVisit::DirectVisit(const CandidateFilter &filter, const StoredCandidates &candidates, const ParticleStore &store,
                         Memory &memory, hg_contact_visitor *visit, void *context)
    : filter_(filter),
      candidates_(candidates),
      store_(store),
      slots_(memory),
      numbers_(memory),
      visit_(visit),
      context_(context) {
  slots_.require(2 * kColumn);
  numbers_.require(4 * kColumn);
}

void DirectVisit::run() {
  const Index &index = candidates_.index();
  DirectContactsKernel *find = active_kernels().direct[index.domain.dimension - 2][index.interaction.kind].contacts;
  double *numbers = numbers_.data();
  ContactColumns columns{kBatch,
                         store_.id_offset(),
                         slots_.data(),
                         slots_.data() + kColumn,
                         {numbers, numbers + kColumn, numbers + 2 * kColumn},
                         numbers + 3 * kColumn,
                         0,
                         0,
                         0};
  for (size_t first = 0; first < candidates_.count();) {
    const size_t looked_at = find(filter_.direct_input(first, candidates_.count() - first), &columns);
    first += looked_at;
    counts_.candidates += static_cast<int64_t>(looked_at);
    if (columns.count > 0 && !hand_over(columns)) break;
  }
  counts_.undecided = columns.undecided;
  counts_.exact = columns.exact;
}

bool DirectVisit::hand_over(const ContactColumns &columns) {
  const size_t count = columns.count;
  visited_ += count;
  for (size_t k = 0; !store_.contiguous() && k < count; k++) {
    columns.a[k] = store_.id(static_cast<size_t>(columns.a[k]));
    columns.b[k] = store_.id(static_cast<size_t>(columns.b[k]));
  }
  const double *z = candidates_.index().domain.dimension == 3 ? columns.component[2] : nullptr;
  const hg_contact_batch batch{count, columns.a,    columns.b, columns.component[0], columns.component[1],
                               z,     columns.reach};
  return visit_(context_, &batch) == 0;
}

}  // namespace hg
