// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/chunk_rows.hpp"

#include "src/base/parallel.hpp"
#include "src/base/radix_sort.hpp"
#include "src/space/level_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hg {
namespace {

constexpr double kMostAlongAxis = 0x1p28;  // rows, layers, chunks of a level, so that numbers fit

// The shortest length >= x that is whole and exact in float.
double whole_float(double x) {
  const double whole = std::ceil(x);
  auto rounded = static_cast<float>(whole);
  if (static_cast<double>(rounded) < whole) rounded = std::nextafter(rounded, std::numeric_limits<float>::infinity());
  return static_cast<double>(rounded);
}

// From the cell of a particle to that of the next one in a row, or in the next row.
constexpr size_t kMostCellsBetween = size_t{3} * kChunkCells;

// On what a search must allow for see docs/theory/exactness.md, section 12.
constexpr double kLeastSlack = 16;
constexpr double kSlackPerCell = 0x1p-15;

// Calls run(input, begin, end) for all particles, on all threads, with the levels of their class.
template <class Run>
void each_class(const ChunkInput &input, const ChunkRows::Sizes &sizes, const ChunkLevelKey *levels, int threads,
                Run &&run) {
  each_part(threads, sizes.classes.end(), [&](size_t first, size_t last) {
    sizes.classes.each(first, last, [&](int c, size_t begin, size_t end) {
      ChunkInput part = input;
      part.levels = levels + static_cast<ptrdiff_t>(c) * sizes.insertion_levels;
      run(part, begin, end);
    });
  });
}

bool is_giant(const ChunkInput &input, const ChunkRows::Sizes &sizes, int insertion_level) {
  const double *first = sizes.diameter + sizes.level_number(insertion_level, 0);
  return *std::max_element(first, first + sizes.classes.count) * input.map.scale >= ChunkRows::kGiantDiameter;
}

}  // namespace

// False if a level's cells are much wider than its particles ask for, as its space is so wide.
bool ChunkRows::lay(const ChunkInput &input, const Sizes &sizes) {
  uint64_t next_layer = 1;
  double cells = 1, rows = 1;
  bool fits = true;
  for (int h = 0; h < level_count_; h++) {
    ChunkLevel &level = level_at(h);
    double extent[3], longest = 0;
    for (int axis = 0; axis < 3; axis++) {
      extent[axis] = level.space.high[axis] - level.space.low[axis];
      longest = std::max(longest, extent[axis]);
    }
    const double diameter = std::min(sizes.diameter[h] * input.map.scale, kBeyondAnyExtent);
    const double least = longest / kMostAlongAxis;
    fits = fits && least <= std::max(kCellLength * diameter, kLeastSlack);
    // Of all classes alike, so that giants come last.
    level.giants = is_giant(input, sizes, h / sizes.classes.count);
    level.cell = whole_float(std::max((kCellLength * diameter + kLeastSlack) / (1 - kSlackPerCell), least));
    level.slack = kLeastSlack + kSlackPerCell * level.cell;
    level.row_width = whole_float(std::max(kRowWidth * diameter + 4 * level.slack, least));
    level.first_layer = next_layer;
    level.layers = static_cast<uint64_t>(std::floor(extent[2] / level.row_width)) + 1;
    next_layer += level.layers + 1;
    cells = std::max(cells, std::floor(extent[0] / level.cell) + 1);
    rows = std::max(rows, std::floor(extent[1] / level.row_width) + 1);
  }
  cell_bits_ = bit_width(static_cast<uint64_t>(cells) + 1);
  row_bits_ = bit_width(static_cast<uint64_t>(rows) + 3);
  layer_bits_ = bit_width(next_layer);
  return fits;
}

// The space that the particles of each level take.
void ChunkRows::find_spaces(const ChunkInput &input, const Sizes &sizes, int dimension, ChunkScratch &scratch) {
  const double *limit = sizes.radius_limit, *last = limit + sizes.insertion_levels - 1;
  const auto levels = static_cast<size_t>(level_count_);
  scratch.any.require(levels);
  std::fill_n(scratch.any.data(), levels, uint8_t{0});
  const auto take = [&](int c, size_t particle) {
    const auto insertion_level = static_cast<int>(std::lower_bound(limit, last, input.radii[particle]) - limit);
    const int h = sizes.level_number(insertion_level, c);
    uint8_t &any = scratch.any[static_cast<size_t>(h)];
    PlaceBox &space = level_at(h).space;
    double place[3];
    input.map.find_place(input.centers + particle * static_cast<size_t>(dimension), dimension, place);
    for (int axis = 0; axis < dimension; axis++) {
      space.low[axis] = any != 0 ? std::min(space.low[axis], place[axis]) : place[axis];
      space.high[axis] = any != 0 ? std::max(space.high[axis], place[axis]) : place[axis];
    }
    any = 1;
  };
  sizes.classes.each(0, sizes.classes.end(), [&](int c, size_t begin, size_t end) {
    for (size_t particle = begin; particle < end; particle++) take(c, particle);
  });
  for (size_t h = 0; h < levels; h++) {
    if (scratch.any[h] == 0) levels_[h].space = {};
  }
}

