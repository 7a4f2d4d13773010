// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The particles as the caller gave them, in ascending id. A slot is a particle's place here; after removals slots are
// closed up, so slot order stays id order while ids have gaps.
#pragma once

#include "src/base/memory.hpp"
#include "src/exact/overlap.hpp"
#include "src/particles/input_check.hpp"
#include "src/particles/optional_column.hpp"
#include "src/particles/short_cell.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

inline constexpr int kAbsent = -1;  // as a group
inline constexpr int32_t kNoBody = -1;

class ParticleStore {
 public:
  ParticleStore(Memory &memory, const InputCheck &check, const ShortCell &cell, int dimension, int32_t index_base);

  // Throw if the next call cannot take so many particles.
  void check_insert(size_t count) const { check_ids(next_id_, count); }
  void check_count(size_t count) const;  // of calls that name all particles
  void check_set(size_t count) const { check_ids(index_base_, count); }
  // Throws and changes nothing if a value is bad.
  void insert(size_t count, const double *centers, const double *radii);
  // *distance, unless NULL, becomes what no particle has moved farther than.
  void move(size_t count, const double *centers, const double *radii, double *distance = nullptr);
  // Exactly these, with ids that start anew.
  void set(size_t count, const double *centers, const double *radii);
  void remove(size_t count, const int32_t *ids);
  void clear();
  // Throws and changes nothing if the particles do not suit the cell.
  void set_cell(const Domain &domain, const ShortCell &cell);
  // Throw and change nothing if a value is bad. False if all have these already.
  bool set_groups(size_t count, const int32_t *groups);
  bool set_bodies(size_t count, const int32_t *bodies);
  // Closes the gaps that remove() left. Slots change.
  void compact() noexcept;

  size_t live_count() const { return slots_ - removed_; }
  size_t slots() const { return slots_; }
  size_t dimension() const { return dimension_; }
  const double *center(size_t slot) const { return centers_.data() + slot * dimension_; }
  double radius(size_t slot) const { return radii_[slot]; }
  const double *centers() const { return centers_.data(); }
  const double *radii() const { return radii_.data(); }
  // Of all that is stored, after compact(). Defined while slots() > 0.
  const InputSummary &summary() const { return summary_; }
  Ball ball(size_t slot) const { return {center(slot), radius(slot)}; }
  // The same of some of them, copied elsewhere.
  InputSummary summarise(const double *centers, const double *radii, size_t count) const {
    return check_.summarise({count, centers, radii, nullptr, nullptr});
  }
  // By slot, after compact(); NULL: all are in group 0, none has a body.
  const int8_t *groups() const { return groups_.data(); }
  const int32_t *bodies() const { return bodies_.data(); }

  // True if ids are those that set() would give.
  bool is_as_set() const { return contiguous_ && removed_ == 0; }
  // While ids have no gaps, id = slot + id_offset(); else id_offset() is 0 and id() has to be asked.
  bool contiguous() const { return contiguous_; }
  int32_t id_offset() const { return contiguous_ ? index_base_ : 0; }
  int32_t id(size_t slot) const { return contiguous_ ? index_base_ + static_cast<int32_t>(slot) : ids_[slot]; }
  // The slot of an id that is stored (removed or not), or slots() if there is none.
  size_t find(int64_t id) const;
  // The same, of an id that is known to be stored.
  size_t slot(int32_t id) const { return contiguous_ ? static_cast<size_t>(id - index_base_) : find(id); }

 private:
  int32_t id_of(size_t slot) const;
  void check_cell(const ShortCell &cell, const double *radii, size_t count, double greatest) const;
  void check_ids(int64_t first, size_t count) const;

  InputCheck check_;
  ShortCell cell_;
  size_t dimension_;
  int32_t index_base_;
  int64_t next_id_;
  InputSummary summary_{};
  size_t slots_ = 0;
  size_t removed_ = 0;
  bool contiguous_ = true;
  Buffer<double> centers_;
  Buffer<double> radii_;
  Buffer<int32_t> ids_;   // kept only once ids have gaps
  Buffer<uint8_t> dead_;  // per slot, valid while removed_ > 0
  Buffer<int8_t> given_groups_;
  OptionalColumn<int8_t> groups_;
  OptionalColumn<int32_t> bodies_;
};

}  // namespace hg
