// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The build kernels of chunks, of every instruction set that this machine runs: the key of each particle by whole
// numbers, and its point. Parts of the particles, full blocks or not.
#include "tests/unit/checks.hpp"
#include "tests/unit/exact_place.hpp"
#include "tests/unit/kernels/any_space.hpp"
#include "tests/unit/kernels/block_counts.hpp"
#include "tests/unit/kernels/kernel_sets.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace {

using namespace hgtest;

constexpr int32_t kGuard = -77;

// What the two passes write, with a guard element behind each array.
struct Built {
  explicit Built(size_t count)
      : points(count + 1, {kGuard, kGuard, kGuard, 0}),
        keys(count + 1, {7, 7, 7}),
        radius(count + 1, static_cast<float>(kGuard)) {
    for (auto &column : x) column.assign(count + 1, kGuard);
  }
  bool operator==(const Built &other) const {
    const auto same = [](const hg::ChunkKey &a, const hg::ChunkKey &b) {
      return a.row == b.row && a.cell == b.cell && a.slot == b.slot;
    };
    return std::equal(keys.begin(), keys.end(), other.keys.begin(), same) && x[0] == other.x[0] && x[1] == other.x[1] &&
           x[2] == other.x[2] && radius == other.radius;
  }
  bool guarded() const {
    return keys.back().row == 7 && keys.back().cell == 7 && keys.back().slot == 7 && x[0].back() == kGuard &&
           x[1].back() == kGuard && x[2].back() == kGuard && radius.back() == static_cast<float>(kGuard) &&
           points.back().x == kGuard && points.back().y == kGuard && points.back().z == kGuard;
  }

  std::vector<hg::Point> points;  // by slot
  std::vector<hg::ChunkKey> keys;
  std::vector<int32_t> x[3];
  std::vector<float> radius;
};

struct Level {
  int64_t cell, row_width, low[3];
};

class Scene {
 public:
  Scene(uint64_t seed, size_t count) : rng_(seed), space_(rng_), count_(count) {
    double extent = 0;
    for (int axis = 0; axis < dimension(); axis++) extent = std::max(extent, space_.domain.length[axis]);
    const double largest = extent * std::pow(2, rng_.uniform(-24, 0));
    map_ = space_.wrapping(largest);
    for (size_t i = 0; i < count; i++) {
      double center[3];
      space_.any_center(rng_, center);
      centers_.insert(centers_.end(), center, center + dimension());
      radii_.push_back(rng_.chance(0.1) ? 0 : largest * std::pow(2, rng_.uniform(-20, 0)));
    }
    lay_levels(largest);
    extent_ = extent_of(centers_, dimension());
    input_ = {{centers_.data(), radii_.data(), extent_.data(), map_, rng_.chance(0.5) ? 0 : largest * rng_.uniform()},
              static_cast<int>(keys_.size()),
              keys_.data(),
              29};
    slots_.resize(count);
    std::iota(slots_.begin(), slots_.end(), 0u);
    for (size_t k = count; k > 1; k--) std::swap(slots_[k - 1], slots_[rng_.below(k)]);
    for (size_t at = 0; at < count_; at += 1 + rng_.below(200)) cuts_.push_back(at);
    cuts_.push_back(count_);
  }

  void check() const {
    const Built plain = build(hg::kScalarKernels);
    require(plain.guarded(), "scalar: wrote beyond the particles");
    for (size_t i = 0; i < count_; i++) check_key(plain.keys[i], i);
    for (size_t at = 0; at < count_; at++) check_point(plain, at);
    for (const hg::KernelSet *set : kernel_sets()) {
      require(build(*set) == plain, "%s: another result than the scalar kernels'", set->name);
    }
  }

 private:
  int dimension() const { return space_.domain.dimension; }
  int64_t place(size_t slot, int axis) const {
    double places[3];  // held against rational numbers in test_fixed_point.cpp
    map_.find_place(centers_.data() + slot * static_cast<size_t>(dimension()), dimension(), places);
    return static_cast<int64_t>(places[axis]);
  }
  size_t level_of(double radius) const {
    size_t h = 0;
    while (h + 1 < keys_.size() && radius > keys_[h].radius_limit) h++;
    return h;
  }

  // Limits that some radii meet exactly. Cells begin where the particles of the level do, and are so wide that their
  // numbers fit into 28 bits.
  void lay_levels(double largest) {
    const int count = rng_.integer(1, rng_.chance(0.1) ? HG_MAX_LEVELS : 8);
    for (int h = 0; h < count; h++) {
      const double limit = h + 1 == count ? largest : largest * std::pow(2, -20.0 * (count - 1 - h) / count);
      if (h + 1 < count && count_ > 0 && rng_.chance(0.5)) radii_[rng_.below(count_)] = limit;
      keys_.push_back({limit, 0, 0, {0, 0, 0}, 0});
    }
    uint64_t layer = 1;
    for (size_t h = 0; h < keys_.size(); h++) {
      Level level{1, 1, {0, 0, 0}};
      int64_t longest = 0;
      for (int axis = 0; axis < dimension(); axis++) {
        int64_t low = INT64_MAX, high = 0;
        for (size_t slot = 0; slot < count_; slot++) {
          if (level_of(radii_[slot]) != h) continue;
          low = std::min(low, place(slot, axis));
          high = std::max(high, place(slot, axis));
        }
        if (low == INT64_MAX) continue;
        level.low[axis] = rng_.chance(0.5) ? low : 0;
        longest = std::max(longest, high - level.low[axis]);
      }
      const int64_t least = (longest >> 28) + 1;
      level.cell = whole_float(least * std::pow(2, rng_.uniform(0, 20)));
      level.row_width = whole_float(least * std::pow(2, rng_.uniform(0, 20)));
      keys_[h].inverse_cell = 1 / static_cast<double>(level.cell);
      keys_[h].inverse_width = 1 / static_cast<double>(level.row_width);
      for (int axis = 0; axis < 3; axis++) keys_[h].low[axis] = static_cast<double>(level.low[axis]);
      keys_[h].first_layer = layer;
      layer += 1 + rng_.below(uint64_t{1} << 28);
      levels_.push_back(level);
    }
  }
  static int64_t whole_float(double x) { return static_cast<int64_t>(static_cast<float>(std::ceil(x) + 1)); }

