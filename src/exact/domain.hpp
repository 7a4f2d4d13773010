// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The space that particles live in: which axes are periodic, and where a position lies in the box. A tilted cell, too,
// is searched as a right-angled box: moved by whole edges a, b and c, the box fills space as well as the cell does.
#pragma once

#include "src/base/arithmetic.hpp"

#include <cmath>
#include <cstdint>

namespace hg {

// A particle may lie this many box lengths outside a periodic axis: up to there, wrapping is off by less than
// 3 * 2^-33 box lengths, less than half the resolution of the search (space/fixed_point.hpp). In a tilted cell the sum
// of all that is taken off an axis must be shorter, as more is rounded.
inline constexpr double kMaxWraps = 1048576.0;       // 2^20
inline constexpr double kMaxTiltedWraps = 524288.0;  // 2^19

// How many box lengths a place `above` the low face of a periodic axis lies above the box: 0 in the box, -1 below its
// low face. Next to the box that is a matter of comparing, whatever the host's rounding mode makes of a quotient.
// Kernels of all instruction sets compile their own copy, hence `static`.
static inline double boxes_above(double above, double length) {
  if (above < -length || above >= 2 * length) return std::floor(above / length);
  return above < 0 ? -1 : (above < length ? 0 : 1);
}

static inline double cut_to_box(double inside, double length) {
  return inside < 0 ? 0 : (inside > length ? length : inside);
}

// The place of x above `low` on a periodic axis of that length, in [0, length]. Going back to absolute coordinates
// would lose digits in a box far from the origin.
static inline double place_in_box(double x, double low, double length) {
  const double above = x - low;
  return cut_to_box(above - boxes_above(above, length) * length, length);
}

// The same without a division, for x at most one box length outside the box.
static inline double near_place_in_box(double x, double low, double length) {
  const double above = x - low;
  return above + (above < 0 ? length : (above < length ? 0 : -length));
}
// True if all x in [least, greatest] are that near.
static inline bool are_near_box(double least, double greatest, double low, double length) {
  return least - low >= -length && greatest - low < 2 * length;
}

// The entry of a tilt between two axes, the higher first: xy, xz, yz.
inline constexpr int kTiltOf[3][3] = {{-1, -1, -1}, {0, -1, -1}, {1, 2, -1}};

// Takes a place `above` the low faces of the periodic cell, whose edges are (lx, 0, 0), (xy, ly, 0) and (xz, yz, lz),
// to its place in the box: whole edges are taken off from the last to the first, so that each may move what is left on
// the axes before it. `boxes` become their numbers. Lengths are 0 on open axes, which stay as they are.
static inline void take_into_box(double *above, double *boxes, const double *length, const double *tilt,
                                 int dimension) {
  for (int axis = 2; axis >= 0; axis--) {
    if (axis >= dimension) continue;
    boxes[axis] = 0;
    if (!(length[axis] > 0)) continue;
    boxes[axis] = boxes_above(above[axis], length[axis]);
    above[axis] = cut_to_box(above[axis] - boxes[axis] * length[axis], length[axis]);
    for (int lower = 0; lower < axis; lower++) above[lower] -= boxes[axis] * tilt[kTiltOf[axis][lower]];
  }
}

// Whole edges a, b and c of the periodic cell.
struct Shift {
  int32_t n[3] = {0, 0, 0};
  bool is_none() const { return n[0] == 0 && n[1] == 0 && n[2] == 0; }
};
// The last edge that is taken at all is taken forward.
inline bool is_forward(const Shift &shift) {
  for (int axis = 2; axis >= 0; axis--) {
    if (shift.n[axis] != 0) return shift.n[axis] > 0;
  }
  return false;
}
inline Shift operator+(const Shift &s, const Shift &t) { return {{s.n[0] + t.n[0], s.n[1] + t.n[1], s.n[2] + t.n[2]}}; }
inline Shift operator-(const Shift &s, const Shift &t) { return {{s.n[0] - t.n[0], s.n[1] - t.n[1], s.n[2] - t.n[2]}}; }

struct Domain {
  int dimension = 3;
  bool any_periodic = false;
  bool periodic[3] = {false, false, false};
  double box_min[3] = {0, 0, 0};
  double box_max[3] = {0, 0, 0};
  double length[3] = {0, 0, 0};  // box_max - box_min, rounded; 0 where no box is given
  double tilt[3] = {0, 0, 0};    // xy, xz, yz
  bool all_images = false;       // each image in reach is a pair, not the nearest alone

