// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "index.hpp"

#include "images.hpp"
#include "level_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hg {
namespace {

constexpr size_t kSample = 4096;      // particles looked at to judge how evenly a level fills space
constexpr double kMaxCrowding = 8.0;  // others in a particle's own cell beyond which a widened table does not pay

template <int D>
class Builder {
 public:
  Builder(Index &index, BuildScratch &scratch, const ParticleStore &store)
      : index_(index), scratch_(scratch), store_(store), count_(store.slots()) {}

  void run() {
    assign_levels();
    lay_levels();
    scatter_into_rows();
    for (int h = 0; h < index_.level_count; h++) sort_level(h);
  }

 private:
  IndexLevel &level(int h) { return index_.levels[h]; }

  // The level of insertion, Eq. 3: the finest whose cells are at least as wide as the particle.
  void assign_levels() {
    scratch_.level_of.require(count_);
    uint32_t counts[HG_MAX_LEVELS] = {};
    for (size_t slot = 0; slot < count_; slot++) {
      const double radius = store_.radius(slot);
      int h = 0;
      for (int k = 0; k + 1 < index_.level_count; k++) h += radius > level(k).plan.radius_limit;
      scratch_.level_of[slot] = static_cast<uint8_t>(h);
      level(h).largest_radius = std::max(level(h).largest_radius, radius);
      counts[h]++;
    }
    uint32_t begin = 0;
    for (int h = 0; h < index_.level_count; h++) {
      level(h).begin = begin;
      level(h).end = begin += counts[h];
    }
  }

  void lay_levels() {
    size_t rows = 0, cells = 0;
    for (int h = 0; h < index_.level_count; h++) {
      IndexLevel &l = level(h);
      row_base_[h] = rows;
      cell_base_[h] = cells;
      if (l.begin == l.end) continue;
      // A user's cells may be wider than the particles need; the paper's are not.
      const double quanta = l.plan.cell_size * index_.frame.scale;
      const LevelCells laid = lay_cells(index_.frame, D, quanta, l.end - l.begin);
      l.cells = laid.table;
      l.cells.largest_radius = folded(l.largest_radius);
      l.sparse = laid.widened && crowded(h);
      rows += l.sparse ? 1 : laid.rows;
      cells += l.sparse ? 0 : laid.cells + 1;
      index_.row_count += l.sparse ? 0 : static_cast<int64_t>(laid.rows);
      index_.cell_count += l.sparse ? 0 : static_cast<int64_t>(laid.cells);
    }
    rows_ = rows;
    index_.cell_begin.require(cells);
    for (int h = 0; h < index_.level_count; h++) level(h).cells.cell_begin = index_.cell_begin.data() + cell_base_[h];
  }

  // How many others share a particle's cell, estimated from a sample.
  bool crowded(int h) {
    const size_t particles = level(h).end - level(h).begin;
    const size_t stride = (particles + kSample - 1) / kSample;
    scratch_.sample.require(kSample);
    size_t seen = 0, sampled = 0;
    for (size_t slot = 0; slot < count_; slot++) {
      if (scratch_.level_of[slot] != h || seen++ % stride != 0) continue;
      uint64_t cell = 0;
      for (int k = 0; k < D; k++) cell = cell << 21 | static_cast<uint64_t>(cell_of(level(h), k, fixed(slot, k)));
      scratch_.sample[sampled++] = cell;
    }
    if (sampled < 2) return false;
    std::sort(scratch_.sample.data(), scratch_.sample.data() + sampled);
    double together = 0;
    for (size_t first = 0, i = 1; i <= sampled; i++) {
      if (i < sampled && scratch_.sample[i] == scratch_.sample[first]) continue;
      together += 0.5 * static_cast<double>(i - first) * static_cast<double>(i - first - 1);
      first = i;
    }
    const double all_pairs = 0.5 * static_cast<double>(sampled) * static_cast<double>(sampled - 1);
    return static_cast<double>(particles) * together / all_pairs > kMaxCrowding;
  }

