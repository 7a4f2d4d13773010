// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/build_index.hpp"

#include "src/base/parallel.hpp"
#include "src/base/reductions.hpp"
#include "src/index/build_chunks.hpp"
#include "src/index/images.hpp"
#include "src/index/particle_input.hpp"
#include "src/kernels/kernel_set.hpp"
#include "src/levels/companions.hpp"
#include "src/space/level_cells.hpp"

#include <algorithm>
#include <cstring>

namespace hg {
namespace {

constexpr size_t kChunk = 4096;      // radii looked at level by level while they are in cache
constexpr size_t kLeastPart = 8192;  // particles that are worth a thread
constexpr size_t kRowTasks = 64;     // pieces into which the rows of a level are cut

template <int D>
class Builder {
 public:
  Builder(Index &index, BuildScratch &scratch, const Participants &particles, int threads)
      : index_(index),
        scratch_(scratch),
        particles_(particles),
        count_(particles.count()),
        threads_(count_ < kWorthThreads ? 1 : threads),
        parts_(std::min(static_cast<size_t>(threads_), count_ / kLeastPart + 1)) {}

  void run() {
    populate_levels();
    if (!lay_levels()) {
      build_chunks(index_, scratch_.chunks, particles_, threads_);
      return;
    }
    scatter_into_rows();
    for (int h = 0; h < index_.level_count; h++) sort_level(h);
  }

 private:
  IndexLevel &level(int h) { return index_.levels[h]; }

  void populate_levels() {
    LevelPopulation &population = scratch_.population;
    if (!is_counted(population)) count(population);
    uint32_t begin = 0;
    for (int h = 0; h < index_.level_count; h++) {
      const LevelPopulation::Level &taken = population.levels[static_cast<size_t>(h)];
      level(h).begin = begin;
      level(h).end = begin += taken.count;
      level(h).largest_radius = level(h).is_empty() ? 0 : taken.largest_radius;
    }
  }

  double radius_limit(int insertion_level) const {
    return index_.levels[index_.level_number(insertion_level, 0)].plan.radius_limit;
  }

  bool is_counted(const LevelPopulation &population) const {
    bool same = population.counted && population.level_count == index_.level_count;
    for (int h = 0; same && h < index_.insertion_levels; h++) same = population.radius_limit[h] == radius_limit(h);
    return same;
  }

  // How many particles each level takes (Eq. 3: the finest whose cells are at least as wide), and the largest of them.
  void count(LevelPopulation &population) const {
    population.counted = false;  // also if there is no memory
    population.level_count = index_.level_count;
    population.levels.require(static_cast<size_t>(index_.level_count));
    for (int h = 0; h < index_.insertion_levels; h++) population.radius_limit[h] = radius_limit(h);
    particles_.ranges().each(0, count_,
                             [&](int c, size_t begin, size_t end) { count_class(c, begin, end, population); });
    population.counted = true;
  }

  void count_class(int c, size_t begin, size_t end, LevelPopulation &population) const {
    Within up_to[HG_MAX_LEVELS] = {};
    for (size_t first = begin; first < end; first += kChunk) {
      const size_t chunk = std::min(kChunk, end - first);
      for (int h = 0; h < index_.insertion_levels; h++) {
        const Within here = within(particles_.radii() + first, chunk, population.radius_limit[h], 0.0);
        up_to[h].count += here.count;
        up_to[h].greatest = std::max(up_to[h].greatest, here.greatest);
      }
    }
    size_t finer = 0;
    for (int h = 0; h < index_.insertion_levels; h++) {
      population.levels[static_cast<size_t>(index_.level_number(h, c))] = {
          static_cast<uint32_t>(up_to[h].count - finer), up_to[h].greatest};
      finer = up_to[h].count;
    }
  }

  // False if space is filled so unevenly that tables of cells do not suit.
  bool lay_levels() {
    size_t rows = 0, cells = 0;
    scratch_.tables.require(static_cast<size_t>(index_.level_count));
    for (int h = 0; h < index_.level_count; h++) {
      IndexLevel &l = level(h);
      tables(h) = {rows, cells};
      if (l.is_empty()) continue;
      const LevelCells laid = lay_cells(index_.map, D, l.plan.cell_size * index_.map.scale, l.end - l.begin);
      l.cells = laid.table;
      l.cells.largest_radius =
          static_cast<float>(index_.interaction.folded_radius(l.largest_radius) * index_.map.scale);
      const RadiusRange radii{l.insertion_level == 0 ? -1.0 : radius_limit(l.insertion_level - 1), l.plan.radius_limit};
      if (laid.widened && count_ <= ChunkRows::kMostParticles && index_.largest_reach() > 0 &&
          estimate_companions(particles_.of_class(l.group_class), index_.map, D, l.cells, radii, l.end - l.begin,
                              kMostCompanions) > kMostCompanions) {
        return false;
      }
      rows += laid.rows;
      cells += laid.cells + 1;
    }
    rows_ = rows;
    index_.row_count = static_cast<int64_t>(rows);
    index_.cell_count = static_cast<int64_t>(cells);
    index_.cell_begin.require_room(cells + kCellPadding);
    for (int h = 0; h < index_.level_count; h++)
      level(h).cells.cell_begin = index_.cell_begin.data() + tables(h).first_cell;
    return true;
  }

  BuildScratch::Tables &tables(int h) { return scratch_.tables[static_cast<size_t>(h)]; }

  // Of each class its levels stand together, as the kernels want them.
  LevelRows *levels_of(int c) {
    return scratch_.level_rows.data() + static_cast<ptrdiff_t>(c) * index_.insertion_levels;
  }

