// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The list of pairs of the last step, and the match of a new list to it.
#pragma once

#include "src/base/memory.hpp"
#include "src/history/pair_table.hpp"

#include <hgrid/types.h>

#include <cstddef>
#include <cstdint>

namespace hg {

class ContactHistory {
 public:
  explicit ContactHistory(const hg_allocator &allocator);

  // Remembers a list; afterwards previous() says where each pair was in the list before.
  // Throws HG_ERR_ARGUMENT if a pair comes twice; then nothing has changed.
  void update(size_t count, const hg_pair *pairs);
  // Remembers a list without reference to another.
  void restore(size_t count, const hg_pair *pairs);

  size_t count() const { return now().count; }
  const hg_pair *pairs() const { return now().pairs.data(); }
  // Whether the remembered list was matched to one before, of former_count() pairs.
  bool matched() const { return matched_; }
  size_t former_count() const { return former_count_; }
  const int64_t *previous() const { return now().previous.data(); }  // -1: was not there

  const hg_allocator &allocator() const { return memory_.allocator(); }

 private:
  struct List {
    explicit List(Memory &memory) : pairs(memory), previous(memory) {}
    Buffer<hg_pair> pairs;
    Buffer<int64_t> previous;
    size_t count = 0;
  };

  const List &now() const { return lists_[current_]; }
  void take(size_t count, const hg_pair *pairs, const List &old);
  static size_t walk(const List &old, List &list);
  size_t look_up(const List &old, size_t walked, List &list);
  void refuse_twice(const List &list, size_t fresh);

  Memory memory_;
  PairTable table_;
  PairFilter filter_;
  const List nothing_;
  List lists_[2];
  int current_ = 0;
  size_t former_count_ = 0;
  bool matched_ = false;
};

}  // namespace hg
