// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The C interface for C++17: a grid and a contact history that free themselves, results as views, failures thrown.
//
//   hgrid::Grid grid(def);
//   grid.insert(count, centers, radii);
//   for (hg_pair pair : grid.query_pairs()) ...
//
// Every call of hgrid/grid.h and hgrid/history.h is a member with the arguments of the C call, whose comment there
// holds for it; what C writes through pointers is the result. For other C calls there are get(), the C handle, and
// check(). Ownership: one object owns one C handle. It can be moved, not copied; an object that was moved from may be
// destroyed or assigned to, any other call on it throws HG_ERR_NULL. A grid must not be destroyed or assigned to from
// inside a visitor of its own. Views own nothing: they end when the C call says that its result does, and with their
// object. Threads: as for the C calls. Errors: a call that throws has changed nothing.
#pragma once

#include <hgrid/hgrid.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <stdexcept>
#include <type_traits>

namespace hgrid {

// A call that failed: its status, and the text of hg_last_error as what().
class Error : public std::runtime_error {
 public:
  explicit Error(hg_status status) : std::runtime_error(hg_last_error()), status_(status) {}
  hg_status status() const noexcept { return status_; }

 private:
  hg_status status_;
};

// Throws what went wrong in the last C call of this thread, if its status says that something did.
inline void check(hg_status status) {
  if (status != HG_OK) throw Error(status);
}

// A borrowed array.
template <class T>
class View {
 public:
  View() = default;
  View(const T *data, size_t size) : data_(data), size_(size) {}

  const T *data() const { return data_; }
  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T *begin() const { return data_; }
  const T *end() const { return data_ + size_; }
  const T &operator[](size_t place) const { return data_[place]; }

 private:
  const T *data_ = nullptr;
  size_t size_ = 0;
};

// Borrowed lists in compressed rows: row k holds ids[offsets[k]] .. ids[offsets[k + 1] - 1].
struct Rows {
  View<int64_t> offsets;  // one more than rows
  View<int32_t> ids;

  size_t size() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  View<int32_t> operator[](size_t row) const {
    return {ids.data() + offsets[row], static_cast<size_t>(offsets[row + 1] - offsets[row])};
  }
};

// What leads from a to b in each pair, and through which image: as many numbers for each as the grid has dimensions.
struct PairVectors {
  View<double> vectors;
  View<int32_t> shifts;
};

// Contacts that ended, and their places in the list before.
struct EndedPairs {
  View<hg_pair> pairs;
  View<int64_t> places;
};
struct EndedKeys {
  View<hg_contact_key> keys;
  View<int64_t> places;
};

namespace detail {

template <class Handle, void (*destroy)(Handle *)>
struct Destroy {
  void operator()(Handle *handle) const { destroy(handle); }
};

// What a C call lends through its last two arguments, (const T **data, size_t *count).
template <class T, class Call, class... Arguments>
View<T> lent(Call call, Arguments... arguments) {
  const T *data = nullptr;
  size_t count = 0;
  check(call(arguments..., &data, &count));
  return {data, count};
}

// The same through (const int64_t **offsets, const int32_t **ids), so many rows.
template <class Call, class... Arguments>
Rows lent_rows(size_t rows, Call call, Arguments... arguments) {
  const int64_t *offsets = nullptr;
  const int32_t *ids = nullptr;
  check(call(arguments..., &offsets, &ids));
  return {{offsets, rows + 1}, {ids, static_cast<size_t>(offsets[rows])}};
}

// A callable on its way through C, and what it threw there.
template <class Visit>
struct Visitor {
  Visit &visit;
  std::exception_ptr thrown;
};

template <class Visit, class... Batch>
int32_t forward(void *context, Batch... batch) noexcept {
  auto &visitor = *static_cast<Visitor<Visit> *>(context);
  try {
    if constexpr (std::is_void_v<std::invoke_result_t<Visit &, Batch...>>) {
      visitor.visit(batch...);
      return 0;
    } else {
      return visitor.visit(batch...) ? 1 : 0;
    }
  } catch (...) {
    visitor.thrown = std::current_exception();
    return 1;
  }
}

// Runs a visit with a callable that takes what the C visitor takes behind its context. No exception crosses C: one of
// the callable ends the visit and is thrown again after it.
template <class Visit, class... Batch>
void visit_with(Visit &visit, hg_status (*call)(hg_grid *, int32_t (*)(void *, Batch...), void *), hg_grid *grid) {
  Visitor<Visit> visitor{visit, nullptr};
  const hg_status status = call(grid, forward<Visit, Batch...>, &visitor);
  if (visitor.thrown) std::rethrow_exception(visitor.thrown);
  check(status);
}

}  // namespace detail

class Grid {
 public:
  // Empty, with the defaults or as `def` says.
  Grid() : Grid(nullptr) {}
  explicit Grid(const hg_grid_def &def) : Grid(&def) {}