  void list_level_rows() {
    scratch_.level_rows.require(static_cast<size_t>(index_.level_count));
    for (int h = 0; h < index_.level_count; h++) {
      const IndexLevel &l = level(h);
      LevelRows &rows = levels_of(l.group_class)[l.insertion_level];
      rows = {l.plan.radius_limit, 0, 0.5f, 0, 0.5f, 1, static_cast<uint32_t>(tables(h).first_row)};
      if (l.is_empty()) continue;
      rows.inverse_y = l.cells.inverse_width[1];
      rows.last_y = last_of(l.cells, 1);
      rows.inverse_z = l.cells.inverse_width[2];
      rows.last_z = last_of(l.cells, 2);
      rows.count_y = static_cast<uint32_t>(l.cells.count[1]);
    }
  }

  // Calls run(input, begin, end) for all particles of a part, class by class.
  template <class Run>
  void each_class(size_t part, Run &&run) {
    particles_.ranges().each(part_begin(part), part_begin(part + 1), [&](int c, size_t begin, size_t end) {
      run(BuildInput{particle_input(particles_, index_), index_.insertion_levels, levels_of(c)}, begin, end);
    });
  }

  size_t part_begin(size_t part) const { return count_ * part / parts_; }

  // Counting sort by (level, row), stable. Each part of the particles counts for itself.
  void scatter_into_rows() {
    const size_t stride = rows_ + 1;
    scratch_.row_of.require(count_);
    scratch_.particles.require(count_);
    scratch_.row_begin.require_room(stride * parts_);
    list_level_rows();
    const BuildKernel &kernel = active_kernels().build[D - 2];
    uint32_t *begin = scratch_.row_begin.data();
    parallel_for(threads_, parts_, [&](size_t part, int) {
      std::fill(begin + part * stride, begin + (part + 1) * stride, 0u);
      each_class(part, [&](const BuildInput &input, size_t first, size_t last) {
        kernel.find_rows(input, first, last, {scratch_.row_of.data(), begin + part * stride});
      });
    });
    uint32_t sum = 0;
    for (size_t row = 0; row <= rows_; row++) {
      const uint32_t row_starts = sum;
      for (size_t part = 0; part < parts_; part++) {
        const uint32_t here = begin[part * stride + row];
        begin[part * stride + row] = sum;
        sum += here;
      }
      longest_row_ = std::max<size_t>(longest_row_, sum - row_starts);
    }
    scratch_.row.require(longest_row_ * static_cast<size_t>(threads_));
    parallel_for(threads_, parts_, [&](size_t part, int) {
      each_class(part, [&](const BuildInput &input, size_t first, size_t last) {
        kernel.put_into_rows(input, first, last,
                             {scratch_.row_of.data(), begin + part * stride, scratch_.particles.data()});
      });
    });
    // The last part's begins have moved to where the next row begins.
    std::memmove(begin + 1, begin + (parts_ - 1) * stride, rows_ * sizeof *begin);
    begin[0] = 0;
  }

  void sort_level(int h) {
    IndexLevel &l = level(h);
    if (l.is_empty()) return;
    const size_t rows = static_cast<size_t>(l.cells.count[1]) * static_cast<size_t>(l.cells.count[2]);
    uint32_t *cells = index_.cell_begin.data() + tables(h).first_cell;
    const uint32_t *row_begin = scratch_.row_begin.data() + tables(h).first_row;
    const RowSort sort{scratch_.particles.data(), row_begin, l.cells.count[0],          l.cells.inverse_width[0],
                       last_of(l.cells, 0),       cells,     index_.particles.columns()};
    const BuildKernel &kernel = active_kernels().build[D - 2];
    parallel_for(threads_, kRowTasks, [&](size_t task, int worker) {
      uint32_t *room = scratch_.row.data() + static_cast<size_t>(worker) * longest_row_;
      kernel.sort_rows(sort, rows * task / kRowTasks, rows * (task + 1) / kRowTasks, room);
    });
    cells[rows * static_cast<size_t>(l.cells.count[0])] = l.end;
  }

  Index &index_;
  BuildScratch &scratch_;
  const Participants &particles_;
  size_t count_;
  int threads_;
  size_t parts_;  // into which the particles are cut to count and to scatter them
  size_t rows_ = 0;
  size_t longest_row_ = 0;
};

void give_bodies(Index &index, const int32_t *bodies, int threads) {
  PointStore &points = index.particles;
  points.with_bodies = index.images.with_bodies = bodies != nullptr;
  if (bodies == nullptr) return;
  const size_t count = index.particle_count;
  points.body.require(count + kPadding);
  std::fill_n(points.body.data() + count, kPadding, 0);
  const uint32_t *slot = points.slot.data();
  int32_t *body = points.body.data();
  each_part(threads, count, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; i++) body[i] = bodies[slot[i]];
  });
}

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

void build_index(Index &index, BuildScratch &scratch, const Participants &particles, const LevelPlan &plan,
                 int threads) {
  const size_t count = particles.count();
  index.particles.require(count, index.domain.dimension);
  index.largest_radius = count > 0 ? particles.summary().radius.greatest : 0;
  index.particle_count = count;
  index.lay_levels(plan, particles.classes());
  index.row_count = index.cell_count = 0;
  index.chunked = false;
  index.squeezed.release();
  if (count == 0) return;
  if (index.domain.dimension == 2) {
    Builder<2>(index, scratch, particles, threads).run();
  } else {
    Builder<3>(index, scratch, particles, threads).run();
  }
  give_bodies(index, particles.bodies(), threads);
  build_images(index);
}

}  // namespace hg
