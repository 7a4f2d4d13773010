// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The search kernel without vector instructions. It works in the order that vector kernels need, which fixes the order
// of the pairs: for blocks of particles, row by row of the search stencil, find where each particle's candidates begin
// and end (generate); then test them (consume).
#include "kernel.hpp"

#include <cmath>

namespace hg {
namespace {

constexpr uint32_t kBlock = 16;       // particles that step through the stencil together
constexpr uint32_t kMaxRanges = 512;  // candidate ranges collected before they are tested

float max_of(float a, float b) { return a > b ? a : b; }
float min_of(float a, float b) { return a < b ? a : b; }

// The one map from coordinates to cells, for particles and for search windows alike. Every step is monotone, so a
// particle inside a window is never in a cell outside the window's cells.
int32_t cell_of(const CellTable &cells, int axis, float x) {
  const float last = static_cast<float>(cells.count[axis]) - 0.5f;
  return static_cast<int32_t>(min_of(max_of(x * cells.inverse_width[axis], 0.0f), last));
}

// Distance from x to the nearest point of row c.
float gap_to(const CellTable &cells, int axis, int32_t c, float x) {
  const float below = static_cast<float>(c) * cells.width[axis];
  const float above = static_cast<float>(c + 1) * cells.width[axis];
  return max_of(0.0f, max_of(below - x, x - above));
}

// Candidates [begin, end) of one point.
struct Ranges {
  uint32_t point[kMaxRanges], begin[kMaxRanges], end[kMaxRanges];
  uint32_t count = 0;
};

template <int D, bool MaxRange>
class ScalarSearch {
 public:
  ScalarSearch(const PointArrays &points, const CellTable &cells, const PointArrays &particles, PairSink *sink)
      : points_(points), cells_(cells), particles_(particles), sink_(sink) {}

  bool own_level(uint32_t begin, uint32_t end) {
    for (uint32_t block = begin; block < end; block += kBlock) {
      const uint32_t block_end = end - block > kBlock ? block + kBlock : end;
      for (uint32_t i = block; i < block_end; i++) rest_of_own_row(i);
      if (D == 3) {
        own_level_row(block, block_end, 1, 0);
        for (int32_t dy = -1; dy <= 1; dy++) own_level_row(block, block_end, dy, 1);
      } else {
        own_level_row(block, block_end, 1, 0);
      }
      if (ranges_.count > kMaxRanges - 5 * kBlock && !consume()) return false;
    }
    return consume();
  }

  bool cross_level(uint32_t begin, uint32_t end) {
    for (uint32_t block = begin; block < end; block += kBlock) {
      const uint32_t block_end = end - block > kBlock ? block + kBlock : end;
      if (!cross_level_block(block, block_end)) return false;
    }
    return consume();
  }

 private:
  float x_of(uint32_t i) const { return static_cast<float>(points_.x[i]); }
  float y_of(uint32_t i) const { return static_cast<float>(points_.y[i]); }
  float z_of(uint32_t i) const { return D == 3 ? static_cast<float>(points_.z[i]) : 0.0f; }

  static float reach(float ri, float rj) { return MaxRange ? max_of(ri, rj) : ri + rj; }

  // How far from the centre of point i a partner on this level can be.
  float window(uint32_t i) const {
    return (reach(points_.radius[i], cells_.largest_radius) + kWindowSlack) * kWindowScale;
  }

  const uint32_t *row(int32_t y, int32_t z) const {
    const size_t index = D == 3 ? static_cast<size_t>(z) * static_cast<size_t>(cells_.count[1]) + static_cast<size_t>(y)
                                : static_cast<size_t>(y);
    return cells_.cell_begin + index * static_cast<size_t>(cells_.count[0]);
  }

  void push(uint32_t i, uint32_t begin, uint32_t end) {
    ranges_.point[ranges_.count] = i;
    ranges_.begin[ranges_.count] = begin;
    ranges_.end[ranges_.count] = end;
    ranges_.count += end > begin ? 1 : 0;
  }

  // What a sphere of squared radius w2 - gap2 (its chord with the row) can meet in a row.
  void push_row(uint32_t i, int32_t y, int32_t z, float half2) {
    if (!(half2 > 0)) return;
    const float half = std::sqrt(half2);
    const uint32_t *cell = row(y, z);
    push(i, cell[cell_of(cells_, 0, x_of(i) - half)], cell[cell_of(cells_, 0, x_of(i) + half) + 1]);
  }

  void rest_of_own_row(uint32_t i) {
    const int32_t y = cell_of(cells_, 1, y_of(i)), z = D == 3 ? cell_of(cells_, 2, z_of(i)) : 0;
    push(i, i + 1, row(y, z)[cell_of(cells_, 0, x_of(i) + window(i)) + 1]);
  }

  void own_level_row(uint32_t begin, uint32_t end, int32_t dy, int32_t dz) {
    for (uint32_t i = begin; i < end; i++) {
      const int32_t y = cell_of(cells_, 1, y_of(i)) + dy;
      const int32_t z = D == 3 ? cell_of(cells_, 2, z_of(i)) + dz : 0;
      if (y < 0 || y >= cells_.count[1] || (D == 3 && z >= cells_.count[2])) continue;
      const float w = window(i);
      const float gap_y = gap_to(cells_, 1, y, y_of(i));
      const float gap_z = D == 3 ? gap_to(cells_, 2, z, z_of(i)) : 0.0f;
      push_row(i, y, z, w * w - gap_y * gap_y - gap_z * gap_z);
    }
  }

