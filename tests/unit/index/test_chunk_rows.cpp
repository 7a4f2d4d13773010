// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Chunks of rows against plain scans: every particle once, on its level, in its chunk and cell; what chunks know of
// their neighbours; boxes. From spaces of a few cells to such that cells are as wide as numbers of cells allow.
#include "src/index/chunk_rows.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/far_particles.hpp"

#include <array>
#include <map>
#include <vector>

namespace {

using namespace hgtest;
using hg::ChunkLevel;
using hg::ChunkRows;
using hg::ChunkWord;
using hg::kChunkCells;
using hg::PlaceBox;

using Corner = std::array<double, 3>;

// y and z of the neighbouring rows, in the order of the words.
constexpr int kStencil[hg::kStencilRows][2] = {{0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};

class Scene {
 public:
  Scene(uint64_t seed, hg::Memory &memory, int most_levels)
      : rng_(seed), most_levels_(most_levels), chunks_(memory), scratch_(memory) {}

  // Twice, as buffers are used again.
  void check() {
    for (int build = 0; build < 2; build++) {
      const FarShape shape = any_far_shape(rng_, most_levels_);
      FarParticles particles(shape);
      particles.add_groups(rng_, 1 + rng_.below(rng_.chance(0.2) ? 2000 : 300));
      particles_ = &particles;
      particles.sort_into(chunks_, scratch_);
      check_slots();
      read_chunks();
      for (size_t h = 0; h < shape.diameter.size(); h++) {
        check_level(static_cast<int>(h));
        for (int k = 0; k < 10; k++) check_box(static_cast<int>(h));
      }
      for (size_t chunk = 0; chunk < chunks_.chunks(); chunk++) check_chunk(chunk);
      check_giants();
    }
  }

 private:
  const ChunkLevel &level_of(size_t chunk) const { return chunks_.level(level_[chunk]); }
  double length(size_t chunk, int axis) const {
    return axis == 0 ? level_of(chunk).chunk_length() : level_of(chunk).row_width;
  }

  void check_slots() const {
    std::vector<int> seen(particles_->count(), 0);
    for (size_t i = 0; i < seen.size(); i++) {
      require(particles_->slot[i] < seen.size() && seen[particles_->slot[i]]++ == 0, "slot %u is there twice or not",
              particles_->slot[i]);
    }
  }

  // The chunks of all levels, which come one after the other.
  void read_chunks() {
    corner_.clear();
    level_.clear();
    chunk_at_.clear();
    for (int h = 0; h < static_cast<int>(particles_->diameter.size()); h++) {
      const ChunkLevel &level = chunks_.level(h);
      chunks_.visit_box(level, level.space, [&](size_t chunk, const double *at) {
        require(chunk == corner_.size(), "level %d: chunk %zu instead of %zu", h, chunk, corner_.size());
        corner_.push_back({at[0], at[1], at[2]});
        level_.push_back(h);
        require(chunk_at_.insert({{h, corner_.back()}, chunk}).second, "chunk %zu is where another one is", chunk);
        return true;
      });
    }
    require(corner_.size() == chunks_.chunks(), "%zu of %zu chunks", corner_.size(), chunks_.chunks());
    require(chunks_.chunks() <= particles_->count() && chunks_.rows() <= chunks_.chunks(), "chunks without particles");
    require(chunks_.cells() <= (2 * chunks_.chunks() + 3) * kChunkCells, "%zu cells", chunks_.cells());
  }

  // How wide its cells are: as wide as its particles ask for, unless its space is too wide for that.
  void check_level(int h) const {
    const ChunkLevel &level = chunks_.level(h);
    const auto n = static_cast<size_t>(h);
    const double diameter = particles_->levels[n] > 0 ? particles_->diameter[n] : particles_->diameter.back();
    require(level.giants == (diameter >= ChunkRows::kGiantDiameter), "level %d: giants %d", h, level.giants);
    for (const double length : {level.cell, level.row_width}) {
      require(length == std::rint(length) && length == static_cast<double>(static_cast<float>(length)),
              "level %d: %g is no whole float", h, length);
    }
    require(level.slack >= 16 + 0x1p-15 * level.cell, "level %d: a slack of %g for cells of %g", h, level.slack,
            level.cell);
    require(level.cell >= 0.5 * diameter + level.slack * (1 - 0x1p-40), "level %d: cells of %g for diameters of %g", h,
            level.cell, diameter);
    require(level.row_width >= 2 * diameter + 4 * level.slack, "level %d: rows of %g", h, level.row_width);
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0}, longest = 0;
    bool any = false;
    for (size_t i = 0; i < particles_->count(); i++) {
      if (level_of_radius(particles_->radii[particles_->slot[i]]) != h) continue;
      for (int axis = 0; axis < 3; axis++) {
        low[axis] = any ? std::min(low[axis], particles_->place(i, axis)) : particles_->place(i, axis);
        high[axis] = any ? std::max(high[axis], particles_->place(i, axis)) : particles_->place(i, axis);
        longest = std::max(longest, high[axis] - low[axis]);
      }
      any = true;
    }
    const double wide = std::max(diameter + 512, longest * 0x1p-28) * (1 + 0x1p-20) + 1;
    require(level.cell <= wide && level.row_width <= 4 * wide + 2048, "level %d: cells of %g and rows of %g, for %g", h,
            level.cell, level.row_width, wide);
  }

  int level_of_radius(double radius) const {
    int h = 0;
    while (radius > 0.5 * particles_->diameter[static_cast<size_t>(h)]) h++;
    return h;
  }

  void check_chunk(size_t chunk) const {
    const ChunkLevel &level = level_of(chunk);
    double corner[3];
    chunks_.find_corner(level, chunk, corner);
    for (int axis = 0; axis < 3; axis++) {
      require(corner[axis] == corner_[chunk][static_cast<size_t>(axis)], "corner %d of chunk %zu", axis, chunk);
      if (level.giants || axis >= particles_->dimension) continue;
      require(chunks_.origin(axis)[chunk] == hg::low_word(corner[axis]), "origin %d of chunk %zu", axis, chunk);
    }
    const uint32_t begin = chunks_.chunk_begin(chunk), end = chunks_.chunk_end(chunk);
    require(begin < end && end <= particles_->count(), "chunk %zu: [%u, %u)", chunk, begin, end);
    require(begin == (chunk == 0 ? 0 : chunks_.chunk_end(chunk - 1)), "chunk %zu begins at %u", chunk, begin);
    for (uint32_t i = begin; i < end; i++) check_particle(chunk, i);
    if (level.giants) return;
    for (int row = 0; row < hg::kStencilRows; row++) check_word(chunk, row);
  }

  void check_particle(size_t chunk, uint32_t i) const {
    require(chunks_.chunk_of(i) == chunk, "particle %u is in chunk %u instead of %zu", i, chunks_.chunk_of(i), chunk);
    require(level_of_radius(particles_->radii[particles_->slot[i]]) == level_[chunk], "particle %u, level %d", i,
            level_[chunk]);
    double place[3];
    chunks_.find_place(particles_->points(), i, chunk, corner_[chunk].data(), particles_->dimension, place);
    for (int axis = 0; axis < particles_->dimension; axis++) {
      require(place[axis] == particles_->place(i, axis), "axis %d: particle %u is at %g instead of %g", axis, i,
              place[axis], particles_->place(i, axis));
      const double above = place[axis] - corner_[chunk][static_cast<size_t>(axis)];
      require(above >= 0 && above <= length(chunk, axis), "axis %d: particle %u lies %g above its chunk", axis, i,
              above);
    }
    // On a border it may be in either cell.
    const double cells = (place[0] - corner_[chunk][0]) / level_of(chunk).cell;
    const auto cell = std::min(static_cast<int32_t>(cells), kChunkCells - 1);
    const bool on_border = cells == std::floor(cells);
    const uint32_t *begin = cell_begin() + chunks_.chunk_cell(chunk);
    require(i < begin[cell + 1] && (i >= begin[cell] || (on_border && cell > 0 && i >= begin[cell - 1])),
            "particle %u is not in cell %d", i, cell);
    require(i == 0 || chunks_.chunk_of(i - 1) != chunk || particles_->slot[i - 1] < particles_->slot[i] ||
                std::find(begin, begin + kChunkCells, i) != begin + kChunkCells,
            "slots of one cell are out of order");
  }

  const uint32_t *cell_begin() const { return chunks_.table(0, 0).cell_begin; }

  // The neighbours from X - 1 to X + 1 in a row: found by their corners, and what the word tells of them.
  void check_word(size_t chunk, int row) const {
    const int32_t word = chunks_.table(level_[chunk], 0).word[row][chunk];
    const int32_t unit = word / ChunkWord::kFlags, first = word & ChunkWord::kFirst,
                  last = (word & ChunkWord::kLast) / 4;
    int least = 3, most = 0;
    for (int dx = -1; dx <= 1; dx++) {
      if (particles_->dimension == 2 && kStencil[row][1] != 0) continue;
      const Corner at = {corner_[chunk][0] + dx * length(chunk, 0),
                         corner_[chunk][1] + kStencil[row][0] * length(chunk, 1),
                         corner_[chunk][2] + kStencil[row][1] * length(chunk, 2)};
      const auto found = chunk_at_.find({level_[chunk], at});
      const int32_t cell = (unit + dx) * kChunkCells;
      if (found == chunk_at_.end()) {
        const bool inside = first <= dx + 1 && dx + 1 < last;
        require(!inside || cell_begin()[cell] == cell_begin()[cell + kChunkCells],
                "a chunk that is not there has cells");
        continue;
      }
      least = std::min(least, dx + 1);
      most = std::max(most, dx + 2);
      require(chunks_.chunk_cell(found->second) == cell, "chunk %zu, row %d: cell %d instead of %d", chunk, row, cell,
              chunks_.chunk_cell(found->second));
    }
    if (most == 0) {
      require(first == last && unit > 0, "chunk %zu: row %d has nothing, and the word %d", chunk, row, word);
    } else {
      require(first == least && last == most, "chunk %zu, row %d: chunks [%d, %d) instead of [%d, %d)", chunk, row,
              first, last, least, most);
    }
  }

  PlaceBox any_box(int h) {
    PlaceBox box;
    const size_t near = rng_.below(particles_->count());
    const double reach = particles_->diameter[static_cast<size_t>(h)] * std::pow(2, rng_.uniform(-4, 8));
    for (int axis = 0; axis < particles_->dimension; axis++) {
      box.low[axis] = particles_->place(near, axis) - reach * rng_.uniform();
      box.high[axis] = particles_->place(near, axis) + reach * rng_.uniform();
      if (rng_.chance(0.1)) box.low[axis] = rng_.chance(0.5) ? -HUGE_VAL : -1e300;
      if (rng_.chance(0.1)) box.high[axis] = rng_.chance(0.5) ? HUGE_VAL : 1e300;
      if (rng_.chance(0.02)) box.high[axis] = box.low[axis] = rng_.chance(0.5) ? -0x1p50 : 0x1p50;
    }
    return box;
  }

  // All chunks with a particle in the box are visited, in order, and none that does not nearly meet it.
  void check_box(int h) {
    const ChunkLevel &level = chunks_.level(h);
    const PlaceBox box = any_box(h);
    std::vector<bool> visited(chunks_.chunks(), false);
    size_t before = 0, visits = 0;
    const auto visit = [&](size_t chunk, const double *corner) {
      require(chunk < visited.size() && level_[chunk] == h && (visits++ == 0 || chunk > before), "chunk %zu after %zu",
              chunk, before);
      for (int axis = 0; axis < 3; axis++) {
        require(corner[axis] == corner_[chunk][static_cast<size_t>(axis)], "another corner");
        const double low =
            std::clamp(box.low[axis] - hg::kFarSlack - level.slack, level.space.low[axis], level.space.high[axis]);
        const double high =
            std::clamp(box.high[axis] + hg::kFarSlack + level.slack, level.space.low[axis], level.space.high[axis]);
        require(corner[axis] <= high && corner[axis] + length(chunk, axis) >= low, "axis %d: chunk %zu is far away",
                axis, chunk);
      }
      visited[before = chunk] = true;
      return true;
    };
    require(chunks_.visit_box(level, box, visit), "a visit that goes on was stopped");
    for (uint32_t i = 0; i < particles_->count(); i++) {
      bool inside = level_[chunks_.chunk_of(i)] == h;
      for (int axis = 0; axis < particles_->dimension; axis++) {
        const double place = particles_->place(i, axis);
        inside = inside && place >= box.low[axis] && place <= box.high[axis];
      }
      require(!inside || visited[chunks_.chunk_of(i)], "level %d: particle %u is missed", h, i);
    }
    size_t stopped = 0;
    const bool all = chunks_.visit_box(level, box, [&](size_t, const double *) { return ++stopped < 2; });
    require(stopped == std::min<size_t>(visits, 2) && all == (visits < 2), "a stopped visit went on");
  }

  void check_giants() const {
    const uint32_t begin = particles_->giants_begin;
    require(chunks_.has_giants() == (begin < particles_->count()), "giants from %u on", begin);
    for (uint32_t i = begin; i < particles_->count(); i++) {
      for (int axis = 0; axis < particles_->dimension; axis++) {
        require(chunks_.giant_place(axis, i) == particles_->place(i, axis), "giant %u is elsewhere", i);
      }
    }
  }

  Rng rng_;
  int most_levels_;
  ChunkRows chunks_;
  hg::ChunkScratch scratch_;
  const FarParticles *particles_ = nullptr;
  std::vector<Corner> corner_;  // of each chunk
  std::vector<int> level_;      // likewise
  std::map<std::pair<int, Corner>, size_t> chunk_at_;
};

void check_scene(uint64_t seed, int most_levels) {
  hg::Memory memory(hg::system_allocator());
  Scene(seed, memory, most_levels).check();
}

void one_level(void **) {
  assert_true(sweep(800, [](uint64_t seed) { check_scene(seed, 1); }));
}
void many_levels(void **) {
  assert_true(sweep(800, [](uint64_t seed) { check_scene(seed, 8); }));
}
void most_levels(void **) {
  assert_true(sweep(200, [](uint64_t seed) { check_scene(seed, HG_MAX_LEVELS); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(one_level), cmocka_unit_test(many_levels),
                              cmocka_unit_test(most_levels)};
  return cmocka_run_group_tests_name("chunk_rows", tests, nullptr, nullptr);
}
