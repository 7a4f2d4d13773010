// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/levels/work_cost.hpp"

#include "src/levels/companions.hpp"
#include "src/space/level_cells.hpp"

#include <algorithm>
#include <cmath>

namespace hg {
namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

struct WorkCost::Level {
  ClassRange range;
  double particles;
  double largest_radius;  // in quanta
  double row_width, cell_length;
  double rows;  // in all
};

WorkPrices WorkPrices::fitted(size_t particles) const {
  // Where caches hold the particles, and where they hold a small part of them; between, by the logarithm.
  constexpr double kLevel[2] = {4, 12}, kRow[2] = {18, 24};
  constexpr int kCached = 17, kOctaves = 3;  // 2^17 to 2^20 particles
  int exponent = 0;
  const double mantissa = std::frexp(static_cast<double>(particles), &exponent);  // in [1/2, 1)
  const double octaves = (exponent - 1 - kCached) + (2 * mantissa - 1);  // the logarithm, straight within an octave
  const double share = std::clamp(octaves / kOctaves, 0.0, 1.0);
  const auto fit = [share](double price, const double(&fitted)[2]) {
    return price < 0 ? fitted[0] + share * (fitted[1] - fitted[0]) : price;
  };
  return {fit(level, kLevel), fit(row, kRow)};
}

WorkCost::WorkCost(const SizeClasses &classes, const Interaction &interaction, const FixedPoint &map, int dimension,
                   const Density &density, const WorkPrices &prices)
    : classes_(classes),
      interaction_(interaction),
      map_(map),
      dimension_(dimension),
      density_(density),
      prices_(prices) {
  const size_t count = classes.count();
  particles_ = static_cast<double>(classes.particles(0, count - 1));
  double sum[3] = {0, 0, 0};
  for (size_t c = 0; c < count; c++) {
    for (int n = 0; n < 3; n++) sums_[n][c] = sum[n];
    const double r = classes.largest_radius(c) * map.scale;
    double term = static_cast<double>(classes.particles(c, c));
    for (double &s : sum) s += term *= r;
  }
  for (int n = 0; n < 3; n++) sums_[n][count] = sum[n];
}

WorkCost::Level WorkCost::level_of(const ClassRange &range) const {
  Level level{};
  level.range = range;
  const double largest = classes_.largest_radius(range.end - 1);
  const int64_t particles = classes_.particles(range.first, range.end - 1);
  level.particles = static_cast<double>(particles);
  level.largest_radius = largest * map_.scale;
  const LevelCells cells =
      lay_cells(map_, dimension_, interaction_.diameter(largest) * map_.scale, static_cast<size_t>(particles));
  level.row_width = static_cast<double>(cells.table.width[1]);
  level.cell_length = static_cast<double>(cells.table.width[0]);
  level.rows = static_cast<double>(cells.rows);
  double volume = 1, edge = 0;
  for (int axis = 0; axis < dimension_; axis++) {
    volume *= static_cast<double>(cells.table.width[axis]);
    edge = std::max(edge, static_cast<double>(cells.table.width[axis]));
  }
  const bool uneven = cells.widened && level.particles * density_.at(edge) * volume > kMostCompanions;
  if (uneven) {
    // As chunks of rows are laid.
    const double diameter = interaction_.diameter(largest) * map_.scale;
    level.row_width = std::max(kRowWidth * diameter, 1.0);
    level.cell_length = kCellLength * diameter;
    level.rows = level.particles;  // at most
  }
  return level;
}

void WorkCost::mean_powers(const Level &level, double slope, double beta, double *powers) const {
  double mean[3], power = 1;  // of slope rho
  for (int n = 0; n < 3; n++) {
    power *= slope;
    mean[n] = power * ((sums_[n][level.range.end] - sums_[n][level.range.first]) / level.particles);
  }
  powers[0] = 1;
  powers[1] = mean[0] + beta;
  powers[2] = mean[1] + beta * (2 * mean[0] + beta);
  powers[3] = mean[2] + beta * (3 * mean[1] + beta * (3 * mean[0] + beta));
}

// The rows that a ball of radius w meets, wherever it lies in a row, number 1 + 4u + pi u^2 on average, u = w / W: the
// area around a square of edge W up to the distance w, over W^2. The chords add up to the volume around that square,
// and each run is a cell longer than its chord on average. In two dimensions rows lie along a line.
void WorkCost::add_search(const Level &searcher, const Level &target, bool own, LevelWork &work) const {
  const SearchReach reach = interaction_.with_rule([&](auto rule) { return rule.towards(target.largest_radius, own); });
  double w[4];
  mean_powers(searcher, reach.slope, reach.offset + interaction_.margin * map_.scale, w);
  const double width = target.row_width, length = target.cell_length;
  double rows, volume;
  if (dimension_ == 3) {
    const double area = width * width + 4 * width * w[1] + kPi * w[2];
    rows = area / (width * width);
    volume = 2 * width * width * w[1] + 2 * kPi * width * w[2] + 4 * kPi / 3 * w[3] + length * area;
  } else {
    rows = 1 + 2 * w[1] / width;
    volume = 2 * width * w[1] + kPi * w[2] + length * (width + 2 * w[1]);
  }
  const double density = target.particles * density_.at(2 * w[1] + width);
  const double tests = std::min(volume * density, target.particles);
  const double share = searcher.particles / particles_;
  if (own) {
    // Rows are few here, and the same whatever the levels; half of the tests are met from the other side.
    work.tests += share * 0.5 * tests;
  } else {
    work.rows += share * std::min(rows, target.rows);
    work.tests += share * tests;
  }
}

LevelWork WorkCost::work(const LevelSplit &levels) const {
  Level laid[HG_MAX_LEVELS];
  LevelWork work;
  work.levels = levels.level_count;
  for (int h = 0; h < levels.level_count; h++) {
    laid[h] = level_of(levels.classes[h]);
    add_search(laid[h], laid[h], true, work);
    for (int finer = 0; finer < h; finer++) add_search(laid[h], laid[finer], false, work);
  }
  return work;
}

bool WorkCost::looked_enough(int level_count, double /*best*/, int dearer_in_a_row) const {
  constexpr int kDearerInARow = 3;  // numbers of levels after which the cost is not expected to fall again
  return dearer_in_a_row >= kDearerInARow || static_cast<size_t>(level_count) > classes_.count();
}

}  // namespace hg
