// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/history/key_table.hpp"

#include <algorithm>

namespace hg {
namespace {

// A table that is half full takes 2.5 steps on average for a key that is not there (Knuth, The Art of Computer
// Programming 3, section 6.4). Far more than that means that the keys were chosen against the seed.
constexpr uint64_t kStepsPerCall = 16, kStepsAtOnce = 4096;

}  // namespace

template <class Key>
void KeyTable<Key>::reset(size_t count) {
  const size_t capacity = std::max<size_t>(16, array_bytes(count, 2));
  Buffer<Slot> &slots = swapped_ ? spare_ : slots_;
  slots.require(capacity);
  std::fill(slots.data(), slots.data() + capacity, Slot{Key{}, kEmpty});
  capacity_ = capacity;
  seed_ = kFirstSeed;
  calls_ = steps_ = former_steps_ = 0;
}

template <class Key>
typename KeyTable<Key>::Slot &KeyTable<Key>::locate(const Key &key) {
  calls_++;
  if (__builtin_expect(steps_ > kStepsPerCall * calls_ + kStepsAtOnce, 0)) reseed();
  Slot *const begin = slots(), *const end = begin + capacity_;
  Slot *slot = begin + home(key);
  while (slot->value != kEmpty && !same(slot->key, key)) {
    steps_++;
    if (++slot == end) slot = begin;
  }
  return *slot;
}

// Moves all keys to where another seed puts them. The seed depends on an address, which nobody can have foreseen.
template <class Key>
void KeyTable<Key>::reseed() {
  Buffer<Slot> &to = swapped_ ? slots_ : spare_;
  to.require(capacity_);
  const Slot *const from = slots();
  swapped_ = !swapped_;
  std::fill(to.data(), to.data() + capacity_, Slot{Key{}, kEmpty});
  seed_ = mix(seed_ + reinterpret_cast<uintptr_t>(to.data()));
  former_steps_ += steps_;
  calls_ = steps_ = 0;
  for (const Slot *slot = from; slot < from + capacity_; slot++) {
    if (slot->value == kEmpty) continue;
    size_t at = home(slot->key);
    while (to[at].value != kEmpty) at = at + 1 == capacity_ ? 0 : at + 1;
    to[at] = *slot;
  }
}

template class KeyTable<Compared<hg_pair>>;
template class KeyTable<Compared<hg_contact_key>>;

}  // namespace hg
