// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the contacts of one list stand in another.
#pragma once

#include "src/base/memory.hpp"
#include "src/history/contact_key.hpp"
#include "src/history/key_table.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

// A list of contacts: hg_pair or hg_contact_key.
template <class Contact>
struct ListView {
  const Contact *contacts;
  size_t count;
  Compared<Contact> operator[](size_t k) const { return compared(contacts[k]); }
};

template <class Contact>
class ListMatch {
 public:
  explicit ListMatch(Memory &memory) : table_(memory), filter_(memory) {}

  // previous[k] becomes the place of list[k] in `old`, or -1 if it is not there. The result is the number of those
  // that are. Throws HG_ERR_ARGUMENT if `list` holds a contact twice; `old` must not.
  size_t match(ListView<Contact> old, ListView<Contact> list, int64_t *previous);

 private:
  using Table = KeyTable<Compared<Contact>>;

  size_t look_up(ListView<Contact> old, size_t walked, ListView<Contact> list, int64_t *previous);
  void refuse_twice(ListView<Contact> list, size_t fresh, const int64_t *previous);

  Table table_;
  KeyFilter filter_;
};

}  // namespace hg
