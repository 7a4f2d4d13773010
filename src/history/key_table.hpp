// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A hash table from keys to places (open addressing, at most half full), and a filter for keys that are not in it.
#pragma once

#include "src/base/memory.hpp"
#include "src/base/wide.hpp"
#include "src/history/contact_key.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace hg {

// A number below `range` from the upper bits of a hash.
inline size_t scale_hash(uint64_t hash, size_t range) {
  return static_cast<size_t>(static_cast<uint64_t>(wide_product(hash, range) >> 64));
}

// One bit for each of some keys, in so little memory that it stays in the nearest cache while a few are looked for
// among many.
class KeyFilter {
 public:
  explicit KeyFilter(Memory &memory) : words_(memory) {}

  // Empties the filter and makes room for `count` keys: about one in 16 others is then let through.
  void reset(size_t count) {
    bits_ = array_bytes(count, 16) + 64;
    words_.require(bits_ / 64 + 1);
    std::memset(words_.data(), 0, (bits_ / 64 + 1) * sizeof words_[0]);
  }
  template <class Key>
  void add(const Key &key) {
    const size_t bit = scale_hash(cheap_hash(key), bits_);
    words_[bit / 64] |= uint64_t{1} << bit % 64;
  }
  // False only for keys that were not added.
  template <class Key>
  bool may_hold(const Key &key) const {
    const size_t bit = scale_hash(cheap_hash(key), bits_);
    return (words_[bit / 64] >> bit % 64 & 1) != 0;
  }

 private:
  Buffer<uint64_t> words_;
  size_t bits_ = 0;
};

template <class Key>
class KeyTable {
 public:
  struct Slot {
    Key key;
    int64_t value;  // kEmpty: no key here
  };
  static constexpr int64_t kEmpty = INT64_MIN;

  explicit KeyTable(Memory &memory) : slots_(memory), spare_(memory) {}

  // Empties the table and makes room for `count` keys.
  void reset(size_t count);
  // The slot of a key: empty if the table does not hold it. Fill it in to insert. Valid until the next call.
  Slot &locate(const Key &key);
  // Tells the processor that locate(key) will follow soon.
  void prefetch(const Key &key) const { __builtin_prefetch(slots() + home(key)); }

  // Slots passed over since the last reset, of all seeds.
  uint64_t steps() const { return steps_ + former_steps_; }
  // Where the search for a key begins with the seed that each reset starts from.
  static uint64_t first_hash(const Key &key) { return hash(key, kFirstSeed); }

 private:
  static constexpr uint64_t kFirstSeed = 0x243f6a8885a308d3;

  size_t home(const Key &key) const { return scale_hash(hash(key, seed_), capacity_); }
  Slot *slots() { return swapped_ ? spare_.data() : slots_.data(); }
  const Slot *slots() const { return swapped_ ? spare_.data() : slots_.data(); }
  void reseed();

  Buffer<Slot> slots_, spare_;
  bool swapped_ = false;
  size_t capacity_ = 0;
  uint64_t seed_ = kFirstSeed;
  uint64_t calls_ = 0, steps_ = 0, former_steps_ = 0;
};

}  // namespace hg