  // The C handle; NULL if this was moved from. It stays this object's.
  hg_grid *get() const noexcept { return handle_.get(); }

  void insert(size_t count, const double *centers, const double *radii) {
    check(hg_insert(get(), count, centers, radii));
  }
  void move(size_t count, const double *centers, const double *radii = nullptr) {
    check(hg_move(get(), count, centers, radii));
  }
  void set(size_t count, const double *centers, const double *radii) { check(hg_set(get(), count, centers, radii)); }
  void insert_arrays(size_t count, const hg_array *centers, const hg_array *radius) {
    check(hg_insert_arrays(get(), count, centers, radius));
  }
  void move_arrays(size_t count, const hg_array *centers, const hg_array *radius = nullptr) {
    check(hg_move_arrays(get(), count, centers, radius));
  }
  void set_arrays(size_t count, const hg_array *centers, const hg_array *radius) {
    check(hg_set_arrays(get(), count, centers, radius));
  }
  void remove(size_t count, const int32_t *ids) { check(hg_remove(get(), count, ids)); }
  void clear() { check(hg_clear(get())); }
  void set_box(const double *box_min, const double *box_max, const double *tilt = nullptr) {
    check(hg_set_box(get(), box_min, box_max, tilt));
  }
  void set_groups(size_t count, const int32_t *groups) { check(hg_set_groups(get(), count, groups)); }
  void set_group_pair(int32_t group_a, int32_t group_b, bool interacts) {
    check(hg_set_group_pair(get(), group_a, group_b, interacts ? 1 : 0));
  }
  void set_bodies(size_t count, const int32_t *bodies) { check(hg_set_bodies(get(), count, bodies)); }
  void build() { check(hg_build(get())); }

  View<hg_pair> query_pairs() const { return detail::lent<hg_pair>(hg_query_pairs, get()); }
  PairVectors query_pair_vectors() const {
    const double *vectors = nullptr;
    const int32_t *shifts = nullptr;
    check(hg_query_pair_vectors(get(), &vectors, &shifts));
    const size_t numbers = query_pairs().size() * dimension_;
    return {{vectors, numbers}, {shifts, numbers}};
  }
  // Returns the number of pairs. *count, if given, becomes it also where HG_ERR_CAPACITY is thrown.
  size_t copy_pairs(size_t capacity, int32_t *a, int32_t *b, size_t *count = nullptr) const {
    size_t found = 0;
    const hg_status status = hg_copy_pairs(get(), capacity, a, b, &found);
    return copied(status, found, count);
  }
  // The same of neighbour lists: offsets[particles + 1], complete also where HG_ERR_CAPACITY is thrown.
  size_t copy_neighbors(int32_t list, size_t capacity, int32_t *offsets, int32_t *neighbors,
                        size_t *count = nullptr) const {
    size_t found = 0;
    const hg_status status = hg_copy_neighbors(get(), list, capacity, offsets, neighbors, &found);
    return copied(status, found, count);
  }
  // `visit` is any callable that takes a batch, as View<hg_pair> or as (const hg_pair *pairs, size_t count). It returns
  // nothing, or what is true to end the visit; what it throws also ends it, and is thrown from here.
  template <class Visit>
  void visit_pairs(Visit &&visit) const {
    if constexpr (std::is_invocable_v<Visit &, View<hg_pair>>) {
      const auto batch = [&](const hg_pair *pairs, size_t count) { return visit(View<hg_pair>(pairs, count)); };
      detail::visit_with(batch, hg_visit_pairs, get());
    } else {
      detail::visit_with(visit, hg_visit_pairs, get());
    }
  }
  void visit_pairs(hg_pair_visitor *visit, void *context) const { check(hg_visit_pairs(get(), visit, context)); }
  // The same with a callable that takes a const hg_contact_batch &.
  template <class Visit>
  void visit_contacts(Visit &&visit) const {
    const auto batch = [&](const hg_contact_batch *contacts) { return visit(*contacts); };
    detail::visit_with(batch, hg_visit_contacts, get());
  }
  void visit_contacts(hg_contact_visitor *visit, void *context) const {
    check(hg_visit_contacts(get(), visit, context));
  }
  Rows query_neighbors(int32_t list) const {
    return detail::lent_rows(static_cast<size_t>(get_stats().particle_count), hg_query_neighbors, get(), list);
  }
  View<int32_t> query_sphere(const double *center, double radius) const {
    return detail::lent<int32_t>(hg_query_sphere, get(), center, radius);
  }
  Rows query_spheres(size_t count, const double *centers, const double *radii) const {
    return detail::lent_rows(count, hg_query_spheres, get(), count, centers, radii);
  }
  Rows query_boxes(size_t count, const double *low, const double *high) const {
    return detail::lent_rows(count, hg_query_boxes, get(), count, low, high);
  }
  Rows query_triangles(size_t count, const double *corners) const {
    return detail::lent_rows(count, hg_query_triangles, get(), count, corners);
  }
  View<int32_t> query_order() const { return detail::lent<int32_t>(hg_query_order, get()); }
  bool overlap(const double *center_a, double radius_a, const double *center_b, double radius_b) const {
    int32_t overlaps = 0;
    check(hg_overlap(get(), center_a, radius_a, center_b, radius_b, &overlaps));
    return overlaps != 0;
  }
  View<hg_level> query_levels() const { return detail::lent<hg_level>(hg_query_levels, get()); }
  View<hg_level_cost> query_level_costs() const { return detail::lent<hg_level_cost>(hg_query_level_costs, get()); }
  hg_grid_stats get_stats() const {
    hg_grid_stats stats{};
    check(hg_get_stats(get(), &stats, sizeof stats));
    return stats;
  }