  bool is_tilted() const { return tilt[0] != 0 || tilt[1] != 0 || tilt[2] != 0; }
  double period(int axis) const { return periodic[axis] ? length[axis] : 0; }

  // How many box lengths x lies above the box, on an axis that no tilt moves.
  double wraps(int axis, double x) const { return periodic[axis] ? boxes_above(x - box_min[axis], length[axis]) : 0; }

  // How far outside the box a centre lies, and on which axis: the most box lengths that take_in takes off, tilts
  // counted as they come. Up to most_outside() is allowed.
  struct Outside {
    int axis;
    double boxes;
  };
  Outside outside(const double *center) const {
    double above[3] = {0, 0, 0}, size[3] = {0, 0, 0};
    Outside most{0, 0};
    for (int axis = 0; axis < dimension; axis++) {
      above[axis] = periodic[axis] ? center[axis] - box_min[axis] : 0;
      size[axis] = std::fabs(above[axis]);
    }
    for (int axis = 2; axis >= 0; axis--) {
      if (axis >= dimension || !periodic[axis]) continue;
      const double boxes = boxes_above(above[axis], length[axis]);
      const double outside = is_tilted() ? size[axis] / length[axis] : std::fabs(boxes);
      if (!(outside <= most.boxes)) most = {axis, outside};
      for (int lower = 0; lower < axis; lower++) {
        above[lower] -= boxes * tilt[kTiltOf[axis][lower]];
        size[lower] += std::fabs(boxes * tilt[kTiltOf[axis][lower]]);
      }
    }
    return most;
  }
  double most_outside() const { return is_tilted() ? kMaxTiltedWraps : kMaxWraps; }

  // Where the search sees a centre: on periodic axes its place in the box, above its low face. Returns the edges that
  // were taken off.
  Shift take_in(const double *center, double *place) const {
    double boxes[3] = {0, 0, 0};
    const double periods[3] = {period(0), period(1), period(2)};
    for (int axis = 0; axis < dimension; axis++) {
      place[axis] = periodic[axis] ? center[axis] - box_min[axis] : center[axis];
    }
    take_into_box(place, boxes, periods, tilt, dimension);
    return {{static_cast<int32_t>(boxes[0]), static_cast<int32_t>(boxes[1]), static_cast<int32_t>(boxes[2])}};
  }
  Shift boxes(const double *center) const {
    if (!any_periodic) return {};
    double place[3];
    return take_in(center, place);
  }

  // n_a a + n_b b + n_c c on one axis, and the sum of the sizes of its terms.
  double shifted(int axis, const Shift &shift) const {
    double sum = shift.n[axis] * length[axis];
    for (int higher = axis + 1; higher < 3; higher++) sum += shift.n[higher] * tilt[kTiltOf[higher][axis]];
    return sum;
  }
  double shift_size(int axis, const Shift &shift) const {
    double sum = std::fabs(shift.n[axis] * length[axis]);
    for (int higher = axis + 1; higher < 3; higher++) {
      sum += std::fabs(shift.n[higher] * tilt[kTiltOf[higher][axis]]);
    }
    return sum;
  }
};

// Which periodic image of a particle is meant: a number in a table of shifts (space/shift_table.hpp). In that of all
// steps by -1, 0 or +1, which most boxes have, they are packed in base 3.
using Image = uint32_t;
inline constexpr Image kNoImage = ~Image{0};
inline constexpr Image kImages = 27;

inline Image make_image(int x, int y, int z) { return static_cast<Image>((x + 1) + 3 * (y + 1) + 9 * (z + 1)); }
inline int image_step(Image image, int axis) {
  const Image divisor = axis == 0 ? 1 : (axis == 1 ? 3 : 9);
  return static_cast<int>(image / divisor % 3) - 1;
}

// Images as bits. Forward are those whose step is positive on the last axis with a step.
using ImageSet = int32_t;
inline constexpr ImageSet kBackwardImages = (1 << kImages / 2) - 1;
inline constexpr ImageSet kForwardImages = kBackwardImages << (kImages / 2 + 1);
// By axis and step + 1. A digit has the three steps along x, three digits those along y.
inline constexpr ImageSet kImagesWithStep[3][3] = {
    {0111111111, 0222222222, 0444444444}, {0007007007, 0070070070, 0700700700}, {0000000777, 0000777000, 0777000000}};

}  // namespace hg
