// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/particles/particle_store.hpp"

#include "src/base/error.hpp"
#include "src/base/parallel.hpp"
#include "src/base/sign.hpp"
#include "src/exact/exact_sign.hpp"
#include "src/kernels/kernel_sets.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace hg {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr int64_t kMaxId = std::numeric_limits<int32_t>::max();

void include(Extremes &all, const Extremes &more) {
  all.least = std::min(all.least, more.least);
  all.greatest = std::max(all.greatest, more.greatest);
}

void include(Survey &all, const Survey &more) {
  for (int k = 0; k < 3; k++) include(all.axis[k], more.axis[k]);
  include(all.radius, more.radius);
  all.finite = all.finite && more.finite;
}

}  // namespace

ParticleStore::ParticleStore(Memory &memory, const Domain &domain, const Interaction &interaction, int32_t index_base,
                             double largest_diameter, int threads)
    : domain_(domain),
      interaction_(interaction),
      dimension_(static_cast<size_t>(domain.dimension)),
      index_base_(index_base),
      largest_diameter_(largest_diameter),
      threads_(threads),
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
  centers_.grow((slots_ + count) * dimension_);
  radii_.grow(slots_ + count);
  if (!contiguous_) ids_.grow(slots_ + count);
  if (removed_ > 0) dead_.grow(slots_ + count);

  // Copied beyond what counts, so that nothing has changed if the check fails.
  const SurveyInput input{count, centers, radii, centers_.data() + slots_ * dimension_, radii_.data() + slots_};
  const Survey found = look_at(input);
  check(input, found);
  for (size_t i = 0; !contiguous_ && i < count; i++) {
    ids_[slots_ + i] = static_cast<int32_t>(next_id_ + static_cast<int64_t>(i));
  }
  if (removed_ > 0) std::memset(dead_.data() + slots_, 0, count);
  if (slots_ == 0) survey_ = found;
  include(survey_, found);
  slots_ += count;
  next_id_ += static_cast<int64_t>(count);
}

void ParticleStore::move(size_t count, const double *centers, const double *radii) {
  if (count != live_count()) {
    fail(HG_ERR_ARGUMENT, "count is %zu but the grid holds %zu particles", count, live_count());
  }
  if (count == 0) return;
  const SurveyInput input{count, centers, radii, nullptr, nullptr};
  Survey found = look_at(input);
  check(input, found);
  compact();
  std::memcpy(centers_.data(), centers, count * dimension_ * sizeof(double));
  if (radii != nullptr) std::memcpy(radii_.data(), radii, count * sizeof(double));
  if (radii == nullptr) found.radius = survey_.radius;
  survey_ = found;
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
  if (slots_ > 0) survey_ = look_at({slots_, centers_.data(), radii_.data(), nullptr, nullptr});
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

Survey ParticleStore::look_at(const SurveyInput &input) const {
  const auto kernel = active_kernels().survey[dimension_ - 2];
  const size_t tasks = parts_of(input.count);
  Survey found[kMostParts];
  parallel_for(input.count < kWorthThreads ? 1 : threads_, tasks, [&](size_t task, int) {
    const size_t first = input.count * task / tasks;
    const auto from = [first](auto *array, size_t columns) {
      return array == nullptr ? nullptr : array + first * columns;
    };
    found[task] = kernel({input.count * (task + 1) / tasks - first, from(input.centers, dimension_),
                          from(input.radii, 1), from(input.center_copy, dimension_), from(input.radius_copy, 1)});
  });
  for (size_t task = 1; task < tasks; task++) include(found[0], found[task]);
  return found[0];
}

void ParticleStore::check(const SurveyInput &input, const Survey &found) const {
  // Where a host has subnormals taken for zero, a least radius of 0 may be negative.
  const bool some_negative = input.radii != nullptr && !(found.radius.least > 0) &&
                             std::any_of(input.radii, input.radii + input.count, is_negative);
  if (!found.finite || some_negative) report(input.count, input.centers, input.radii);
  check_wraps(input, found);
  if (input.radii == nullptr) return;
  const double radius = found.radius.greatest;
  const auto index = static_cast<size_t>(std::find(input.radii, input.radii + input.count, radius) - input.radii);
  if (!(interaction_.diameter(radius) <= kLargest)) {
    fail(HG_ERR_LIMIT, "radii[%zu] = %g: its diameter with margin overflows", index, radius);
  }
  check_box(index, radius);
  if (interaction_.diameter(radius) > largest_diameter_) {
    fail(HG_ERR_ARGUMENT, "radii[%zu] = %g: its diameter with margin is %g, but the last of cell_sizes is %g", index,
         radius, interaction_.diameter(radius), largest_diameter_);
  }
}

void ParticleStore::check_wraps(const SurveyInput &input, const Survey &found) const {
  for (int k = 0; k < domain_.dimension; k++) {
    if (!domain_.periodic[k]) continue;
    const auto too_far = [this, k](double x) { return !(std::fabs(domain_.wraps(k, x)) <= kMaxWraps); };
    if (!too_far(found.axis[k].least) && !too_far(found.axis[k].greatest)) continue;
    for (size_t i = 0; i < input.count; i++) {
      const double x = input.centers[i * dimension_ + static_cast<size_t>(k)];
      if (!too_far(x)) continue;
      fail(HG_ERR_LIMIT, "centers[%zu][%d] = %g: more than 2^20 box lengths outside the periodic box [%g, %g]", i, k, x,
           domain_.box_min[k], domain_.box_max[k]);
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
    if (radii != nullptr && is_negative(radii[i])) fail(HG_ERR_ARGUMENT, "radii[%zu] = %g is negative", i, radii[i]);
  }
  fail(HG_ERR_INTERNAL, "a bad value was seen but not found again");
}

}  // namespace hg
