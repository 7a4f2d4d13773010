// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The particles that take part in the search, class by class: all but the absent ones. They are what an index is built
// of. Where all of a store take part as one class they are the store's own arrays, else copies.
#pragma once

#include "src/base/memory.hpp"
#include "src/particles/group_table.hpp"
#include "src/particles/particle_store.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace hg {

// Where the particles of each class begin.
struct ClassRanges {
  int count = 1;
  size_t begin[HG_MAX_GROUPS + 1] = {0, 0};

  size_t end() const { return begin[count]; }
  // Calls body(class, begin, end) for the parts of [begin, end).
  template <class Body>
  void each(size_t first, size_t last, Body &&body) const {
    for (int c = 0; c < count; c++) {
      const size_t from = std::max(first, begin[c]), to = std::min(last, begin[c + 1]);
      if (from < to) body(c, from, to);
    }
  }
};

class Participants {
 public:
  Participants() = default;
  // All of a store without gaps, as one class.
  Participants(const ParticleStore &store,  // NOLINT(google-explicit-constructor): a store is a case of this
               const GroupClasses &classes = {})
      : centers_(store.centers()),
        radii_(store.radii()),
        bodies_(store.bodies()),
        summary_(&store.summary()),
        dimension_(store.dimension()),
        classes_(classes) {
    ranges_.begin[1] = store.slots();
  }
  // Those in `slots`; centers and radii are in their order.
  Participants(const ParticleStore &store, const double *centers, const double *radii, const uint32_t *slots,
               const InputSummary &summary, const ClassRanges &ranges, const GroupClasses &classes)
      : centers_(centers),
        radii_(radii),
        slots_(slots),
        bodies_(store.bodies()),
        summary_(&summary),
        dimension_(store.dimension()),
        ranges_(ranges),
        classes_(classes) {}

  size_t count() const { return ranges_.end(); }
  const double *centers() const { return centers_; }
  const double *radii() const { return radii_; }
  const double *center(size_t k) const { return centers_ + k * dimension_; }
  double radius(size_t k) const { return radii_[k]; }
  // Of them all, or of more. Defined while count() > 0.
  const InputSummary &summary() const { return *summary_; }
  const ClassRanges &ranges() const { return ranges_; }
  const GroupClasses &classes() const { return classes_; }
  // Of each its slot in the store; NULL if it is k itself.
  const uint32_t *slots() const { return slots_; }
  // By slot; NULL: none has one.
  const int32_t *bodies() const { return bodies_; }
  // Those of one class.
  Participants of_class(int c) const {
    Participants some = *this;
    const size_t begin = ranges_.begin[c];
    some.centers_ += begin * dimension_;
    some.radii_ += begin;
    if (slots_ != nullptr) some.slots_ += begin;
    some.ranges_ = {};
    some.ranges_.begin[1] = ranges_.begin[c + 1] - begin;
    return some;
  }

 private:
  const double *centers_ = nullptr, *radii_ = nullptr;
  const uint32_t *slots_ = nullptr;
  const int32_t *bodies_ = nullptr;
  const InputSummary *summary_ = nullptr;
  size_t dimension_ = 3;
  ClassRanges ranges_;
  GroupClasses classes_;
};

// Gathers them.
class ParticipantList {
 public:
  explicit ParticipantList(Memory &memory) : slots_(memory), centers_(memory), radii_(memory) {}

  // Of a store without gaps, which must stay as it is while they are used. O(N) if there are groups, else O(1).
  Participants of(const ParticleStore &store, const GroupTable &table, int threads);
  // To be called when groups have changed, or which slots there are.
  void groups_changed() { listed_ = false; }

 private:
  void list(const ParticleStore &store, const GroupTable &table);

  bool listed_ = false;
  bool all_alike_ = false;  // all take part, as one class
  ClassRanges ranges_;
  GroupClasses classes_;
  InputSummary summary_{};
  Buffer<uint32_t> slots_;
  Buffer<double> centers_, radii_;
};

}  // namespace hg
