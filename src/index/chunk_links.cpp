// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What each chunk knows of its neighbours in the rows of the half stencil (space/chunk_table.hpp).
#include "src/index/chunk_rows.hpp"

#include <algorithm>
#include <cmath>

namespace hg {
namespace {

// The word for chunks of which bits tell those that exist; `cell`: the first one of the first of them.
constexpr int32_t relative_word(uint32_t exist) {
  const int32_t first = __builtin_ctz(exist | 8u), last = 32 - __builtin_clz(exist << 1 | 1u) - 1;
  return (1 - first) * ChunkWord::kFlags + first + 4 * last;
}
constexpr int32_t kRelativeWord[8] = {relative_word(0), relative_word(1), relative_word(2), relative_word(3),
                                      relative_word(4), relative_word(5), relative_word(6), relative_word(7)};
// Where none exists the cell is anything, so this must not overflow.
int32_t first_cell_word(int32_t cell, uint32_t exist) {
  constexpr uint32_t kFlagsPerCell = ChunkWord::kFlags / kChunkCells;
  return static_cast<int32_t>(static_cast<uint32_t>(cell) * kFlagsPerCell +
                              static_cast<uint32_t>(kRelativeWord[exist]));
}

// Links are found by places where these are not many more than chunks.
constexpr double kPlacesPerChunk = 96, kFewPlaces = 4096;
constexpr double kMostPlaces = 0x1p31;

}  // namespace

void ChunkRows::link_rows(int dimension, ChunkScratch &scratch) {
  for (auto &word : word_) word.require_room(chunks_ + kCellPadding);
  for (int n = 1; n < kStencilRows; n++) std::fill(word_[n].data(), word_[n].data() + chunks_, ChunkWord::kNone);
  link_own_row();
  for (int h = 0; h < level_count_; h++) {
    const ChunkLevel &level = this->level(h);
    if (level.first == level.end) continue;
    const Places places = places_of(level);
    const double chunks = level_chunk_end(level) - level_chunk_begin(level);
    const double most = std::min(kPlacesPerChunk * chunks + kFewPlaces, kMostPlaces);
    if (static_cast<double>(places.along) * static_cast<double>(places.rows) <= most) {
      link_by_places(level, places, dimension, scratch);
    } else {
      link_by_search(level, dimension, scratch);
    }
  }
}

// Between rows one place stays empty, before the first one row, behind the last one two.
ChunkRows::Places ChunkRows::places_of(const ChunkLevel &level) const {
  const int32_t *x = chunk_x_.data();
  const uint32_t *y = row_y_.data();
  const auto along = std::minmax_element(x + level_chunk_begin(level), x + level_chunk_end(level));
  const auto rows = std::minmax_element(y + layer_row_[level.first], y + layer_row_[level.end]);
  Places places{*along.first, *rows.first, 0, 0};
  places.along = static_cast<int64_t>(*along.second) - *along.first + 2;
  places.rows = static_cast<int64_t>(*rows.second) - *rows.first + 4;
  return places;
}

// The chunks of two layers are marked at a time.
void ChunkRows::link_by_places(const ChunkLevel &level, const Places &places, int dimension, ChunkScratch &scratch) {
  for (ChunkPlane &plane : scratch.plane) plane.require(static_cast<size_t>(places.along * places.rows));
  scratch.place.require_room(chunks_);
  uint32_t *place = scratch.place.data();
  for (uint32_t c = level_chunk_begin(level); c < level_chunk_end(level); c++) {
    const int64_t row = static_cast<int64_t>(row_y_[chunk_row_[c]]) - places.y + 1;
    place[c] = static_cast<uint32_t>(row * places.along + chunk_x_[c] - places.x + 1);
  }
  const auto each_chunk = [&](size_t layer, auto &&visit) {
    for (uint32_t c = row_chunk_[layer_row_[layer]]; c < row_chunk_[layer_row_[layer + 1]]; c++) visit(c);
  };
  each_chunk(level.first, [&](uint32_t c) { scratch.plane[0].add(place[c], c); });
  for (size_t layer = level.first; layer < level.end; layer++) {
    ChunkPlane &here = scratch.plane[(layer - level.first) % 2], &next = scratch.plane[(layer - level.first + 1) % 2];
    const bool is_last = layer + 1 == level.end;
    if (!is_last) each_chunk(layer + 1, [&](uint32_t c) { next.add(place[c], c); });
    const bool above = dimension == 3 && !is_last && layer_[layer + 1] == layer_[layer] + 1;
    const ChunkPlane *plane[] = {&here, &next, &next, &next};
    const int64_t step[] = {places.along, -places.along, 0, places.along};
    each_chunk(layer, [&](uint32_t c) {
      for (size_t n = 0; n < (above ? 4 : 1); n++) {
        word_[n + 1][c] = word_from(*plane[n], static_cast<size_t>(place[c] + step[n] - 1));
      }
    });
    each_chunk(layer, [&](uint32_t c) { here.remove(place[c]); });
  }
}

int32_t ChunkRows::word_from(const ChunkPlane &plane, size_t place) const {
  const ChunkPlane::Three three = plane.three_from(place);
  const int32_t word = first_cell_word(chunk_cell_[three.first], three.exist);
  return three.exist == 0 ? ChunkWord::kNone : word;
}

// Rows are sorted, so the neighbours of all rows in the next layer are met by one walk.
void ChunkRows::link_by_search(const ChunkLevel &level, int dimension, const ChunkScratch &scratch) {
  const uint64_t *key = scratch.row_key.data();
  const size_t end = layer_row_[level.end];
  size_t next = layer_row_[level.first];
  for (size_t row = next; row < end; row++) {
    if (key[row + 1] == key[row] + 1) link_row(row, 1, row + 1);
    if (dimension == 2) continue;
    const uint64_t first = key[row] + (uint64_t{1} << row_bits_) - 1;
    while (next < end && key[next] < first) next++;
    for (size_t n = next; n < next + 3; n++) {
      if (key[n] - first < 3) link_row(row, 2 + static_cast<int>(key[n] - first), n);
    }
  }
}

void ChunkRows::link_own_row() {
  const auto joined = [this](size_t c) {  // with the one before
    return static_cast<int32_t>(chunk_row_[c - 1] == chunk_row_[c]) &
           static_cast<int32_t>(chunk_x_[c - 1] + 1 == chunk_x_[c]);
  };
  const auto link = [this](size_t c, int32_t before, int32_t after) {
    const int32_t first = 1 - before, last = 2 + after;
    word_[0][c] = chunk_cell_[c] * (ChunkWord::kFlags / kChunkCells) + first + 4 * last;
  };
  const size_t last = chunks_ - 1;
  link(0, 0, last > 0 ? joined(1) : 0);
  for (size_t c = 1; c < last; c++) link(c, joined(c), joined(c + 1));
  if (last > 0) link(last, joined(last), 0);
}

void ChunkRows::link_row(size_t row, int stencil_row, size_t neighbor) {
  const size_t end = row_chunk_[neighbor + 1];
  const int32_t *x = chunk_x_.data();
  for (size_t c = row_chunk_[row]; c < row_chunk_[row + 1]; c++) {
    const size_t at = lower_chunk(neighbor, x[c] - 1);
    // Of the three from X - 1 to X + 1, which exist: those found at `at` and after it.
    uint32_t exists = 0;
    for (size_t n = at; n < at + 3; n++) {
      const auto place = static_cast<uint32_t>(x[n] - (x[c] - 1));
      exists |= n < end && place < 3 ? 1u << place : 0u;
    }
    if (exists == 0) continue;
    word_[stencil_row][c] = first_cell_word(chunk_cell_[at], exists);
  }
}

}  // namespace hg
