// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/particles/participants.hpp"

#include "src/base/parallel.hpp"

#include <cstring>

namespace hg {
namespace {

// Rows of D numbers of those in slots[begin .. end), in their order.
template <size_t D>
void gather(const double *from, const uint32_t *slots, size_t begin, size_t end, double *to) {
  for (size_t k = begin; k < end; k++) std::memcpy(to + k * D, from + slots[k] * D, D * sizeof(double));
}

}  // namespace

void ParticipantList::list(const ParticleStore &store, const GroupTable &table) {
  const int8_t *group = store.groups();
  const size_t count = store.slots();
  size_t members[HG_MAX_GROUPS] = {};
  if (group == nullptr) members[0] = count;
  for (size_t slot = 0; group != nullptr && slot < count; slot++) {
    if (group[slot] != kAbsent) members[group[slot]]++;
  }
  GroupSet present = 0;
  size_t all = 0;
  for (int g = 0; g < HG_MAX_GROUPS; g++) {
    if (members[g] > 0) present |= only(g);
    all += members[g];
  }
  classes_ = table.classes(present);
  ranges_ = {};
  ranges_.count = classes_.count;
  all_alike_ = all == count && classes_.count == 1;
  if (all_alike_) return;

  size_t size[HG_MAX_GROUPS] = {};
  for (int g = 0; g < HG_MAX_GROUPS; g++) {
    if (members[g] > 0) size[classes_.of_group[g]] += members[g];
  }
  size_t next[HG_MAX_GROUPS] = {};
  for (int c = 0; c < classes_.count; c++) {
    next[c] = ranges_.begin[c];
    ranges_.begin[c + 1] = ranges_.begin[c] + size[c];
  }
  slots_.require_room(all);
  for (size_t slot = 0; slot < count; slot++) {
    if (group[slot] != kAbsent) slots_[next[classes_.of_group[group[slot]]]++] = static_cast<uint32_t>(slot);
  }
}

Participants ParticipantList::of(const ParticleStore &store, const GroupTable &table, int threads) {
  if (!listed_) list(store, table);
  listed_ = true;
  if (all_alike_) return {store, classes_};
  const size_t count = ranges_.end(), dimension = store.dimension();
  centers_.require_room(array_bytes(count, dimension));
  radii_.require_room(count);
  each_part(count < kWorthThreads ? 1 : threads, count, [&](size_t begin, size_t end) {
    (dimension == 2 ? gather<2> : gather<3>)(store.centers(), slots_.data(), begin, end, centers_.data());
    gather<1>(store.radii(), slots_.data(), begin, end, radii_.data());
  });
  if (count > 0) summary_ = store.summarise(centers_.data(), radii_.data(), count);
  return {store, centers_.data(), radii_.data(), slots_.data(), summary_, ranges_, classes_};
}

}  // namespace hg
