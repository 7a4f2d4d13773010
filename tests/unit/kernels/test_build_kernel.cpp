// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The build kernels of every instruction set that this machine runs: each particle is counted in the row of its level
// and goes there, in the order of its slot, at its place in quanta; then rows are sorted by cell. Parts of the
// particles and of the rows, full blocks or not.
#include "src/space/level_cells.hpp"
#include "tests/unit/checks.hpp"
#include "tests/unit/exact_place.hpp"
#include "tests/unit/kernels/any_space.hpp"
#include "tests/unit/kernels/block_counts.hpp"
#include "tests/unit/kernels/kernel_sets.hpp"
#include "tests/unit/plain_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace {

using namespace hgtest;

constexpr int32_t kGuard = -77;

bool same(const hg::RowParticle &p, const hg::RowParticle &q) {
  return p.x == q.x && p.y == q.y && p.z == q.z && p.radius == q.radius && p.slot == q.slot;
}

constexpr hg::RowParticle kGuardParticle{kGuard, kGuard, kGuard, static_cast<float>(kGuard),
                                         static_cast<uint32_t>(kGuard)};

// What the three passes write, with a guard element behind each array.
struct Built {
  Built(size_t count, size_t rows, size_t cells)
      : row_of(count + 1, static_cast<uint32_t>(kGuard)),
        row_count(rows + 1, 0),
        particles(count + 1, kGuardParticle),
        cell_begin(cells + 1, static_cast<uint32_t>(kGuard)),
        radius(count + 1, static_cast<float>(kGuard)),
        slot(count + 1, static_cast<uint32_t>(kGuard)) {
    for (auto &column : x) column.assign(count + 1, kGuard);
  }
  bool operator==(const Built &other) const {
    return row_of == other.row_of && row_count == other.row_count &&
           std::equal(particles.begin(), particles.end(), other.particles.begin(), same) &&
           cell_begin == other.cell_begin && x[0] == other.x[0] && x[1] == other.x[1] && x[2] == other.x[2] &&
           radius == other.radius && slot == other.slot;
  }
  bool guarded() const {
    return row_of.back() == static_cast<uint32_t>(kGuard) && row_count.back() == 0 &&
           same(particles.back(), kGuardParticle) && cell_begin.back() == static_cast<uint32_t>(kGuard) &&
           same(sorted(slot.size() - 1), kGuardParticle);
  }
  hg::RowParticle sorted(size_t at) const { return {x[0][at], x[1][at], x[2][at], radius[at], slot[at]}; }

  std::vector<uint32_t> row_of, row_count;
  std::vector<hg::RowParticle> particles;
  std::vector<uint32_t> cell_begin;
  std::vector<int32_t> x[3];
  std::vector<float> radius;
  std::vector<uint32_t> slot;
};

class Scene {
 public:
  Scene(uint64_t seed, size_t count) : rng_(seed), space_(rng_), count_(count) {
    const double largest = std::ldexp(1 / space_.map.scale, rng_.integer(0, 28));
    for (size_t i = 0; i < count; i++) {
      double center[3];
      space_.any_center(rng_, center);
      centers_.insert(centers_.end(), center, center + dimension());
      radii_.push_back(rng_.chance(0.1) ? 0 : largest * std::pow(2, rng_.uniform(-20, 0)));
    }
    lay_levels(largest);
    cut();
    extent_ = extent_of(centers_, dimension());
    input_ = {
        {centers_.data(), radii_.data(), extent_.data(), space_.map, rng_.chance(0.5) ? 0 : largest * rng_.uniform()},
        static_cast<int>(levels_.size()),
        levels_.data()};
  }

  void check() {
    const Built plain = build(hg::kScalarKernels);
    require(plain.guarded(), "scalar: wrote beyond the particles");
    check_rows(plain);
    check_points(plain);
    for (size_t h = 0; h < levels_.size(); h++) check_sorted(plain, h);
    for (const hg::KernelSet *set : kernel_sets()) {
      require(build(*set) == plain, "%s: another result than the scalar kernels'", set->name);
    }
  }

