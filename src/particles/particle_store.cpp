// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/particles/particle_store.hpp"

#include "src/base/error.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

namespace hg {
namespace {

constexpr double kCubeDiagonal = 1.7320508075688776;  // of edge 1, rounded up
constexpr int64_t kMaxId = std::numeric_limits<int32_t>::max();

}  // namespace

ParticleStore::ParticleStore(Memory &memory, const InputCheck &check, const ShortCell &cell, int dimension,
                             int32_t index_base)
    : check_(check),
      cell_(cell),
      dimension_(static_cast<size_t>(dimension)),
      index_base_(index_base),
      next_id_(index_base),
      centers_(memory),
      radii_(memory),
      ids_(memory),
      dead_(memory),
      given_groups_(memory),
      groups_(memory, 0),
      bodies_(memory, kNoBody) {}

void ParticleStore::check_ids(int64_t first, size_t count) const {
  if (static_cast<uint64_t>(count) > static_cast<uint64_t>(kMaxId - first) + 1) {
    fail(HG_ERR_LIMIT, "%zu particles more: ids would pass %lld", count, static_cast<long long>(kMaxId));
  }
}

void ParticleStore::insert(size_t count, const double *centers, const double *radii) {
  if (count == 0) return;
  check_insert(count);
  centers_.grow((slots_ + count) * dimension_);
  radii_.grow(slots_ + count);
  if (!contiguous_) ids_.grow(slots_ + count);
  if (removed_ > 0) dead_.grow(slots_ + count);
  groups_.grow(slots_, count);
  bodies_.grow(slots_, count);

  // Copied beyond what counts, so that nothing has changed if the check fails.
  InputSummary all =
      check_.check({count, centers, radii, centers_.data() + slots_ * dimension_, radii_.data() + slots_});
  if (slots_ > 0) include(all, summary_);
  check_cell(cell_, radii_.data(), slots_ + count, all.radius.greatest);
  for (size_t i = 0; !contiguous_ && i < count; i++) {
    ids_[slots_ + i] = static_cast<int32_t>(next_id_ + static_cast<int64_t>(i));
  }
  if (removed_ > 0) std::memset(dead_.data() + slots_, 0, count);
  summary_ = all;
  slots_ += count;
  next_id_ += static_cast<int64_t>(count);
}

void ParticleStore::check_count(size_t count) const {
  if (count != live_count()) {
    fail(HG_ERR_ARGUMENT, "count is %zu but the grid holds %zu particles", count, live_count());
  }
}

void ParticleStore::move(size_t count, const double *centers, const double *radii, double *distance) {
  check_count(count);
  if (count == 0) return;
  compact();
  InputSummary found = check_.check({count, centers, radii, nullptr, nullptr});
  if (radii != nullptr) check_cell(cell_, radii, count, found.radius.greatest);
  if (distance == nullptr) {
    std::memcpy(centers_.data(), centers, count * dimension_ * sizeof(double));
  } else {
    *distance = kCubeDiagonal * active_kernels().move[dimension_ - 2](centers, count, centers_.data());
  }
  if (radii != nullptr) std::memcpy(radii_.data(), radii, count * sizeof(double));
  if (radii == nullptr) found.radius = summary_.radius;
  summary_ = found;
}

void ParticleStore::set(size_t count, const double *centers, const double *radii) {
  check_set(count);
  InputSummary found{};
  if (count > 0) {
    found = check_.check({count, centers, radii, nullptr, nullptr});
    cell_.check(
        radii, count, found.radius.greatest, [](size_t) { return true; },
        [this](size_t row) { return index_base_ + static_cast<int32_t>(row); });
  }
  centers_.grow(count * dimension_);
  radii_.grow(count);
  compact();
  if (count != slots_) {
    groups_.forget();
    bodies_.forget();
  }
  if (count > 0) {
    std::memcpy(centers_.data(), centers, count * dimension_ * sizeof(double));
    std::memcpy(radii_.data(), radii, count * sizeof(double));
  }
  summary_ = found;
  slots_ = count;
  removed_ = 0;
  contiguous_ = true;
  next_id_ = index_base_ + static_cast<int64_t>(count);
}

void ParticleStore::remove(size_t count, const int32_t *ids) {
  if (count == 0) return;
  if (contiguous_) ids_.grow(slots_);
  dead_.grow(slots_);
  if (removed_ == 0 && slots_ > 0) std::memset(dead_.data(), 0, slots_);
  for (size_t i = 0; i < count; i++) {
    const size_t slot = find(ids[i]);
    if (slot == slots_ || dead_[slot] != 0) {
      for (size_t before = 0; before < i; before++) dead_[find(ids[before])] = 0;
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

void ParticleStore::set_cell(const Domain &domain, const ShortCell &cell) {
  compact();
  InputCheck check = check_;
  check.set_domain(domain);
  if (slots_ > 0) {
    check.check_wraps({slots_, centers_.data(), radii_.data(), nullptr, nullptr}, summary_);
    check_cell(cell, radii_.data(), slots_, summary_.radius.greatest);
  }
  check_ = check;
  cell_ = cell;
}

// Of particles by slot, removed ones left out; those behind all slots are about to be inserted.
void ParticleStore::check_cell(const ShortCell &cell, const double *radii, size_t count, double greatest) const {
  const auto is_alive = [this](size_t slot) { return removed_ == 0 || slot >= slots_ || dead_[slot] == 0; };
  cell.check(radii, count, greatest, is_alive, [this](size_t slot) { return id_of(slot); });
}

int32_t ParticleStore::id_of(size_t slot) const {
  return slot < slots_ ? id(slot) : static_cast<int32_t>(next_id_ + static_cast<int64_t>(slot - slots_));
}

void ParticleStore::clear() {
  slots_ = 0;
  removed_ = 0;
  contiguous_ = true;
  next_id_ = index_base_;
  groups_.forget();
  bodies_.forget();
}

bool ParticleStore::set_groups(size_t count, const int32_t *groups) {
  compact();
  if (groups == nullptr) {
    const bool told = groups_.data() != nullptr;
    groups_.forget();
    return told;
  }
  check_count(count);
  given_groups_.grow(count);
  for (size_t slot = 0; slot < count; slot++) {
    if (groups[slot] < kAbsent || groups[slot] >= HG_MAX_GROUPS) {
      fail(HG_ERR_ARGUMENT, "groups[%zu] = %d is neither -1 (absent) nor one of 0 .. %d", slot,
           static_cast<int>(groups[slot]), HG_MAX_GROUPS - 1);
    }
    given_groups_[slot] = static_cast<int8_t>(groups[slot]);
  }
  if (groups_.is(count, given_groups_.data())) return false;
  groups_.give(count, given_groups_.data());
  return true;
}

bool ParticleStore::set_bodies(size_t count, const int32_t *bodies) {
  compact();
  if (bodies == nullptr) {
    const bool told = bodies_.data() != nullptr;
    bodies_.forget();
    return told;
  }
  check_count(count);
  for (size_t slot = 0; slot < count; slot++) {
    if (bodies[slot] >= kNoBody) continue;
    fail(HG_ERR_ARGUMENT, "bodies[%zu] = %d is neither -1 (no body) nor >= 0", slot, static_cast<int>(bodies[slot]));
  }
  if (bodies_.is(count, bodies)) return false;
  bodies_.give(count, bodies);
  return true;
}

void ParticleStore::compact() noexcept {
  if (removed_ == 0) return;
  size_t to = 0;
  for (size_t from = 0; from < slots_; from++) {
    if (dead_[from] != 0) continue;
    std::memmove(centers_.data() + to * dimension_, centers_.data() + from * dimension_, dimension_ * sizeof(double));
    radii_[to] = radii_[from];
    ids_[to] = ids_[from];
    groups_.move(from, to);
    bodies_.move(from, to);
    to++;
  }
  slots_ = to;
  removed_ = 0;
  if (slots_ > 0) summary_ = check_.summarise({slots_, centers_.data(), radii_.data(), nullptr, nullptr});
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

}  // namespace hg
