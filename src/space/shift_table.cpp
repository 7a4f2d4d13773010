// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/space/shift_table.hpp"

#include "src/space/shifts.hpp"

#include <algorithm>
#include <cmath>

namespace hg {
namespace {

// What reaches and lengths may be rounded by, and more.
constexpr double kScale = 1 + 0x1p-16, kSlack = 0x1p-20;

constexpr double kMostShifts = 4194304;  // 2^22

int32_t lowest_bits(double whole) { return static_cast<int32_t>(static_cast<uint32_t>(static_cast<int64_t>(whole))); }

bool fits_one_step(const Domain &domain, double reach) {
  for (int axis = 0; axis < domain.dimension; axis++) {
    if (domain.periodic[axis] && !(reach < domain.length[axis])) return false;
  }
  return !domain.is_tilted();
}

}  // namespace

void ShiftTable::list(const Domain &domain, const FixedPoint &map, double reach) {
  steps_by_one_ = fits_one_step(domain, reach * (1 + 0x1p-40));
  if (steps_by_one_) {
    list_steps();
  } else {
    list_near(domain, reach * kScale);
  }
  set_cell(domain, map);
}

// The forward ones first, so that each has its opposite however borders are rounded.
void ShiftTable::list_near(const Domain &domain, double reach) {
  PlaceBox box, around;
  for (int axis = 0; axis < domain.dimension; axis++) {
    box.high[axis] = domain.length[axis];
    const double slack = kSlack * domain.length[axis];
    around.low[axis] = -(reach + slack);
    around.high[axis] = domain.length[axis] + (reach + slack);
  }
  Image forward = 0;
  visit_shifts(domain, box, around, [&](const Shift &shift) {
    if (!is_forward(shift)) return;
    shift_.grow(forward + 1);
    shift_[forward++] = shift;
  });
  count_ = 2 * forward + 1;
  shift_.grow(count_);
  std::copy_backward(shift_.data(), shift_.data() + forward, shift_.data() + count_);
  shift_[middle()] = Shift{};
  for (Image image = 0; image < middle(); image++) shift_[image] = Shift{} - shift_[count_ - 1 - image];
}

void ShiftTable::list_steps() {
  count_ = kImages;
  shift_.require_room(kImages);
  for (Image image = 0; image < kImages; image++) {
    shift_[image] = {{image_step(image, 0), image_step(image, 1), image_step(image, 2)}};
  }
}

// Opposite shifts get opposite numbers in any rounding mode.
void ShiftTable::set_cell(const Domain &domain, const FixedPoint &map) {
  quanta_.require_room(count_);
  for (Image forward = middle(); forward < count_; forward++) {
    const Image backward = count_ - 1 - forward;
    for (int axis = 0; axis < 3; axis++) {
      const double place =
          axis < domain.dimension ? std::nearbyint(domain.shifted(axis, shift_[forward]) * map.scale) : 0;
      quanta_[forward].place[axis] = place;
      quanta_[forward].coordinate[axis] = lowest_bits(place);
      quanta_[backward].place[axis] = -place;
      quanta_[backward].coordinate[axis] = lowest_bits(-place);
    }
  }
}

double most_shifts(const Domain &domain, double reach) {
  double most = 1;
  for (int axis = 0; axis < domain.dimension; axis++) {
    if (domain.periodic[axis]) most *= 2 * (2 + reach / domain.length[axis]) + 1;
  }
  return most;
}

// The most edges that a shift has of one axis: large tilts of two axes multiply.
bool may_list(const Domain &domain, double reach) {
  double edges[3] = {0, 0, 0}, most = 0;
  for (int axis = domain.dimension - 1; axis >= 0; axis--) {
    if (!domain.periodic[axis]) continue;
    edges[axis] = 1 + 0x1p-10 + reach / domain.length[axis];
    for (int higher = axis + 1; higher < domain.dimension; higher++) {
      edges[axis] += edges[higher] * std::fabs(domain.tilt[kTiltOf[higher][axis]] / domain.length[axis]);
    }
    edges[axis] = std::floor(edges[axis]);
    most = std::max(most, edges[axis]);
  }
  return most <= kMaxTiltedWraps && most_shifts(domain, reach) <= kMostShifts;
}

}  // namespace hg