  bool cross_level_block(uint32_t begin, uint32_t end) {
    int32_t first_y[kBlock], last_y[kBlock], first_z[kBlock], last_z[kBlock];
    int32_t rows_y = 0, rows_z = 0;
    for (uint32_t k = 0; k < end - begin; k++) {
      const uint32_t i = begin + k;
      const float w = window(i);
      first_y[k] = cell_of(cells_, 1, y_of(i) - w);
      last_y[k] = cell_of(cells_, 1, y_of(i) + w);
      first_z[k] = D == 3 ? cell_of(cells_, 2, z_of(i) - w) : 0;
      last_z[k] = D == 3 ? cell_of(cells_, 2, z_of(i) + w) : 0;
      rows_y = rows_y > last_y[k] - first_y[k] + 1 ? rows_y : last_y[k] - first_y[k] + 1;
      rows_z = rows_z > last_z[k] - first_z[k] + 1 ? rows_z : last_z[k] - first_z[k] + 1;
    }
    for (int32_t dz = 0; dz < rows_z; dz++) {
      for (int32_t dy = 0; dy < rows_y; dy++) {
        for (uint32_t k = 0; k < end - begin; k++) {
          const int32_t y = first_y[k] + dy, z = first_z[k] + dz;
          if (y > last_y[k] || z > last_z[k]) continue;
          const uint32_t i = begin + k;
          const float w = window(i);
          const float gap_y = gap_to(cells_, 1, y, y_of(i));
          const float gap_z = D == 3 ? gap_to(cells_, 2, z, z_of(i)) : 0.0f;
          push_row(i, y, z, w * w - gap_y * gap_y - gap_z * gap_z);
        }
        if (ranges_.count > kMaxRanges - kBlock && !consume()) return false;
      }
    }
    return true;
  }

  bool consume() {
    for (uint32_t k = 0; k < ranges_.count; k++) {
      for (uint32_t begin = ranges_.begin[k]; begin < ranges_.end[k]; begin += kMaxPiece) {
        const uint32_t end = ranges_.end[k] - begin > kMaxPiece ? begin + kMaxPiece : ranges_.end[k];
        if (static_cast<size_t>(sink_->limit - sink_->next) < end - begin && !sink_->make_room(sink_, end - begin)) {
          return false;
        }
        test(ranges_.point[k], begin, end);
      }
    }
    ranges_.count = 0;
    return true;
  }

  void test(uint32_t i, uint32_t begin, uint32_t end) {
    const int32_t x = points_.x[i], y = points_.y[i], z = D == 3 ? points_.z[i] : 0;
    const float ri = points_.radius[i];
    const uint32_t slot = points_.slot[i];
    hg_pair *next = sink_->next;
    for (uint32_t j = begin; j < end; j++) {
      const float dx = static_cast<float>(x - particles_.x[j]);
      const float dy = static_cast<float>(y - particles_.y[j]);
      const float dz = D == 3 ? static_cast<float>(z - particles_.z[j]) : 0.0f;
      const float r = reach(ri, particles_.radius[j]);
      const float t = dx * dx + dy * dy + dz * dz - r * r;
      const float band = r * (kBandLinear + kBandSquare * r) + kBandConstant;
      if (t >= band) continue;
      if (t >= -band && !settle(i, j)) continue;
      const uint32_t other = particles_.slot[j];
      const uint32_t low = slot < other ? slot : other, high = slot < other ? other : slot;
      *next++ = {static_cast<int32_t>(low) + sink_->id_offset, static_cast<int32_t>(high) + sink_->id_offset};
    }
    sink_->next = next;
    sink_->candidate_count += end - begin;
  }

  bool settle(uint32_t i, uint32_t j) {
    sink_->undecided_count++;
    if (sink_->accept_undecided) return true;
    const uint8_t image = points_.image != nullptr ? points_.image[i] : kItself;
    return sink_->decide(sink_, points_.slot[i], particles_.slot[j], image);
  }

  static constexpr uint8_t kItself = 13;  // kNoImage of domain.hpp

  const PointArrays &points_;
  const CellTable &cells_;
  const PointArrays &particles_;
  PairSink *sink_;
  Ranges ranges_;
};

template <int D, bool MaxRange>
SearchKernel make_kernel() {
  SearchKernel kernel;
  kernel.own_level = [](const PointArrays &points, uint32_t begin, uint32_t end, const CellTable &cells,
                        PairSink *sink) {
    return ScalarSearch<D, MaxRange>(points, cells, points, sink).own_level(begin, end);
  };
  kernel.cross_level = [](const PointArrays &points, uint32_t begin, uint32_t end, const CellTable &cells,
                          const PointArrays &particles, PairSink *sink) {
    return ScalarSearch<D, MaxRange>(points, cells, particles, sink).cross_level(begin, end);
  };
  return kernel;
}

}  // namespace

SearchKernel scalar_kernel(int dimension, int32_t interaction) {
  if (dimension == 2) return interaction == HG_CONTACT ? make_kernel<2, false>() : make_kernel<2, true>();
  return interaction == HG_CONTACT ? make_kernel<3, false>() : make_kernel<3, true>();
}

}  // namespace hg