  Built build(const hg::KernelSet &set) const {
    const hg::ChunkBuildKernel &kernel = set.chunk_build[dimension() - 2];
    Built built(count_);
    for (size_t part = 0; part + 1 < cuts_.size(); part++) {
      kernel.find_keys(input_, cuts_[part], cuts_[part + 1], built.points.data(), built.keys.data());
    }
    for (size_t part = 0; part + 1 < cuts_.size(); part++) {
      kernel.put(built.points.data(), slots_.data(), cuts_[part], cuts_[part + 1],
                 {built.x[0].data(), built.x[1].data(), built.x[2].data(), built.radius.data(), nullptr});
    }
    check_packed(kernel, built);
    return built;
  }

  // The same keys in one number, as many of their bits as it holds, and the same points.
  void check_packed(const hg::ChunkBuildKernel &kernel, const Built &built) const {
    const hg::PackedKeys packed{20, 13};
    constexpr uint64_t kCells = (uint64_t{1} << 20) - 1, kRows = (uint64_t{1} << (64 - 20 - 13)) - 1;
    std::vector<uint64_t> keys(count_ + 1, 7);
    std::vector<hg::Point> points(count_);
    for (size_t part = 0; part + 1 < cuts_.size(); part++) {
      kernel.find_packed_keys(input_, packed, cuts_[part], cuts_[part + 1], points.data(), keys.data());
    }
    require(keys.back() == 7, "packed keys are written beyond their end");
    const auto same = [](const hg::Point &a, const hg::Point &b) {
      return a.x == b.x && a.y == b.y && a.z == b.z && a.radius == b.radius;
    };
    require(std::equal(points.begin(), points.end(), built.points.begin(), same), "other points beside packed keys");
    for (size_t i = 0; i < count_; i++) {
      const hg::ChunkKey &key = built.keys[i], found = unpack(packed, keys[i]);
      if (key.cell > kCells || key.slot >> 13 != 0) continue;  // more bits than there are
      require(found.row == (key.row & kRows) && found.cell == key.cell && found.slot == key.slot, "packed key %zu", i);
    }
  }

  // The whole quotient, or one below it where the division leaves nothing.
  static void require_number(const char *what, uint64_t number, int64_t above, int64_t width) {
    const auto quotient = static_cast<uint64_t>(above / width);
    require(number == quotient || (above % width == 0 && above > 0 && number + 1 == quotient),
            "%s %llu instead of %llu", what, static_cast<unsigned long long>(number),
            static_cast<unsigned long long>(quotient));
  }

  void check_key(const hg::ChunkKey &key, size_t slot) const {
    require(key.slot == slot, "slot %u instead of %zu", key.slot, slot);
    const size_t h = level_of(radii_[slot]);
    const Level &level = levels_[h];
    require_number("cell", key.cell, place(slot, 0) - level.low[0], level.cell);
    const uint64_t y = key.row & ((uint64_t{1} << input_.row_bits) - 1), z = key.row >> input_.row_bits;
    require(y > 0 && z >= keys_[h].first_layer, "row %llu of layer %llu is of no level",
            static_cast<unsigned long long>(y), static_cast<unsigned long long>(z));
    require_number("row", y - 1, place(slot, 1) - level.low[1], level.row_width);
    const int64_t above = dimension() == 3 ? place(slot, 2) - level.low[2] : 0;
    require_number("layer", z - keys_[h].first_layer, above, level.row_width);
  }

  void check_point(const Built &built, size_t at) const {
    const size_t slot = slots_[at];
    for (int axis = 0; axis < dimension(); axis++) {
      const auto wrapped = static_cast<int32_t>(static_cast<uint32_t>(static_cast<uint64_t>(place(slot, axis))));
      require(built.x[axis][at] == wrapped, "axis %d: %d instead of %d", axis, built.x[axis][at], wrapped);
    }
    require(dimension() == 3 || built.x[2][at] == kGuard, "z is written in 2D");
    const mpq_class folded = (mpq_class(radii_[slot]) + mpq_class(input_.extra_radius)) * mpq_class(map_.scale);
    require(abs(mpq_class(static_cast<double>(built.radius[at])) - folded) <= folded * mpq_class(1, 1 << 23),
            "radius %g instead of %g", static_cast<double>(built.radius[at]), folded.get_d());
  }

  Rng rng_;
  Space space_;
  hg::FixedPoint map_;
  size_t count_;
  std::vector<double> centers_, radii_;
  std::vector<hg::ChunkLevelKey> keys_;
  std::vector<Level> levels_;
  std::vector<size_t> cuts_;     // into parts that threads would share
  std::vector<uint32_t> slots_;  // in any order
  std::array<hg::Interval, 3> extent_;
  hg::ChunkInput input_{};
};

}  // namespace

int main() { return check_counts<Scene, 150>("chunk_build_kernel"); }
