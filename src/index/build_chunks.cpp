// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/build_chunks.hpp"

#include "src/base/parallel.hpp"
#include "src/index/particle_input.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/particles/bounds.hpp"

#include <algorithm>
#include <cmath>

namespace hg {
namespace {

// What the scale must leave of the finest level, in quanta. Levels that are too large for it then become giants.
constexpr double kFineDiameter = 0x1p12;
// What extents must leave of the largest diameter, in quanta; else axes are squeezed, to gaps of so many diameters.
constexpr double kWorthSqueezing = 0x1p20;
constexpr double kGap = 4;

// Of all particles, if the level is empty.
double largest_in_any_class(const Index &index, int insertion_level) {
  double largest = 0;
  bool any = false;
  for (int c = 0; c < index.classes.count; c++) {
    const IndexLevel &level = index.levels[index.level_number(insertion_level, c)];
    largest = std::max(largest, level.largest_radius);
    any = any || !level.is_empty();
  }
  return any ? largest : index.largest_radius;
}

ChunkRows::Sizes sizes_of(const Index &index, const ClassRanges &classes, Buffer<double> &diameters) {
  diameters.require(static_cast<size_t>(index.level_count));
  ChunkRows::Sizes sizes;
  sizes.insertion_levels = index.insertion_levels;
  sizes.diameter = diameters.data();
  sizes.classes = classes;
  for (int h = 0; h < index.level_count; h++) {
    const IndexLevel &level = index.levels[h];
    diameters[static_cast<size_t>(h)] = index.interaction.diameter(
        level.is_empty() ? largest_in_any_class(index, level.insertion_level) : level.largest_radius);
    sizes.radius_limit[level.insertion_level] = level.plan.radius_limit;
  }
  return sizes;
}

// The largest diameter that is no giant.
double largest_on_scale(const Index &index, const ChunkRows::Sizes &sizes) {
  for (int h = 0; h < index.level_count; h++) {
    if (index.levels[h].is_empty() || !(sizes.diameter[h] > 0)) continue;
    return std::min(index.largest_reach(), sizes.diameter[h] * (ChunkRows::kGiantDiameter / kFineDiameter));
  }
  return index.largest_reach();
}

// How many boxes the centres lie outside the periodic box at most. In a tilted cell more is rounded, nearly twice as
// much.
double most_wraps(const Participants &particles, const Domain &domain) {
  double most = 0;
  for (size_t slot = 0; domain.is_tilted() && slot < particles.count(); slot++) {
    most = std::max(most, 2 * domain.outside(particles.center(slot)).boxes);
  }
  if (domain.is_tilted()) return most;
  for (int axis = 0; axis < domain.dimension; axis++) {
    const Interval &x = particles.summary().center[axis];
    most = std::max({most, std::fabs(domain.wraps(axis, x.least)), std::fabs(domain.wraps(axis, x.greatest))});
  }
  return most;
}

bool all_periodic(const Domain &domain) {
  return std::all_of(domain.periodic, domain.periodic + domain.dimension, [](bool periodic) { return periodic; });
}

// Sets the map of places that wrap, and squeezes axes where extents are too wide for it.
void set_map(Index &index, const ChunkRows::Sizes &sizes, const Participants &particles) {
  const Domain &domain = index.domain;
  const double largest = largest_on_scale(index, sizes), gap = kGap * index.largest_reach();
  const double wraps = most_wraps(particles, domain);
  index.map = FixedPoint::wrapping(spread_of(particles, domain), domain, largest, wraps);
  const bool fine = largest * index.map.scale >= kWorthSqueezing;
  if (fine || all_periodic(domain) || gap > SqueezedAxes::kLongestGap) return;
  index.map = FixedPoint::wrapping(index.squeezed.squeeze(particles, domain, gap), domain, largest, wraps);
}

// From places among the participants to the slots that they have in their store.
void name_slots(Buffer<uint32_t> &slot, const Participants &particles, int threads) {
  const uint32_t *slots = particles.slots();
  if (slots == nullptr) return;
  each_part(threads, particles.count(), [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; i++) slot[i] = slots[slot[i]];
  });
}

}  // namespace

void build_chunks(Index &index, ChunkScratch &scratch, const Participants &particles, int threads) {
  const size_t count = particles.count();
  const int dimension = index.domain.dimension;
  const ChunkRows::Sizes sizes = sizes_of(index, particles.ranges(), scratch.diameters);
  index.chunked = true;
  set_map(index, sizes, particles);
  for (int h = 0; h < index.level_count; h++) {
    const double folded = index.interaction.folded_radius(index.levels[h].largest_radius) * index.map.scale;
    index.levels[h].cells.largest_radius = static_cast<float>(std::min(folded, kBeyondAnyExtent));
  }

  ChunkInput input{particle_input(particles, index), 0, nullptr, 0};
  if (index.squeezed.in_use()) input.centers = index.squeezed.centers();
  PointStore &points = index.particles;
  index.chunks.build(input, sizes, dimension, points.slot.data(), scratch, threads);
  const PointColumns output = points.columns();
  const ChunkBuildKernel &kernel = active_kernels().chunk_build[dimension - 2];
  each_part(threads, count,
            [&](size_t begin, size_t end) { kernel.put(scratch.points.data(), output.slot, begin, end, output); });

  auto giants = static_cast<uint32_t>(count);
  for (int h = index.level_count - 1; h >= 0 && index.chunks.level(h).giants; h--) giants = index.levels[h].begin;
  index.chunks.place_giants(input, points.slot.data(), giants, count, dimension);
  name_slots(points.slot, particles, threads);
  index.row_count = static_cast<int64_t>(index.chunks.rows());
  index.cell_count = static_cast<int64_t>(index.chunks.cells());
}

}  // namespace hg
