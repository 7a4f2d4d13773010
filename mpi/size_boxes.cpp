// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "mpi/size_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace hgrid::mpi {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

SizeBox empty_box(double smallest, double largest) {
  return {{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}, 0}, smallest, largest};
}

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
  const double low = cell.low(axis), per_length = 1 / cell.length(axis);
  // Rounded: any whole number of edges is right, the nearest one is best.
  const auto turns = [&](size_t k) { return (places[3 * k + static_cast<size_t>(axis)] - low) * per_length; };
  std::array<bool, kBins> occupied{};
  for (size_t k = 0; k < count; k++) {
    const double turn = turns(k), fraction = turn >= 0 && turn < 1 ? turn : turn - std::floor(turn);
    // Not a number if the product is infinite; the core refuses such a particle.
    occupied[fraction >= 0 ? std::min(kBins - 1, static_cast<int>(fraction * kBins)) : 0] = true;
  }
  const double middle = middle_of_arc(occupied);
  for (size_t k = 0; k < count; k++) {
    const double from_middle = middle - turns(k);
    if (from_middle >= -0.5 && from_middle <= 0.5) continue;
    scales[k] += cell.shift(places + 3 * k, axis, std::nearbyint(from_middle));
  }
}

// The numbers of classes by the exponents of their radii, as the bits of doubles have them: 0 among those that have
// no exponent of their own.
class ClassNumbers {
 public:
  // Adds a box for a class that is new.
  uint16_t of(double radius, std::vector<SizeBox> &boxes) {
    uint64_t bits = 0;
    std::memcpy(&bits, &radius, sizeof bits);
    uint16_t &number = numbers_[bits >> 52 & 0x7ff];
    if (number == 0) {
      boxes.push_back(empty_box(radius, radius));
      number = static_cast<uint16_t>(boxes.size());
    }
    return static_cast<uint16_t>(number - 1);
  }

 private:
  std::array<uint16_t, 0x800> numbers_{};  // from 1 on
};

}  // namespace

SizeClasses make_size_classes(const Cell &cell, size_t count, const double *centers, const double *radii) {
  const auto d = static_cast<size_t>(cell.dimension());
  SizeClasses classes{{}, std::vector<uint16_t>(count), std::vector<double>(3 * count)};
  std::vector<double> scales(count);
  for (size_t k = 0; k < count; k++) {
    for (size_t axis = 0; axis < d; axis++) {
      classes.places[3 * k + axis] = centers[k * d + axis];
      scales[k] += std::fabs(centers[k * d + axis]);
    }
  }
  for (int axis = cell.dimension() - 1; axis >= 0; axis--) {
    if (cell.is_periodic(axis)) unroll(cell, axis, count, classes.places.data(), scales.data());
  }
  ClassNumbers numbers;
  for (size_t k = 0; k < count; k++) {
    classes.class_of[k] = numbers.of(radii[k], classes.boxes);
    SizeBox &own = classes.boxes[classes.class_of[k]];
    own.smallest = std::min(own.smallest, radii[k]);
    own.largest = std::max(own.largest, radii[k]);
    own.box.scale = std::max(own.box.scale, scales[k]);
    for (size_t axis = 0; axis < 3; axis++) {
      own.box.low[axis] = std::min(own.box.low[axis], classes.places[3 * k + axis]);
      own.box.high[axis] = std::max(own.box.high[axis], classes.places[3 * k + axis]);
    }
  }
  return classes;
}

SizeBox box_around(const SizeBox *boxes, size_t count) {
  SizeBox whole = empty_box(kInfinity, -kInfinity);
  for (const SizeBox *one = boxes; one != boxes + count; one++) {
    whole.smallest = std::min(whole.smallest, one->smallest);
    whole.largest = std::max(whole.largest, one->largest);
    whole.box.scale = std::max(whole.box.scale, one->box.scale);
    for (int axis = 0; axis < 3; axis++) {
      whole.box.low[axis] = std::min(whole.box.low[axis], one->box.low[axis]);
      whole.box.high[axis] = std::max(whole.box.high[axis], one->box.high[axis]);
    }
  }
  return whole;
}

}  // namespace hgrid::mpi