// key_at(i) is the key of particle i in sorted order. Without a branch for where a chunk or a row begins: what is not
// yet its place is written over. Chunks side by side have units side by side; where one is missing between two, it gets
// a unit as if it were there. Unit 0 is never used, so that what is before the first has a number.
template <class KeyAt>
void ChunkRows::list_chunks(KeyAt &&key_at, size_t count, uint32_t *slot, ChunkScratch &scratch) {
  constexpr size_t kTogether = 64;
  chunk_of_.require_room(count + kPadding);
  chunk_x_.require_room(count + kPadding);
  chunk_cell_.require_room(count + kPadding);
  chunk_row_.require_room(count);
  row_chunk_.require_room(count + 1);
  scratch.row_key.require_room(count + 3);
  uint64_t row_before = ~uint64_t{0};
  uint32_t x_before = 0, chunk = 0, row = 0, row_begin = 0;  // chunk, row: one more than the number of the last one
  int32_t cell = 0;
  const auto read = [&](size_t i, uint32_t *begin) {
    const ChunkKey key = key_at(i);
    const uint32_t x = key.cell / kChunkCells;
    const uint32_t new_row = key.row != row_before ? 1 : 0;
    const uint32_t new_chunk = new_row | (x != x_before ? 1u : 0u);
    const uint32_t one_missing = new_row == 0 && x == x_before + 2 ? 1 : 0;
    row_begin = new_row != 0 ? chunk : row_begin;
    row += new_row;
    chunk += new_chunk;
    cell += static_cast<int32_t>(new_chunk + one_missing) * kChunkCells;
    scratch.row_key[row - 1] = key.row;
    row_chunk_[row - 1] = row_begin;
    chunk_x_[chunk - 1] = static_cast<int32_t>(x);
    chunk_row_[chunk - 1] = row - 1;
    chunk_cell_[chunk - 1] = cell;
    chunk_of_[i] = chunk - 1;
    slot[i] = key.slot;
    // All that begins behind this particle, as far as the next one may be.
    uint32_t *behind = begin + static_cast<size_t>(cell) + key.cell % kChunkCells + 1;
    for (size_t n = 0; n < kMostCellsBetween; n++) behind[n] = static_cast<uint32_t>(i + 1);
    row_before = key.row;
    x_before = x;
  };
  cell_begin_.grow(kMostCellsBetween);
  std::fill(cell_begin_.data(), cell_begin_.data() + kMostCellsBetween, 0u);
  for (size_t at = 0; at < count; at += kTogether) {
    cell_begin_.grow(static_cast<size_t>(cell) + (2 * kTogether + 3) * kChunkCells + kCellPadding);
    for (size_t i = at; i < std::min(count, at + kTogether); i++) read(i, cell_begin_.data());
  }
  chunks_ = chunk;
  rows_ = row;
  row_chunk_[rows_] = chunk;
  cells_ = static_cast<size_t>(cell) + size_t{3} * kChunkCells;
  for (size_t i = 0; i < kPadding; i++) {
    chunk_of_[count + i] = 0;
    chunk_x_[chunks_ + i] = 0;
  }
  for (size_t i = 0; i < 3; i++) scratch.row_key[rows_ + i] = ~uint64_t{0};
}

// Of each class its levels stand together, as the kernels want them.
void ChunkRows::list_level_keys(const Sizes &sizes, ChunkScratch &scratch) const {
  scratch.level_keys.require(static_cast<size_t>(level_count_));
  ChunkLevelKey *key = scratch.level_keys.data();
  for (int c = 0; c < sizes.classes.count; c++) {
    for (int h = 0; h < sizes.insertion_levels; h++) {
      const ChunkLevel &level = this->level(sizes.level_number(h, c));
      *key++ = {sizes.radius_limit[h],
                1 / level.cell,
                1 / level.row_width,
                {level.space.low[0], level.space.low[1], level.space.low[2]},
                level.first_layer};
    }
  }
}

