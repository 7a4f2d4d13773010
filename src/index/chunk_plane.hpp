// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which places of one layer hold a chunk: a bit for each place, and by groups of 8 the number of the first chunk. A bit
// tells in two loads what a search among the chunks of a row tells after several branches.
#pragma once

#include "src/base/memory.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace hg {

// How many bits of a byte are set: no x86 before SSE4.2 counts them in one instruction.
struct OnesOfByte {
  uint8_t of[256] = {};
  constexpr OnesOfByte() {
    for (unsigned n = 1; n < 256; n++) of[n] = static_cast<uint8_t>(of[n / 2] + n % 2);
  }
};
inline constexpr OnesOfByte kOnes{};

class ChunkPlane {
 public:
  explicit ChunkPlane(Memory &memory) : exists_(memory), first_(memory) {}

  // Room for places [0, places); none holds a chunk, as whoever added chunks has removed them.
  void require(size_t places) {
    const size_t groups = places / kGroup + 2;
    if (groups <= groups_) return;
    exists_.require_room(groups);
    first_.require_room(groups);
    groups_ = groups;
    std::fill(exists_.data(), exists_.data() + groups, uint8_t{0});
    std::fill(first_.data(), first_.data() + groups, 0u);
  }

  // Chunks are numbered in the order of their places, and added in it.
  void add(size_t place, uint32_t chunk) {
    const size_t group = place / kGroup;
    first_[group] = exists_[group] == 0 ? chunk : first_[group];
    exists_[group] |= static_cast<uint8_t>(1u << place % kGroup);
  }
  void remove(size_t place) {
    exists_[place / kGroup] = 0;
    first_[place / kGroup] = 0;
  }

  // Which of three places hold a chunk, as bits, and the number of the first one that does.
  struct Three {
    uint32_t exist, first;
  };
  Three three_from(size_t place) const {
    const size_t group = place / kGroup;
    const uint32_t near = exists_[group] | static_cast<uint32_t>(exists_[group + 1]) << kGroup;
    const uint32_t exist = near >> place % kGroup & 7u;
    const size_t found = place + static_cast<size_t>(__builtin_ctz(exist | 8u));
    const uint32_t before = exists_[found / kGroup] & ((1u << found % kGroup) - 1);
    return {exist, first_[found / kGroup] + kOnes.of[before]};
  }

 private:
  static constexpr size_t kGroup = 8;
  Buffer<uint8_t> exists_;
  Buffer<uint32_t> first_;
  size_t groups_ = 0;
};

}  // namespace hg
