// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "particle_store.hpp"

#include "error.hpp"
#include "exact_sign.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace hg {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr int64_t kMaxId = std::numeric_limits<int32_t>::max();

// Written so that it holds for NaN too, and without branches so that it vectorises.
bool all_finite(const double *values, size_t count) {
  size_t bad = 0;
  for (size_t i = 0; i < count; i++) bad += !(std::fabs(values[i]) <= kLargest);
  return bad == 0;
}

bool all_not_negative(const double *values, size_t count) {
  size_t bad = 0;
  for (size_t i = 0; i < count; i++) bad += !(values[i] >= 0);
  return bad == 0;
}

}  // namespace

ParticleStore::ParticleStore(Memory &memory, const Domain &domain, const Interaction &interaction, int32_t index_base,
                             double largest_diameter)
    : domain_(domain),
      interaction_(interaction),
      dimension_(static_cast<size_t>(domain.dimension)),
      index_base_(index_base),
      largest_diameter_(largest_diameter),
      next_id_(index_base),
      centers_(memory),
      radii_(memory),
      ids_(memory),
      dead_(memory) {}

void ParticleStore::insert(size_t count, const double *centers, const double *radii) {
  if (count == 0) return;
  if (static_cast<uint64_t>(count) > static_cast<uint64_t>(kMaxId - next_id_) + 1) {
    fail(HG_ERR_LIMIT, "%zu particles more: ids would pass %lld", count, static_cast<long long>(kMaxId));
  }
  check(count, centers, radii);
  centers_.grow((slots_ + count) * dimension_);
  radii_.grow(slots_ + count);
  if (!contiguous_) ids_.grow(slots_ + count);
  if (removed_ > 0) dead_.grow(slots_ + count);

  std::memcpy(centers_.data() + slots_ * dimension_, centers, count * dimension_ * sizeof(double));
  std::memcpy(radii_.data() + slots_, radii, count * sizeof(double));
  for (size_t i = 0; !contiguous_ && i < count; i++) {
    ids_[slots_ + i] = static_cast<int32_t>(next_id_ + static_cast<int64_t>(i));
  }
  if (removed_ > 0) std::memset(dead_.data() + slots_, 0, count);
  slots_ += count;
  next_id_ += static_cast<int64_t>(count);
}

void ParticleStore::move(size_t count, const double *centers, const double *radii) {
  if (count != live_count()) {
    fail(HG_ERR_ARGUMENT, "count is %zu but the grid holds %zu particles", count, live_count());
  }
  if (count == 0) return;
  check(count, centers, radii);
  compact();
  std::memcpy(centers_.data(), centers, count * dimension_ * sizeof(double));
  if (radii != nullptr) std::memcpy(radii_.data(), radii, count * sizeof(double));
}

void ParticleStore::remove(size_t count, const int32_t *ids) {
  if (count == 0) return;
  if (contiguous_) ids_.grow(slots_);
  dead_.grow(slots_);
  if (removed_ == 0 && slots_ > 0) std::memset(dead_.data(), 0, slots_);
  for (size_t i = 0; i < count; i++) {
    const size_t slot = find(ids[i]);
    if (slot == slots_ || dead_[slot] != 0) {
      for (size_t k = 0; k < i; k++) dead_[find(ids[k])] = 0;
      fail(HG_ERR_NOT_FOUND, "ids[%zu] = %d: no such particle%s", i, static_cast<int>(ids[i]),
           slot == slots_ ? "" : " (removed already, or listed twice)");
    }
    dead_[slot] = 1;
  }
  if (contiguous_) {
    for (size_t slot = 0; slot < slots_; slot++) ids_[slot] = index_base_ + static_cast<int32_t>(slot);
    contiguous_ = false;
  }
  removed_ += count;
}

void ParticleStore::clear() {
  slots_ = 0;
  removed_ = 0;
  contiguous_ = true;
  next_id_ = index_base_;
}