  int32_t fixed(size_t slot, int axis) const {
    return index_.frame.coordinate(axis, index_.domain.wrapped(axis, store_.center(slot)[axis]));
  }
  float folded(double radius) const {
    return static_cast<float>(index_.interaction.folded_radius(radius) * index_.frame.scale);
  }
  // The same map as in the kernels.
  static int32_t cell_of(const IndexLevel &l, int axis, int32_t x) {
    const float last = static_cast<float>(l.cells.count[axis]) - 0.5f;
    return static_cast<int32_t>(std::min(std::max(static_cast<float>(x) * l.cells.inverse_width[axis], 0.0f), last));
  }

  size_t row_of(int h, const int32_t *x) {
    const IndexLevel &l = level(h);
    if (l.sparse) return row_base_[h];
    size_t row = static_cast<size_t>(cell_of(l, 1, x[1]));
    if (D == 3) row += static_cast<size_t>(cell_of(l, 2, x[2])) * static_cast<size_t>(l.cells.count[1]);
    return row_base_[h] + row;
  }

  // Counting sort by (level, row).
  void scatter_into_rows() {
    scratch_.row_of.require(count_);
    scratch_.row_begin.require(rows_ + 1);
    scratch_.records.require(count_);
    uint32_t *begin = scratch_.row_begin.data();
    std::fill(begin, begin + rows_ + 1, 0u);
    for (size_t slot = 0; slot < count_; slot++) {
      int32_t x[3] = {0, 0, 0};
      for (int k = 1; k < D; k++) x[k] = fixed(slot, k);
      const size_t row = row_of(scratch_.level_of[slot], x);
      scratch_.row_of[slot] = static_cast<uint32_t>(row);
      begin[row]++;
    }
    uint32_t sum = 0;
    for (size_t row = 0; row <= rows_; row++) {
      const uint32_t here = begin[row];
      begin[row] = sum;
      sum += here;
    }
    for (size_t slot = 0; slot < count_; slot++) {
      BuildScratch::Record &record = scratch_.records[begin[scratch_.row_of[slot]]++];
      record.x = fixed(slot, 0);
      record.y = fixed(slot, 1);
      record.z = D == 3 ? fixed(slot, 2) : 0;
      record.radius = folded(store_.radius(slot));
      record.slot = static_cast<uint32_t>(slot);
    }
    // Each begin has moved to where the next row begins.
    std::memmove(begin + 1, begin, rows_ * sizeof *begin);
    begin[0] = 0;
  }

  void sort_level(int h) {
    IndexLevel &l = level(h);
    if (l.begin == l.end) return;
    if (l.sparse) {
      sort_sparse(l);
      return;
    }
    const size_t rows = static_cast<size_t>(l.cells.count[1]) * static_cast<size_t>(l.cells.count[2]);
    uint32_t *cells = index_.cell_begin.data() + cell_base_[h];
    for (size_t row = 0; row < rows; row++) {
      sort_row(l, scratch_.row_begin[row_base_[h] + row], scratch_.row_begin[row_base_[h] + row + 1], cells);
      cells += l.cells.count[0];
    }
    *cells = l.end;
  }

  // Counting sort of one row by cell; fills the row's part of the table.
  void sort_row(const IndexLevel &l, uint32_t begin, uint32_t end, uint32_t *cells) {
    const int32_t cell_count = l.cells.count[0];
    std::fill(cells, cells + cell_count, 0u);
    scratch_.bucket.require(end - begin);
    for (uint32_t i = begin; i < end; i++) {
      const auto cell = static_cast<uint32_t>(cell_of(l, 0, scratch_.records[i].x));
      scratch_.bucket[i - begin] = cell;
      cells[cell]++;
    }
    uint32_t sum = begin;
    for (int32_t c = 0; c < cell_count; c++) cells[c] = sum += cells[c];
    for (uint32_t i = end; i-- > begin;) place(--cells[scratch_.bucket[i - begin]], scratch_.records[i]);
  }