 private:
  int dimension() const { return space_.domain.dimension; }
  const double *center(size_t i) const { return centers_.data() + i * static_cast<size_t>(dimension()); }

  // Limits that some radii meet exactly; levels without a table have one row.
  void lay_levels(double largest) {
    const int count = rng_.integer(1, 8);
    for (int h = 0; h < count; h++) {
      const double limit = h + 1 == count ? largest : largest * std::pow(2, -3.0 * (count - 1 - h));
      if (h + 1 < count && count_ > 0) radii_[rng_.below(count_)] = limit;
      hg::LevelRows level{limit, 0, 0.5f, 0, 0.5f, 1, rows_};
      if (rng_.chance(0.8)) {
        const hg::LevelCells laid =
            hg::lay_cells(space_.map, dimension(), 2 * limit * space_.map.scale, 1 + rng_.below(5000));
        const hg::CellTable &table = laid.table;
        level = {limit,
                 table.inverse_width[1],
                 hg::last_of(table, 1),
                 table.inverse_width[2],
                 hg::last_of(table, 2),
                 static_cast<uint32_t>(table.count[1]),
                 rows_};
        tables_.push_back(table);
      } else {
        tables_.push_back({{1, 1, 1}, {}, {}, 0, nullptr});
      }
      levels_.push_back(level);
      first_cell_.push_back(cells_);
      rows_ += static_cast<uint32_t>(rows_of(static_cast<size_t>(h)));
      cells_ += rows_of(static_cast<size_t>(h)) * static_cast<size_t>(tables_.back().count[0]);
    }
  }

  size_t rows_of(size_t h) const {
    return static_cast<size_t>(tables_[h].count[1]) * static_cast<size_t>(tables_[h].count[2]);
  }

  // Where the particles are cut into parts that threads would share.
  void cut() {
    for (size_t at = 0; at < count_; at += 1 + rng_.below(200)) cuts_.push_back(at);
    cuts_.push_back(count_);
  }

  Built build(const hg::KernelSet &set) const {
    const hg::BuildKernel &kernel = set.build[dimension() - 2];
    Built built(count_, rows_, cells_);
    for (size_t part = 0; part + 1 < cuts_.size(); part++) {
      kernel.find_rows(input_, cuts_[part], cuts_[part + 1], {built.row_of.data(), built.row_count.data()});
    }
    const std::vector<uint32_t> begin = row_begins(built);
    std::vector<uint32_t> next = begin;
    for (size_t part = 0; part + 1 < cuts_.size(); part++) {
      kernel.put_into_rows(input_, cuts_[part], cuts_[part + 1],
                           {built.row_of.data(), next.data(), built.particles.data()});
    }
    std::vector<uint32_t> room(count_);
    for (size_t h = 0; h < levels_.size(); h++) {
      const hg::CellTable &table = tables_[h];
      const size_t rows = rows_of(h), half = rows / 2;
      const hg::RowSort sort{
          built.particles.data(),
          begin.data() + levels_[h].row_base,
          table.count[0],
          table.inverse_width[0],
          hg::last_of(table, 0),
          built.cell_begin.data() + first_cell_[h],
          {built.x[0].data(), built.x[1].data(), built.x[2].data(), built.radius.data(), built.slot.data()}};
      kernel.sort_rows(sort, half, rows, room.data());
      kernel.sort_rows(sort, 0, half, room.data());
    }
    return built;
  }

  std::vector<uint32_t> row_begins(const Built &built) const {
    std::vector<uint32_t> begin(rows_ + 1);
    std::exclusive_scan(built.row_count.begin(), built.row_count.end(), begin.begin(), 0u);
    return begin;
  }

  void check_rows(const Built &built) const {
    std::vector<uint32_t> counted(rows_ + 1, 0);
    for (size_t i = 0; i < count_; i++) {
      require(built.row_of[i] < rows_, "particle %zu is in row %u of %u", i, built.row_of[i], rows_);
      counted[built.row_of[i]]++;
    }
    require(built.row_count == counted, "rows are miscounted");
  }