 private:
  // Ends a copy into arrays of the caller's, who may want to know what is needed where they are too small.
  static size_t copied(hg_status status, size_t found, size_t *count) {
    if (count != nullptr && (status == HG_OK || status == HG_ERR_CAPACITY)) *count = found;
    check(status);
    return found;
  }

  explicit Grid(const hg_grid_def *def) : dimension_(def != nullptr ? static_cast<size_t>(def->dimension) : 3) {
    hg_grid *created = nullptr;
    check(hg_create(def, &created));
    handle_.reset(created);
  }

  std::unique_ptr<hg_grid, detail::Destroy<hg_grid, hg_destroy>> handle_;
  size_t dimension_;
};

class History {
 public:
  // It remembers an empty list.
  History() {
    hg_history *created = nullptr;
    check(hg_history_create(&created));
    handle_.reset(created);
  }

  // The C handle; NULL if this was moved from. It stays this object's.
  hg_history *get() const noexcept { return handle_.get(); }

  // The place of each contact in the former list, or -1.
  View<int64_t> update(size_t count, const hg_pair *pairs) { return update_by(hg_history_update, count, pairs); }
  View<int64_t> update_keys(size_t count, const hg_contact_key *keys) {
    return update_by(hg_history_update_keys, count, keys);
  }
  void carry(size_t item_size, const void *old_items, void *new_items) const {
    check(hg_history_carry(get(), item_size, old_items, new_items));
  }
  EndedPairs ended() { return ended_by<EndedPairs, hg_pair>(hg_history_ended); }
  EndedKeys ended_keys() { return ended_by<EndedKeys, hg_contact_key>(hg_history_ended_keys); }
  View<hg_pair> pairs() const { return detail::lent<hg_pair>(hg_history_pairs, get()); }
  View<hg_contact_key> keys() const { return detail::lent<hg_contact_key>(hg_history_keys, get()); }
  void restore(size_t count, const hg_pair *pairs) { check(hg_history_restore(get(), count, pairs)); }
  void restore_keys(size_t count, const hg_contact_key *keys) { check(hg_history_restore_keys(get(), count, keys)); }
  void clear() { check(hg_history_clear(get())); }

 private:
  template <class Call, class Contact>
  View<int64_t> update_by(Call call, size_t count, const Contact *contacts) {
    const int64_t *previous = nullptr;
    check(call(get(), count, contacts, &previous));
    return {previous, count};
  }
  template <class Ended, class Contact, class Call>
  Ended ended_by(Call call) {
    const Contact *contacts = nullptr;
    const int64_t *places = nullptr;
    size_t count = 0;
    check(call(get(), &contacts, &places, &count));
    return {{contacts, count}, {places, count}};
  }

  std::unique_ptr<hg_history, detail::Destroy<hg_history, hg_history_destroy>> handle_;
};

}  // namespace hgrid
