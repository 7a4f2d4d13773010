// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/history/contact_history.hpp"

#include <algorithm>
#include <cstring>

namespace hg {

ContactHistory::ContactHistory(const hg_allocator &allocator)
    : memory_(allocator),
      pair_match_(memory_),
      key_match_(memory_),
      widened_(memory_),
      nothing_(memory_),
      lists_{List(memory_), List(memory_)},
      ended_(memory_),
      kept_(memory_) {}

void ContactHistory::update(size_t count, const hg_pair *pairs) {
  take(count, pairs, now());
  matched_ = true;
}

void ContactHistory::update(size_t count, const hg_contact_key *keys) {
  take(count, keys, now());
  matched_ = true;
}

void ContactHistory::restore(size_t count, const hg_pair *pairs) {
  take(count, pairs, nothing_);
  matched_ = false;
}

void ContactHistory::restore(size_t count, const hg_contact_key *keys) {
  take(count, keys, nothing_);
  matched_ = false;
}

// The list before last gives its place to the new one, but only when all has gone well: ended() may still ask for it.
template <class Contact>
void ContactHistory::take(size_t count, const Contact *contacts, const List &old) {
  List &list = lists_[1 - current_];
  list.previous.require(std::max<size_t>(1, count));
  const size_t kept = match(old, {contacts, count}, list.previous.data());
  Buffer<Contact> &stored = list.contacts<Contact>();
  stored.grow(std::max<size_t>(1, count));
  if (count > 0) std::memcpy(stored.data(), contacts, count * sizeof *contacts);
  list.count = count;
  list.keyed = count > 0 && std::is_same_v<Contact, hg_contact_key>;
  former_count_ = old.count;
  kept_count_ = kept;
  current_ = 1 - current_;
  ended_known_ = false;
}

size_t ContactHistory::match(const List &old, ListView<hg_pair> list, int64_t *previous) {
  if (!old.keyed) return pair_match_.match({old.pairs.data(), old.count}, list, previous);
  return key_match_.match({old.keys.data(), old.count}, widen(list), previous);
}

size_t ContactHistory::match(const List &old, ListView<hg_contact_key> list, int64_t *previous) {
  if (old.keyed) return key_match_.match({old.keys.data(), old.count}, list, previous);
  return key_match_.match(widen({old.pairs.data(), old.count}), list, previous);
}

// Pairs as keys: their sub-key is 0.
ListView<hg_contact_key> ContactHistory::widen(ListView<hg_pair> list) {
  widened_.require(std::max<size_t>(1, list.count));
  for (size_t k = 0; k < list.count; k++) widened_[k] = {list.contacts[k].a, list.contacts[k].b, 0};
  return {widened_.data(), list.count};
}

const ContactHistory::List &ContactHistory::ended() {
  if (!ended_known_) find_ended();
  return ended_;
}

void ContactHistory::find_ended() {
  const List &old = lists_[1 - current_];
  kept_.require(former_count_);
  std::fill(kept_.data(), kept_.data() + former_count_, uint8_t{0});
  for (size_t k = 0; k < now().count; k++) {
    if (previous()[k] >= 0) kept_[static_cast<size_t>(previous()[k])] = 1;
  }
  ended_.previous.require(former_count_ - kept_count_);
  ended_.count = 0;
  for (size_t place = 0; place < former_count_; place++) {
    if (kept_[place] == 0) ended_.previous[ended_.count++] = static_cast<int64_t>(place);
  }
  if (old.keyed) {
    copy_ended<hg_contact_key>(old);
  } else {
    copy_ended<hg_pair>(old);
  }
  ended_.keyed = ended_.count > 0 && old.keyed;
  ended_known_ = true;
}

template <class Contact>
void ContactHistory::copy_ended(const List &old) {
  const Contact *const from = old.contacts<Contact>().data();
  Buffer<Contact> &to = ended_.contacts<Contact>();
  to.require(ended_.count);
  for (size_t k = 0; k < ended_.count; k++) to[k] = from[ended_.previous[k]];
}

}  // namespace hg