  void place(uint32_t at, const BuildScratch::Record &record) {
    index_.particles.x[at] = record.x;
    index_.particles.y[at] = record.y;
    if (D == 3) index_.particles.z[at] = record.z;
    index_.particles.radius[at] = record.radius;
    index_.particles.slot[at] = record.slot;
  }

  void sort_sparse(IndexLevel &l) {
    const uint32_t count = l.end - l.begin;
    double origin[3] = {0, 0, 0};
    for (int k = 0; k < D; k++) origin[k] = index_.frame.origin[k] / index_.frame.scale;
    uint32_t *slots = index_.particles.slot.data() + l.begin;
    for (uint32_t i = 0; i < count; i++) slots[i] = scratch_.records[l.begin + i].slot;
    // Any width will do for correctness; a level of points alone (s_h = 0) still needs one.
    const double width = std::max(l.plan.cell_size, 1.0 / index_.frame.scale);
    l.rows = index_.sparse.add_level(store_, index_.domain, origin, width, slots, l.begin, count);
    for (uint32_t i = l.begin; i < l.end; i++) {
      const size_t slot = index_.particles.slot[i];
      place(i, {fixed(slot, 0), fixed(slot, 1), D == 3 ? fixed(slot, 2) : 0, folded(store_.radius(slot)),
                static_cast<uint32_t>(slot)});
    }
  }

  Index &index_;
  BuildScratch &scratch_;
  const ParticleStore &store_;
  size_t count_;
  size_t rows_ = 0;
  size_t row_base_[HG_MAX_LEVELS] = {};
  size_t cell_base_[HG_MAX_LEVELS] = {};
};

}  // namespace

void PointStore::require(size_t count, int dimension) {
  const auto prepare = [count](auto &buffer) {
    buffer.require(count + kPadding);
    std::fill(buffer.data() + count, buffer.data() + count + kPadding, 0);
  };
  prepare(x);
  prepare(y);
  if (dimension == 3) prepare(z);
  prepare(radius);
  prepare(slot);
}

Bounds bounds_of(const ParticleStore &store, const Domain &domain) {
  Bounds bounds;
  if (store.slots() == 0) return bounds;
  const size_t count = store.slots();
  const double *radii = store.radii();
  for (int k = 0; k < domain.dimension; k++) {
    const double *x = store.centers() + k;
    double low = x[0], high = x[0], left = x[0] - radii[0], right = x[0] + radii[0];
    for (size_t i = 0; i < count; i++) {
      const double value = x[i * static_cast<size_t>(domain.dimension)];
      low = value < low ? value : low;
      high = value > high ? value : high;
      left = value - radii[i] < left ? value - radii[i] : left;
      right = value + radii[i] > right ? value + radii[i] : right;
    }
    bounds.min[k] = domain.periodic[k] ? domain.box_min[k] : low;
    bounds.max[k] = domain.periodic[k] ? domain.box_max[k] : high;
    bounds.width[k] = domain.length[k] > 0 ? domain.length[k] : right - left;
  }
  bounds.max_radius = *std::max_element(radii, radii + count);
  return bounds;
}

void build_index(Index &index, BuildScratch &scratch, const ParticleStore &store, const Bounds &bounds,
                 const LevelPlan &plan) {
  const size_t count = store.slots();
  index.particles.require(count, index.domain.dimension);
  index.frame = Frame::over(bounds, index.domain, index.interaction.diameter(bounds.max_radius));
  index.level_count = plan.level_count;
  index.row_count = index.cell_count = 0;
  index.sparse.clear();
  for (int h = 0; h < plan.level_count; h++) {
    index.levels[h] = IndexLevel{};
    index.levels[h].plan = plan.levels[h];
  }
  if (count == 0) return;
  if (index.domain.dimension == 2) {
    Builder<2>(index, scratch, store).run();
  } else {
    Builder<3>(index, scratch, store).run();
  }
  index.row_count += static_cast<int64_t>(index.sparse.rows());
  build_images(index);
}

}  // namespace hg
