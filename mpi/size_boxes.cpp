// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/size_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hgrid::mpi {
namespace {

// Where along a period, in 0 .. 1, the middle of the longest arc is that holds particles: opposite to the middle of the
// longest gap. Arcs are told apart by so many bins.
constexpr int kBins = 64;

double middle_of_arc(const std::array<bool, kBins> &occupied) {
  int best = 0, best_end = 0, run = 0;
  for (int k = 0; k < 2 * kBins; k++) {
    run = occupied[k % kBins] ? 0 : run + 1;
    if (run > best && run <= kBins) {
      best = run;
      best_end = k + 1;
    }
  }
  const double middle = (best_end - 0.5 * best) / kBins + 0.5;
  return middle - std::floor(middle);
}

// Moves places by whole edges of an axis to where their arc is in one piece; scales[k] grows by what was added.
void unroll(const Cell &cell, int axis, size_t count, double *places, double *scales) {
  const int d = cell.dimension();
  const auto turns = [&](size_t k) { return (places[k * d + axis] - cell.low(axis)) / cell.length(axis); };
  std::array<bool, kBins> occupied{};
  for (size_t k = 0; k < count; k++) {
    const double fraction = turns(k) - std::floor(turns(k));
    // Not a number if the quotient is infinite; the core refuses such a particle.
    occupied[fraction >= 0 ? std::min(kBins - 1, static_cast<int>(fraction * kBins)) : 0] = true;
  }
  const double middle = middle_of_arc(occupied);
  for (size_t k = 0; k < count; k++) {
    const double n = std::nearbyint(middle - turns(k));
    if (n != 0) scales[k] += cell.shift(places + k * d, axis, n);
  }
}

// The classes by the exponents of their radii, 0 apart.
class Classes {
 public:
  SizeBox &of(double radius, std::vector<SizeBox> &boxes) {
    int exponent = kLowest;
    if (radius > 0) (void)std::frexp(radius, &exponent);
    int &place = places_[static_cast<size_t>(exponent - kLowest)];
    if (place == 0) {
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      boxes.push_back({{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}, 0}, radius, radius});
      place = static_cast<int>(boxes.size());
    }
    return boxes[static_cast<size_t>(place) - 1];
  }

 private:
  static constexpr int kLowest = -1080;  // below the exponent of any double
  std::array<int, 1024 - kLowest + 1> places_{};
};

}  // namespace

std::vector<SizeBox> make_size_boxes(const Cell &cell, size_t count, const double *centers, const double *radii) {
  const auto d = static_cast<size_t>(cell.dimension());
  std::vector<double> places(centers, centers + count * d), scales(count);
  for (size_t k = 0; k < count; k++) {
    for (size_t axis = 0; axis < d; axis++) scales[k] += std::fabs(centers[k * d + axis]);
  }
  for (int axis = cell.dimension() - 1; axis >= 0; axis--) {
    if (cell.is_periodic(axis)) unroll(cell, axis, count, places.data(), scales.data());
  }
  std::vector<SizeBox> boxes;
  Classes classes;
  for (size_t k = 0; k < count; k++) {
    SizeBox &own = classes.of(radii[k], boxes);
    own.smallest = std::min(own.smallest, radii[k]);
    own.largest = std::max(own.largest, radii[k]);
    own.box.scale = std::max(own.box.scale, scales[k]);
    for (size_t axis = 0; axis < d; axis++) {
      own.box.low[axis] = std::min(own.box.low[axis], places[k * d + axis]);
      own.box.high[axis] = std::max(own.box.high[axis], places[k * d + axis]);
    }
  }
  return boxes;
}

double ReachRule::reach(double larger, double smaller) const {
  return (max_range_ ? larger : larger + smaller) + margin_ + skin_;
}

bool ReachRule::may_meet(const SizeBox &others, const double *center, double radius) const {
  if (others.smallest > radius) return false;
  return cell_.may_reach(others.box, center, reach(radius, std::min(radius, others.largest)));
}

bool ReachRule::may_meet(const SizeBox &others, const SizeBox &mine) const {
  // A place in one box is within reach of the other if the low corner of the first is within reach of the other box
  // grown by the extents of the first.
  if (others.smallest > mine.largest) return false;
  SizeBox grown = others;
  for (int axis = 0; axis < cell_.dimension(); axis++) {
    grown.box.low[axis] -= mine.box.high[axis] - mine.box.low[axis];
  }
  grown.box.scale += mine.box.scale + others.box.scale;
  return may_meet(grown, mine.box.low, mine.largest);
}

}  // namespace hgrid::mpi