void ParticleStore::compact() noexcept {
  if (removed_ == 0) return;
  size_t to = 0;
  for (size_t from = 0; from < slots_; from++) {
    if (dead_[from] != 0) continue;
    std::memmove(centers_.data() + to * dimension_, centers_.data() + from * dimension_, dimension_ * sizeof(double));
    radii_[to] = radii_[from];
    ids_[to] = ids_[from];
    to++;
  }
  slots_ = to;
  removed_ = 0;
}

size_t ParticleStore::find(int64_t id) const {
  if (contiguous_) {
    return id >= index_base_ && id < index_base_ + static_cast<int64_t>(slots_) ? static_cast<size_t>(id - index_base_)
                                                                                : slots_;
  }
  const int32_t *end = ids_.data() + slots_;
  const int32_t *found = std::lower_bound(ids_.data(), end, id);
  return found != end && *found == id ? static_cast<size_t>(found - ids_.data()) : slots_;
}

void ParticleStore::check(size_t count, const double *centers, const double *radii) const {
  const bool good = all_finite(centers, count * dimension_) &&
                    (radii == nullptr || (all_finite(radii, count) && all_not_negative(radii, count)));
  if (!good) report(count, centers, radii);
  if (domain_.any_periodic) {
    for (size_t i = 0; i < count; i++) check_wraps(i, centers + i * dimension_);
  }
  if (radii == nullptr) return;
  const size_t index = static_cast<size_t>(std::max_element(radii, radii + count) - radii);
  if (!(interaction_.diameter(radii[index]) <= kLargest)) {
    fail(HG_ERR_LIMIT, "radii[%zu] = %g: its diameter with margin overflows", index, radii[index]);
  }
  check_box(index, radii[index]);
  if (interaction_.diameter(radii[index]) > largest_diameter_) {
    fail(HG_ERR_ARGUMENT, "radii[%zu] = %g: its diameter with margin is %g, but the last of cell_sizes is %g", index,
         radii[index], interaction_.diameter(radii[index]), largest_diameter_);
  }
}

void ParticleStore::check_wraps(size_t index, const double *center) const {
  for (int k = 0; k < domain_.dimension; k++) {
    if (domain_.periodic[k] && !(std::fabs(domain_.wraps(k, center[k])) <= kMaxWraps)) {
      fail(HG_ERR_LIMIT, "centers[%zu][%d] = %g: more than 2^20 box lengths outside the periodic box [%g, %g]", index,
           k, center[k], domain_.box_min[k], domain_.box_max[k]);
    }
  }
}

// Nearest images are unique only while every reach is at most half the box.
void ParticleStore::check_box(size_t index, double radius) const {
  if (!domain_.any_periodic) return;
  ExactSum twice_reach;
  twice_reach.add(radius, interaction_.kind == HG_CONTACT ? 4 : 2);
  twice_reach.add(interaction_.margin, 2);
  for (int k = 0; k < domain_.dimension; k++) {
    ExactSum length;
    length.add(domain_.box_max[k], 1);
    length.add(domain_.box_min[k], -1);
    if (domain_.periodic[k] && exact_less(&length, 1, twice_reach)) {
      fail(HG_ERR_ARGUMENT, "radii[%zu] = %g: the periodic box is %g long in %c, shorter than twice the reach %g",
           index, radius, domain_.length[k], "xyz"[k], interaction_.diameter(radius));
    }
  }
}

void ParticleStore::report(size_t count, const double *centers, const double *radii) const {
  for (size_t i = 0; i < count; i++) {
    for (size_t k = 0; k < dimension_; k++) {
      const double value = centers[i * dimension_ + k];
      if (!(std::fabs(value) <= kLargest)) {
        fail(HG_ERR_ARGUMENT, "centers[%zu][%zu] = %g is not finite", i, k, value);
      }
    }
    if (radii != nullptr && !(std::fabs(radii[i]) <= kLargest)) {
      fail(HG_ERR_ARGUMENT, "radii[%zu] = %g is not finite", i, radii[i]);
    }
    if (radii != nullptr && radii[i] < 0) fail(HG_ERR_ARGUMENT, "radii[%zu] = %g is negative", i, radii[i]);
  }
  fail(HG_ERR_INTERNAL, "a bad value was seen but not found again");
}

}  // namespace hg
