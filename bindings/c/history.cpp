// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The functions of include/hgrid/history.h.
#include "bindings/c/guard.hpp"
#include "src/history/contact_history.hpp"

#include <hgrid/history.h>

#include <cstring>
#include <type_traits>

using hg::check_pointer;
using hg::check_pointers;
using hg::ContactHistory;
using hg::fail;
using hg::guarded;

struct hg_history {
  ContactHistory history;
};

namespace {

bool overlap(const void *one, size_t one_size, const void *other, size_t other_size) {
  const auto p = reinterpret_cast<uintptr_t>(one), q = reinterpret_cast<uintptr_t>(other);
  return p < q + other_size && q < p + one_size;
}

// Items of a fixed size that the compiler knows are copied by a few instructions, others by a call.
template <size_t Size>
void carry(const ContactHistory &history, size_t size, const char *from, char *to) {
  const size_t item = Size > 0 ? Size : size;
  const int64_t *const previous = history.previous();
  for (size_t k = 0; k < history.now().count; k++, to += item) {
    if (previous[k] >= 0) {
      std::memcpy(to, from + static_cast<size_t>(previous[k]) * item, item);
    } else {
      std::memset(to, 0, item);
    }
  }
}

void carry_items(const ContactHistory &history, size_t size, const void *old_items, void *new_items) {
  const auto *from = static_cast<const char *>(old_items);
  auto *to = static_cast<char *>(new_items);
  switch (size) {
    case 4:
      return carry<4>(history, size, from, to);
    case 8:
      return carry<8>(history, size, from, to);
    case 16:
      return carry<16>(history, size, from, to);
    case 24:
      return carry<24>(history, size, from, to);
    case 32:
      return carry<32>(history, size, from, to);
    default:
      return carry<0>(history, size, from, to);
  }
}

void check_matched(const ContactHistory &history) {
  if (!history.matched()) {
    fail(HG_ERR_STATE, "no list has been matched since the history was created, cleared or restored");
  }
}

// Runs `body` on a history, constant or not.
template <class Handle, class Body>
hg_status on_history(Handle *history, Body &&body) noexcept {
  return guarded([&] {
    check_pointer(history, "history");
    body(history->history);
  });
}

template <class Contact>
hg_status update(hg_history *history, size_t count, const Contact *contacts, const char *name,
                 const int64_t **previous) {
  return on_history(history, [&](ContactHistory &h) {
    if (count > 0) check_pointer(contacts, name);
    check_pointer(previous, "previous");
    h.update(count, contacts);
    *previous = count > 0 ? h.previous() : nullptr;
  });
}

template <class Contact>
hg_status restore(hg_history *history, size_t count, const Contact *contacts, const char *name) {
  return on_history(history, [&](ContactHistory &h) {
    if (count > 0) check_pointer(contacts, name);
    h.restore(count, contacts);
  });
}

// The contacts of a list that is asked for as one of pairs, or as one of keys.
template <class Contact>
const Contact *contacts_of(const ContactHistory::List &list, const char *which) {
  constexpr bool kWantsKeys = std::is_same_v<Contact, hg_contact_key>;
  if (list.count == 0) return nullptr;
  if (list.keyed != kWantsKeys) {
    fail(HG_ERR_STATE, "the %s was given as one of %s, not of %s", which, list.keyed ? "keys" : "pairs",
         kWantsKeys ? "keys" : "pairs");
  }
  return list.contacts<Contact>().data();
}

template <class Contact>
hg_status remembered(const hg_history *history, const Contact **contacts, const char *name, size_t *count) {
  return on_history(history, [&](const ContactHistory &h) {
    check_pointers({{contacts, name}, {count, "count"}});
    const Contact *const list = contacts_of<Contact>(h.now(), "list");
    *contacts = list;
    *count = h.now().count;
  });
}

template <class Contact>
hg_status ended(hg_history *history, const Contact **contacts, const char *name, const int64_t **places,
                size_t *count) {
  return on_history(history, [&](ContactHistory &h) {
    check_pointers({{contacts, name}, {places, "places"}, {count, "count"}});
    check_matched(h);
    const ContactHistory::List &list = h.ended();
    const Contact *const gone = contacts_of<Contact>(list, "list before");
    *contacts = gone;
    *places = list.count > 0 ? list.previous.data() : nullptr;
    *count = list.count;
  });
}

}  // namespace

hg_status hg_history_create(hg_history **history) {
  if (history != nullptr) *history = nullptr;
  return guarded([&] {
    check_pointer(history, "history");
    *history = hg::make_object<hg_history>(
        [](void *memory, const hg_allocator &allocator) { return new (memory) hg_history{ContactHistory(allocator)}; });
  });
}

void hg_history_destroy(hg_history *history) {
  if (history != nullptr) hg::free_object(history, history->history.allocator());
}

hg_status hg_history_update(hg_history *history, size_t count, const hg_pair *pairs, const int64_t **previous) {
  return update(history, count, pairs, "pairs", previous);
}

hg_status hg_history_update_keys(hg_history *history, size_t count, const hg_contact_key *keys,
                                 const int64_t **previous) {
  return update(history, count, keys, "keys", previous);
}

hg_status hg_history_carry(const hg_history *history, size_t item_size, const void *old_items, void *new_items) {
  return on_history(history, [&](const ContactHistory &h) {
    check_matched(h);
    if (item_size == 0) fail(HG_ERR_ARGUMENT, "item_size = 0: a contact's data must have at least one byte");
    if (h.former_count() > 0) check_pointer(old_items, "old_items");
    if (h.now().count > 0) check_pointer(new_items, "new_items");
    const size_t old_bytes = hg::array_bytes(h.former_count(), item_size);
    const size_t new_bytes = hg::array_bytes(h.now().count, item_size);
    if (overlap(old_items, old_bytes, new_items, new_bytes)) fail(HG_ERR_ARGUMENT, "old_items and new_items overlap");
    carry_items(h, item_size, old_items, new_items);
  });
}

hg_status hg_history_ended(hg_history *history, const hg_pair **pairs, const int64_t **places, size_t *count) {
  return ended(history, pairs, "pairs", places, count);
}

hg_status hg_history_ended_keys(hg_history *history, const hg_contact_key **keys, const int64_t **places,
                                size_t *count) {
  return ended(history, keys, "keys", places, count);
}

hg_status hg_history_pairs(const hg_history *history, const hg_pair **pairs, size_t *count) {
  return remembered(history, pairs, "pairs", count);
}

hg_status hg_history_keys(const hg_history *history, const hg_contact_key **keys, size_t *count) {
  return remembered(history, keys, "keys", count);
}

hg_status hg_history_restore(hg_history *history, size_t count, const hg_pair *pairs) {
  return restore(history, count, pairs, "pairs");
}

hg_status hg_history_restore_keys(hg_history *history, size_t count, const hg_contact_key *keys) {
  return restore(history, count, keys, "keys");
}

hg_status hg_history_clear(hg_history *history) { return hg_history_restore(history, 0, nullptr); }