  // The level that takes the radius, and there the row of the place.
  uint32_t row_of(double radius, int32_t y, int32_t z) const {
    size_t h = 0;
    while (h + 1 < levels_.size() && radius > levels_[h].radius_limit) h++;
    const hg::CellTable &table = tables_[h];
    const size_t row = plain_cell(table, 2, z) * static_cast<size_t>(table.count[1]) + plain_cell(table, 1, y);
    return levels_[h].row_base + static_cast<uint32_t>(row);
  }

  void check_points(const Built &built) const {
    for (size_t at = 0; at < count_; at++) {
      const hg::RowParticle &point = built.particles[at];
      const size_t i = point.slot;
      require(i < count_, "point %zu has slot %zu", at, i);
      // Each slot once, as both row and slot ascend.
      const size_t before = at == 0 ? 0 : built.particles[at - 1].slot;
      const bool after =
          at == 0 || built.row_of[i] > built.row_of[before] || (built.row_of[i] == built.row_of[before] && i > before);
      require(after, "point %zu, slot %zu, is out of order", at, i);
      const int32_t place[3] = {point.x, point.y, point.z};
      for (int axis = 0; axis < dimension(); axis++) {
        require(place[axis] >= 0 && place[axis] < 1 << 30, "coordinate %d", place[axis]);
      }
      require_place(space_.map, space_.domain, center(i), place);
      require(dimension() == 3 || point.z == 0, "z is %d in 2D", point.z);
      const uint32_t row = row_of(radii_[i], point.y, point.z);
      require(built.row_of[i] == row, "slot %zu is in row %u instead of %u", i, built.row_of[i], row);
      const mpq_class folded = (mpq_class(radii_[i]) + mpq_class(input_.extra_radius)) * mpq_class(space_.map.scale);
      require(abs(mpq_class(static_cast<double>(point.radius)) - folded) <= folded * mpq_class(1, 1 << 23),
              "radius %g instead of %g", static_cast<double>(point.radius), folded.get_d());
    }
  }

  // The rows of a level hold the same particles, by cell and then by slot, and cells begin where they do.
  void check_sorted(const Built &built, size_t h) const {
    const std::vector<uint32_t> begin = row_begins(built);
    for (size_t row = 0; row < rows_of(h); row++) {
      std::vector<hg::RowParticle> wanted(built.particles.begin() + begin[levels_[h].row_base + row],
                                          built.particles.begin() + begin[levels_[h].row_base + row + 1]);
      const auto cell = [&](const hg::RowParticle &p) { return plain_cell(tables_[h], 0, p.x); };
      std::stable_sort(wanted.begin(), wanted.end(),
                       [&](const hg::RowParticle &p, const hg::RowParticle &q) { return cell(p) < cell(q); });
      const size_t first = begin[levels_[h].row_base + row];
      for (size_t n = 0; n < wanted.size(); n++) {
        hg::RowParticle found = built.sorted(first + n);
        require(dimension() == 3 || found.z == kGuard, "z is written in 2D");
        if (dimension() == 2) found.z = 0;
        require(same(found, wanted[n]), "point %zu of row %zu of level %zu is slot %u instead of %u", n, row, h,
                found.slot, wanted[n].slot);
      }
      const auto cells = static_cast<size_t>(tables_[h].count[0]);
      size_t before = 0;
      for (size_t c = 0; c < cells; c++) {
        while (before < wanted.size() && cell(wanted[before]) < c) before++;
        require(built.cell_begin[first_cell_[h] + row * cells + c] == first + before,
                "cell %zu of row %zu of level %zu begins wrongly", c, row, h);
      }
    }
  }

  Rng rng_;
  Space space_;
  size_t count_;
  std::vector<double> centers_, radii_;
  std::array<hg::Interval, 3> extent_;
  std::vector<hg::LevelRows> levels_;
  std::vector<hg::CellTable> tables_;
  std::vector<size_t> first_cell_;
  uint32_t rows_ = 0;
  size_t cells_ = 0;
  std::vector<size_t> cuts_;
  hg::BuildInput input_{};
};

}  // namespace

int main() { return check_counts<Scene, 150>("build_kernel"); }