void ChunkRows::build(ChunkInput input, const Sizes &sizes, int dimension, uint32_t *slot, ChunkScratch &scratch,
                      int threads) {
  const size_t count = sizes.classes.end();
  level_count_ = sizes.level_count();
  levels_.require(static_cast<size_t>(level_count_));
  for (int h = 0; h < level_count_; h++) {
    level_at(h) = ChunkLevel{};
    for (int axis = 0; axis < dimension; axis++) level_at(h).space.high[axis] = to_whole(input.map.extent[axis]);
  }
  if (!lay(input, sizes)) {
    find_spaces(input, sizes, dimension, scratch);
    lay(input, sizes);
  }
  list_level_keys(sizes, scratch);
  input.level_count = sizes.insertion_levels;
  input.row_bits = row_bits_;
  const ChunkBuildKernel &kernel = active_kernels().chunk_build[dimension - 2];
  scratch.points.require_room(count);
  const PackedKeys packed{cell_bits_, bit_width(count)};
  if (layer_bits_ + row_bits_ + cell_bits_ + packed.slot_bits <= 64) {
    const uint64_t *keys = sorted_packed_keys(input, sizes, kernel, packed, scratch, threads);
    list_chunks([keys, packed](size_t i) { return unpack(packed, keys[i]); }, count, slot, scratch);
  } else {
    const ChunkKey *keys = sorted_keys(input, sizes, kernel, scratch, threads);
    list_chunks([keys](size_t i) { return keys[i]; }, count, slot, scratch);
  }
  list_layers(scratch);
  set_origins();
  link_rows(dimension, scratch);
}

// By row, then by cell.
const ChunkKey *ChunkRows::sorted_keys(const ChunkInput &input, const Sizes &sizes, const ChunkBuildKernel &kernel,
                                       ChunkScratch &scratch, int threads) const {
  const size_t count = sizes.classes.end();
  scratch.keys.require_room(count);
  scratch.other_keys.require_room(count);
  ChunkKey *keys = scratch.keys.data(), *other = scratch.other_keys.data();
  each_class(input, sizes, scratch.level_keys.data(), threads, [&](const ChunkInput &part, size_t begin, size_t end) {
    kernel.find_keys(part, begin, end, scratch.points.data(), keys);
  });
  ChunkKey *by_cell = radix_sort(keys, other, count, cell_bits_, [](const ChunkKey &key) { return key.cell; });
  return radix_sort(by_cell, by_cell == keys ? other : keys, count, row_bits_ + layer_bits_,
                    [](const ChunkKey &key) { return key.row; });
}

// The same with half of the memory to move.
const uint64_t *ChunkRows::sorted_packed_keys(const ChunkInput &input, const Sizes &sizes,
                                              const ChunkBuildKernel &kernel, const PackedKeys &packed,
                                              ChunkScratch &scratch, int threads) const {
  const size_t count = sizes.classes.end();
  scratch.packed.require_room(2 * count);
  uint64_t *keys = scratch.packed.data();
  each_class(input, sizes, scratch.level_keys.data(), threads, [&](const ChunkInput &part, size_t begin, size_t end) {
    kernel.find_packed_keys(part, packed, begin, end, scratch.points.data(), keys);
  });
  const int slot_bits = packed.slot_bits;
  return radix_sort(keys, keys + count, count, layer_bits_ + row_bits_ + cell_bits_,
                    [slot_bits](uint64_t key) { return key >> slot_bits; });
}

void ChunkRows::list_layers(const ChunkScratch &scratch) {
  const uint64_t *key = scratch.row_key.data();
  const uint64_t mask = (uint64_t{1} << row_bits_) - 1;
  layer_.require_room(rows_);
  layer_row_.require_room(rows_ + 1);
  row_y_.require_room(rows_);
  layers_ = 0;
  for (size_t row = 0; row < rows_; row++) {
    const uint64_t layer = key[row] >> row_bits_;
    if (row == 0 || layer != layer_[layers_ - 1]) {
      layer_[layers_] = layer;
      layer_row_[layers_++] = row;
    }
    row_y_[row] = static_cast<uint32_t>(key[row] & mask) - 1;
  }
  layer_row_[layers_] = rows_;
  size_t layer = 0;
  for (int h = 0; h < level_count_; h++) {
    ChunkLevel &level = level_at(h);
    level.first = layer;
    while (layer < layers_ && layer_[layer] < level.first_layer + level.layers) layer++;
    level.end = layer;
  }
}

// Places are whole, so that their lowest 32 bits can be reckoned with alone.
void ChunkRows::set_origins() {
  origin_x_.require_room(chunks_ + kCellPadding);
  origin_y_.require_room(chunks_ + kCellPadding);
  origin_z_.require_room(chunks_ + kCellPadding);
  for (int h = 0; h < level_count_; h++) {
    const ChunkLevel &level = this->level(h);
    if (level.giants || level.first == level.end) continue;
    const int32_t low = low_word(level.space.low[0]), length = low_word(level.chunk_length());
    for (size_t c = level_chunk_begin(level); c < level_chunk_end(level); c++) {
      origin_x_[c] = moved_by(low, chunk_x_[c], length);
    }
    for (size_t layer = level.first; layer < level.end; layer++) {
      const int32_t z = low_word(level.corner_z(layer_[layer]));
      for (size_t row = layer_row_[layer]; row < layer_row_[layer + 1]; row++) {
        const int32_t y = low_word(level.corner_y(row_y_[row]));
        for (size_t c = row_chunk_[row]; c < row_chunk_[row + 1]; c++) {
          origin_y_[c] = y;
          origin_z_[c] = z;
        }
      }
    }
  }
}

