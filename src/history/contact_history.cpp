// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Lists of successive steps are much alike, so most pairs are found by walking along both lists together. Only pairs
// that came, went or changed their order go through a hash table.
#include "src/history/contact_history.hpp"

#include "src/base/error.hpp"

#include <algorithm>
#include <cstring>

namespace hg {
namespace {

// How far ahead in the old list the walk looks for a pair: over the contacts of a few particles that came apart.
constexpr size_t kLookAhead = 12;
// How many keys ahead memory of the table is asked for.
constexpr size_t kPrefetch = 12;

[[noreturn]] void fail_twice(const hg_pair *pairs, size_t one, size_t other) {
  const auto [first, second] = std::minmax(one, other);
  fail(HG_ERR_ARGUMENT, "pairs[%zu] = (%d, %d) is already listed as pairs[%zu]", second,
       static_cast<int>(pairs[first].a), static_cast<int>(pairs[first].b), first);
}

// Calls body(k) for each k < count that `wanted` accepts; the table is asked for their memory some calls earlier.
template <class Wanted, class Body>
void through_table(const PairTable &table, const hg_pair *pairs, size_t count, Wanted &&wanted, Body &&body) {
  for (size_t k = 0; k < count; k++) {
    const size_t ahead = k + kPrefetch;
    if (ahead < count && wanted(ahead)) table.prefetch(pair_key(pairs[ahead]));
    if (wanted(k)) body(k);
  }
}

}  // namespace

ContactHistory::ContactHistory(const hg_allocator &allocator)
    : memory_(allocator), table_(memory_), filter_(memory_), nothing_(memory_), lists_{List(memory_), List(memory_)} {}

void ContactHistory::update(size_t count, const hg_pair *pairs) {
  take(count, pairs, now());
  matched_ = true;
}

void ContactHistory::restore(size_t count, const hg_pair *pairs) {
  take(count, pairs, nothing_);
  matched_ = false;
}

// The list before last gives its place to the new one, which counts only when all has gone well.
void ContactHistory::take(size_t count, const hg_pair *pairs, const List &old) {
  List &list = lists_[1 - current_];
  list.pairs.require(std::max<size_t>(1, count));
  list.previous.require(std::max<size_t>(1, count));
  if (count > 0) std::memcpy(list.pairs.data(), pairs, count * sizeof *pairs);
  list.count = count;
  const size_t walked = walk(old, list);
  const size_t found = walked < count ? look_up(old, walked, list) : 0;
  if (walked + found < count) refuse_twice(list, count - walked - found);
  former_count_ = old.count;
  current_ = 1 - current_;
}

// Matches pairs that stand in the same order in both lists, and marks the others by -1. Places only ascend, so none is
// given twice.
size_t ContactHistory::walk(const List &old, List &list) {
  const hg_pair *const from = old.pairs.data();
  int64_t *const previous = list.previous.data();
  size_t at = 0, matched = 0;
  for (size_t k = 0; k < list.count; k++) {
    const uint64_t key = pair_key(list.pairs[k]);
    const size_t end = std::min(old.count, at + kLookAhead);
    size_t place = at;
    while (place < end && pair_key(from[place]) != key) place++;
    const bool here = place < end;
    previous[k] = here ? static_cast<int64_t>(place) : -1;
    matched += here ? 1 : 0;
    if (here) at = place + 1;
  }
  return matched;
}

// Matches the other pairs to those of the old list that the walk passed by. A pair comes twice if its place is taken.
size_t ContactHistory::look_up(const List &old, size_t walked, List &list) {
  if (walked == old.count) return 0;
  int64_t *const previous = list.previous.data();
  table_.reset(old.count - walked);
  size_t next = 0;
  const auto put_until = [&](size_t end) {
    for (; next < end; next++) {
      if (next + kPrefetch < old.count) table_.prefetch(pair_key(old.pairs[next + kPrefetch]));
      const uint64_t key = pair_key(old.pairs[next]);
      table_.locate(key) = {key, static_cast<int64_t>(next)};
    }
  };
  for (size_t k = 0; k < list.count; k++) {
    if (previous[k] < 0) continue;
    put_until(static_cast<size_t>(previous[k]));
    next++;
  }
  put_until(old.count);

  size_t found = 0;
  const auto unmatched = [&](size_t k) { return previous[k] < 0; };
  through_table(table_, list.pairs.data(), list.count, unmatched, [&](size_t k) {
    PairTable::Slot &slot = table_.locate(pair_key(list.pairs[k]));
    if (slot.value == PairTable::kEmpty) return;
    if (slot.value < 0) fail_twice(list.pairs.data(), k, static_cast<size_t>(~slot.value));
    previous[k] = slot.value;
    slot.value = ~static_cast<int64_t>(k);
    found++;
  });
  return found;
}

// Of a pair that comes twice, at least the second counts as new, since each place of the old list is given once.
void ContactHistory::refuse_twice(const List &list, size_t fresh) {
  const hg_pair *const pairs = list.pairs.data();
  const int64_t *const previous = list.previous.data();
  table_.reset(fresh);
  filter_.reset(fresh);
  const auto is_new = [&](size_t k) { return previous[k] < 0; };
  through_table(table_, pairs, list.count, is_new, [&](size_t k) {
    const uint64_t key = pair_key(pairs[k]);
    PairTable::Slot &slot = table_.locate(key);
    if (slot.value != PairTable::kEmpty) fail_twice(pairs, k, static_cast<size_t>(slot.value));
    slot = {key, static_cast<int64_t>(k)};
    filter_.add(key);
  });
  if (fresh == list.count) return;
  for (size_t k = 0; k < list.count; k++) {
    const uint64_t key = pair_key(pairs[k]);
    if (!filter_.may_hold(key) || previous[k] < 0) continue;
    const PairTable::Slot &slot = table_.locate(key);
    if (slot.value != PairTable::kEmpty) fail_twice(pairs, k, static_cast<size_t>(slot.value));
  }
}

}  // namespace hg
