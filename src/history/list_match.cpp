// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Lists of successive steps are much alike, so most contacts are found by walking along both lists together. Only
// those that came, went or changed their order go through a hash table.
#include "src/history/list_match.hpp"

#include "src/base/error.hpp"

#include <algorithm>

namespace hg {
namespace {

// How far ahead in the old list the walk looks for a contact: over those of a few particles that came apart.
constexpr size_t kLookAhead = 12;
// How many keys ahead memory of the table is asked for.
constexpr size_t kPrefetch = 12;

[[noreturn]] void fail_twice(const hg_pair *pairs, size_t first, size_t second) {
  fail(HG_ERR_ARGUMENT, "pairs[%zu] = (%d, %d) is already listed as pairs[%zu]", second,
       static_cast<int>(pairs[second].a), static_cast<int>(pairs[second].b), first);
}

[[noreturn]] void fail_twice(const hg_contact_key *keys, size_t first, size_t second) {
  const hg_contact_key &key = keys[second];
  fail(HG_ERR_ARGUMENT, "keys[%zu] = (%lld, %lld, %lld) is already listed as keys[%zu]", second,
       static_cast<long long>(key.a), static_cast<long long>(key.b), static_cast<long long>(key.sub), first);
}

template <class Contact>
[[noreturn]] void refuse(ListView<Contact> list, size_t one, size_t other) {
  fail_twice(list.contacts, std::min(one, other), std::max(one, other));
}

// Matches contacts that stand in the same order in both lists, and marks the others by -1. Places only ascend, so none
// is given twice.
template <class Contact>
size_t walk(ListView<Contact> old, ListView<Contact> list, int64_t *previous) {
  size_t at = 0, matched = 0;
  for (size_t k = 0; k < list.count; k++) {
    const auto key = list[k];
    const size_t end = std::min(old.count, at + kLookAhead);
    size_t place = at;
    while (place < end && !same(old[place], key)) place++;
    const bool here = place < end;
    previous[k] = here ? static_cast<int64_t>(place) : -1;
    matched += here ? 1 : 0;
    if (here) at = place + 1;
  }
  return matched;
}

// Calls body(k) for each k of the list that `wanted` accepts; the table is asked for their memory some calls earlier.
template <class Table, class Contact, class Wanted, class Body>
void through_table(const Table &table, ListView<Contact> list, Wanted &&wanted, Body &&body) {
  for (size_t k = 0; k < list.count; k++) {
    const size_t ahead = k + kPrefetch;
    if (ahead < list.count && wanted(ahead)) table.prefetch(list[ahead]);
    if (wanted(k)) body(k);
  }
}

}  // namespace

template <class Contact>
size_t ListMatch<Contact>::match(ListView<Contact> old, ListView<Contact> list, int64_t *previous) {
  const size_t walked = walk(old, list, previous);
  const size_t found = walked + (walked < list.count ? look_up(old, walked, list, previous) : 0);
  if (found < list.count) refuse_twice(list, list.count - found, previous);
  return found;
}

// Matches the other contacts to those of the old list that the walk passed by. One comes twice if its place is taken.
template <class Contact>
size_t ListMatch<Contact>::look_up(ListView<Contact> old, size_t walked, ListView<Contact> list, int64_t *previous) {
  if (walked == old.count) return 0;
  table_.reset(old.count - walked);
  size_t next = 0;
  const auto put_until = [&](size_t end) {
    for (; next < end; next++) {
      if (next + kPrefetch < old.count) table_.prefetch(old[next + kPrefetch]);
      table_.locate(old[next]) = {old[next], static_cast<int64_t>(next)};
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
  through_table(table_, list, unmatched, [&](size_t k) {
    typename Table::Slot &slot = table_.locate(list[k]);
    if (slot.value == Table::kEmpty) return;
    if (slot.value < 0) refuse(list, k, static_cast<size_t>(~slot.value));
    previous[k] = slot.value;
    slot.value = ~static_cast<int64_t>(k);
    found++;
  });
  return found;
}

// Of a contact that comes twice, at least the second counts as new, since each place of the old list is given once.
template <class Contact>
void ListMatch<Contact>::refuse_twice(ListView<Contact> list, size_t fresh, const int64_t *previous) {
  table_.reset(fresh);
  filter_.reset(fresh);
  const auto is_new = [&](size_t k) { return previous[k] < 0; };
  through_table(table_, list, is_new, [&](size_t k) {
    const auto key = list[k];
    typename Table::Slot &slot = table_.locate(key);
    if (slot.value != Table::kEmpty) refuse(list, k, static_cast<size_t>(slot.value));
    slot = {key, static_cast<int64_t>(k)};
    filter_.add(key);
  });
  if (fresh == list.count) return;
  for (size_t k = 0; k < list.count; k++) {
    const auto key = list[k];
    if (!filter_.may_hold(key) || previous[k] < 0) continue;
    const typename Table::Slot &slot = table_.locate(key);
    if (slot.value != Table::kEmpty) refuse(list, k, static_cast<size_t>(slot.value));
  }
}

template class ListMatch<hg_pair>;
template class ListMatch<hg_contact_key>;

}  // namespace hg
