// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What tells contacts from one another: a pair as one number, or three numbers. Equality and hashes of both.
#pragma once

#include <hgrid/history.h>

#include <cstdint>
#include <cstring>
#include <utility>

namespace hg {

// What is compared of a pair: both ids as one number.
inline uint64_t compared(const hg_pair &pair) {
  uint64_t key = 0;
  std::memcpy(&key, &pair, sizeof key);
  return key;
}
inline const hg_contact_key &compared(const hg_contact_key &key) { return key; }

// The type of that.
template <class Contact>
using Compared = std::decay_t<decltype(compared(std::declval<const Contact &>()))>;

inline bool same(uint64_t one, uint64_t other) { return one == other; }
inline bool same(const hg_contact_key &one, const hg_contact_key &other) {
  return ((one.a ^ other.a) | (one.b ^ other.b) | (one.sub ^ other.sub)) == 0;
}

// Two rounds of multiply and fold; every bit of the result depends on every bit of x.
inline uint64_t mix(uint64_t x) {
  x ^= x >> 32;
  x *= 0xd6e8feb86659fd93;
  x ^= x >> 32;
  x *= 0xd6e8feb86659fd93;
  return x ^ x >> 32;
}

// A hash that keys cannot be chosen against without the seed.
inline uint64_t hash(uint64_t key, uint64_t seed) { return mix(key ^ seed); }
inline uint64_t hash(const hg_contact_key &key, uint64_t seed) {
  const uint64_t ids = mix(mix(static_cast<uint64_t>(key.a) ^ seed) ^ static_cast<uint64_t>(key.b));
  return mix(ids ^ static_cast<uint64_t>(key.sub));
}

// A hash for where one more key in the same place costs a little time only. Its upper bits count.
inline uint64_t cheap_hash(uint64_t key) { return (key ^ key >> 29) * 0x9e3779b97f4a7c15; }
inline uint64_t cheap_hash(const hg_contact_key &key) {
  const uint64_t ids = cheap_hash(static_cast<uint64_t>(key.a)) ^ static_cast<uint64_t>(key.b);
  return cheap_hash(cheap_hash(ids) ^ static_cast<uint64_t>(key.sub));
}

}  // namespace hg
