// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The list of contacts of the last step, and the match of a new list to it.
#pragma once

#include "src/base/memory.hpp"
#include "src/history/list_match.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace hg {

class ContactHistory {
 public:
  // A list as it was given: pairs or keys. One of nothing is either.
  struct List {
    explicit List(Memory &memory) : pairs(memory), keys(memory), previous(memory) {}
    size_t count = 0;
    bool keyed = false;  // keys hold the contacts, else pairs
    Buffer<hg_pair> pairs;
    Buffer<hg_contact_key> keys;
    Buffer<int64_t> previous;

    template <class Contact>
    const Buffer<Contact> &contacts() const {
      if constexpr (std::is_same_v<Contact, hg_pair>) {
        return pairs;
      } else {
        return keys;
      }
    }
    template <class Contact>
    Buffer<Contact> &contacts() {
      return const_cast<Buffer<Contact> &>(std::as_const(*this).contacts<Contact>());
    }
  };

  explicit ContactHistory(const hg_allocator &allocator);

  // Remembers a list; afterwards previous() says where each contact was in the list before. A pair is the key whose
  // sub-key is 0. Throws HG_ERR_ARGUMENT if a contact comes twice; then nothing has changed.
  void update(size_t count, const hg_pair *pairs);
  void update(size_t count, const hg_contact_key *keys);
  // Remembers a list without reference to another.
  void restore(size_t count, const hg_pair *pairs);
  void restore(size_t count, const hg_contact_key *keys);

  const List &now() const { return lists_[current_]; }
  // Whether the remembered list was matched to one before, of former_count() contacts.
  bool matched() const { return matched_; }
  size_t former_count() const { return former_count_; }
  const int64_t *previous() const { return now().previous.data(); }  // -1: was not there
  // The contacts of the list before that are no more, as it was given; `previous` holds their places in it, which
  // ascend. Only if matched().
  const List &ended();

  const hg_allocator &allocator() const { return memory_.allocator(); }

 private:
  template <class Contact>
  void take(size_t count, const Contact *contacts, const List &old);
  size_t match(const List &old, ListView<hg_pair> list, int64_t *previous);
  size_t match(const List &old, ListView<hg_contact_key> list, int64_t *previous);
  ListView<hg_contact_key> widen(ListView<hg_pair> list);
  void find_ended();
  template <class Contact>
  void copy_ended(const List &old);

  Memory memory_;
  ListMatch<hg_pair> pair_match_;
  ListMatch<hg_contact_key> key_match_;
  Buffer<hg_contact_key> widened_;
  const List nothing_;
  List lists_[2];
  int current_ = 0;
  size_t former_count_ = 0, kept_count_ = 0;
  bool matched_ = false;
  bool ended_known_ = false;
  List ended_;
  Buffer<uint8_t> kept_;
};

}  // namespace hg