// The first chunk of the row from x on.
size_t ChunkRows::lower_chunk(size_t row, int32_t x) const {
  const int32_t *first = chunk_x_.data() + row_chunk_[row];
  size_t count = row_chunk_[row + 1] - row_chunk_[row];
  while (count > 4) {
    const size_t half = count / 2;
    first += first[half - 1] < x ? half : 0;
    count -= half;
  }
  size_t at = static_cast<size_t>(first - chunk_x_.data());
  for (size_t n = 0; n < 4; n++) at += n < count && first[n] < x ? 1 : 0;
  return at;
}

void ChunkRows::place_giants(const ChunkInput &input, const uint32_t *slot, uint32_t begin, size_t count,
                             int dimension) {
  giant_begin_ = begin;
  giant_end_ = static_cast<uint32_t>(count);
  for (int axis = 0; axis < dimension; axis++) giant_place_[axis].require_room(count - begin);
  for (size_t i = begin; i < count; i++) {
    double place[3];
    input.map.find_place(input.centers + slot[i] * static_cast<size_t>(dimension), dimension, place);
    for (int axis = 0; axis < dimension; axis++) giant_place_[axis][i - begin] = place[axis];
  }
}

ChunkTable ChunkRows::table(int h, float largest_radius) const {
  const ChunkLevel &level = this->level(h);
  ChunkTable table{};
  table.row_width = static_cast<float>(level.row_width);
  table.inverse_cell = static_cast<float>(1 / level.cell);
  table.largest_radius = largest_radius;
  table.slack = static_cast<float>(level.slack);
  table.chunk_of = chunk_of_.data();
  table.origin[0] = origin_x_.data();
  table.origin[1] = origin_y_.data();
  table.origin[2] = origin_z_.data();
  for (int n = 0; n < kStencilRows; n++) table.word[n] = word_[n].data();
  table.cell_begin = cell_begin_.data();
  return table;
}

void ChunkRows::find_corner(const ChunkLevel &level, size_t chunk, double *corner) const {
  const size_t row = chunk_row_[chunk], *first = layer_row_.data();
  const size_t layer = static_cast<size_t>(std::upper_bound(first + level.first, first + level.end, row) - first) - 1;
  corner[0] = level.corner_x(chunk_x_[chunk]);
  corner[1] = level.corner_y(row_y_[row]);
  corner[2] = level.corner_z(layer_[layer]);
}

void ChunkRows::find_place(const PointArrays &points, uint32_t particle, size_t chunk, const double *corner,
                           int dimension, double *place) const {
  for (int axis = 0; axis < dimension; axis++) {
    if (particle >= giant_begin_) {
      place[axis] = giant_place(axis, particle);
      continue;
    }
    const int32_t x = coordinates(points, axis)[particle];
    place[axis] = corner[axis] + static_cast<double>(near_difference(x, origin(axis)[chunk]));
  }
}

ChunkRows::Window ChunkRows::window_of(const ChunkLevel &level, const PlaceBox &box) const {
  const double edge[3] = {level.chunk_length(), level.row_width, level.row_width};
  const double slack = kFarSlack + level.slack;
  Window window{};
  for (int axis = 0; axis < 3; axis++) {
    const double first = level.space.low[axis], last = level.space.high[axis];
    window.first[axis] = static_cast<uint64_t>((std::clamp(box.low[axis] - slack, first, last) - first) / edge[axis]);
    window.last[axis] = static_cast<uint64_t>((std::clamp(box.high[axis] + slack, first, last) - first) / edge[axis]);
  }
  window.first[2] += level.first_layer;
  window.last[2] += level.first_layer;
  return window;
}

size_t ChunkRows::first_layer(const ChunkLevel &level, const Window &window) const {
  const uint64_t *all = layer_.data();
  return static_cast<size_t>(std::lower_bound(all + level.first, all + level.end, window.first[2]) - all);
}

size_t ChunkRows::first_row(size_t layer, const Window &window) const {
  const uint32_t *all = row_y_.data();
  return static_cast<size_t>(std::lower_bound(all + layer_row_[layer], all + layer_row_[layer + 1], window.first_y()) -
                             all);
}

size_t ChunkRows::first_chunk(size_t row, const Window &window) const {
  return lower_chunk(row, static_cast<int32_t>(window.first[0]));
}

}  // namespace hg
