// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The particles as the caller gave them, in ascending id. A slot is a particle's place here; after removals slots are
// closed up, so slot order stays id order while ids have gaps.
#pragma once

#include "src/base/memory.hpp"
#include "src/exact/domain.hpp"
#include "src/exact/interaction.hpp"
#include "src/exact/overlap.hpp"
#include "src/kernels/kernel.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

class ParticleStore {
 public:
  // `largest_diameter`: what the coarsest user-given cell can hold; infinite if cells follow the particles.
  ParticleStore(Memory &memory, const Domain &domain, const Interaction &interaction, int32_t index_base,
                double largest_diameter, int threads = 1);

  // Throws and changes nothing if a value is bad.
  void insert(size_t count, const double *centers, const double *radii);
  void move(size_t count, const double *centers, const double *radii);
  void remove(size_t count, const int32_t *ids);
  void clear();
  // Closes the gaps that remove() left. Slots change.
  void compact() noexcept;

  size_t live_count() const { return slots_ - removed_; }
  size_t slots() const { return slots_; }
  const double *center(size_t slot) const { return centers_.data() + slot * dimension_; }
  double radius(size_t slot) const { return radii_[slot]; }
  const double *centers() const { return centers_.data(); }
  const double *radii() const { return radii_.data(); }
  // Extremes of all that is stored, after compact(). Defined while slots() > 0.
  const Survey &survey() const { return survey_; }
  Ball ball(size_t slot) const { return {center(slot), radius(slot)}; }

  // While ids have no gaps, id = slot + id_offset(); else id_offset() is 0 and id() has to be asked.
  bool contiguous() const { return contiguous_; }
  int32_t id_offset() const { return contiguous_ ? index_base_ : 0; }
  int32_t id(size_t slot) const { return contiguous_ ? index_base_ + static_cast<int32_t>(slot) : ids_[slot]; }
  // The slot of an id that is stored (removed or not), or slots() if there is none.
  size_t find(int64_t id) const;

 private:
  Survey look_at(const SurveyInput &input) const;
  // Throws if something is wrong with the arrays that `found` is about.
  void check(const SurveyInput &input, const Survey &found) const;
  void check_wraps(const SurveyInput &input, const Survey &found) const;
  void check_box(size_t index, double radius) const;
  [[noreturn]] void report(size_t count, const double *centers, const double *radii) const;

  Domain domain_;
  Interaction interaction_;
  size_t dimension_;
  int32_t index_base_;
  double largest_diameter_;
  int threads_;
  int64_t next_id_;
  Survey survey_{};
  size_t slots_ = 0;
  size_t removed_ = 0;
  bool contiguous_ = true;
  Buffer<double> centers_;
  Buffer<double> radii_;
  Buffer<int32_t> ids_;   // kept only once ids have gaps
  Buffer<uint8_t> dead_;  // per slot, valid while removed_ > 0
};

}  // namespace hg
