// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The box: which image of a partner a particle meets, and which walls it reaches.
#pragma once

#include "dem/base/vector.hpp"
#include "dem/setup/setup.hpp"

#include <hgrid/hgrid.h>

#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace dem {

// The nearest whole number, for |x| < 2^51 (float: 2^22): adding 3/2 of the largest power leaves no room for a
// fraction. std::nearbyint is a call of the C library on machines without an instruction for it.
template <class Real>
Real nearest_whole(Real x) {
  constexpr Real kWhole = std::is_same_v<Real, float> ? Real(0x1.8p23) : Real(0x1.8p52);
  return (x + kWhole) - kWhole;
}

template <int D, class Real>
struct Boundary {
  Vec<D, Real> low = Vec<D, Real>::Zero(), high = Vec<D, Real>::Zero();
  Vec<D, Real> period = Vec<D, Real>::Zero();          // 0 on axes that are not periodic
  Vec<D, Real> inverse_period = Vec<D, Real>::Zero();  // 0 there too
  Real offset = 0;                                     // Lees-Edwards: how far the images above have moved along x
  Real jump = 0;                                       // and how fast they move
  bool walled[D] = {};
  uint8_t materials[2 * D] = {};  // of the walls; one more than the last: none (materials)

  // Brings the separation of two particles to their nearest images; returns the speed along x that the second particle
  // gains with its image.
  template <EffectSet E>
  Real nearest(Vec<D, Real> &separation) const {
    Real speed = 0;
    if constexpr (has(E, kShear)) {
      const Real crossed = nearest_whole(separation[1] * inverse_period[1]);
      separation[0] -= crossed * offset;
      speed = -crossed * jump;
    }
    if constexpr (has(E, kPeriodic)) {
      for (int axis = 0; axis < D; axis++)
        separation[axis] -= period[axis] * nearest_whole(separation[axis] * inverse_period[axis]);
    }
    return speed;
  }
};

// Wall 2 a bounds axis a below, wall 2 a + 1 above.
constexpr int axis_of(int32_t wall) { return wall / 2; }
constexpr bool is_upper(int32_t wall) { return wall % 2 == 1; }

// How far a particle whose centre is at x on the wall's axis reaches beyond the wall. A centre behind the wall is still
// pushed back.
template <int D, class Real>
Real wall_overlap(const Boundary<D, Real> &boundary, Real x, Real radius, int32_t wall) {
  const int axis = axis_of(wall);
  return radius - (is_upper(wall) ? boundary.high[axis] - x : x - boundary.low[axis]);
}

template <int D, class Real>
Boundary<D, Real> make_boundary(const Setup &setup) {
  Boundary<D, Real> boundary;
  for (int wall = 0; wall < 2 * D; wall++) {
    const int material = setup.wall_materials[wall];
    boundary.materials[wall] = static_cast<uint8_t>(material < 0 ? setup.materials.size() : material);
  }
  for (int axis = 0; axis < D; axis++) {
    boundary.low[axis] = static_cast<Real>(setup.box_min[axis]);
    boundary.high[axis] = static_cast<Real>(setup.box_max[axis]);
    boundary.walled[axis] = setup.walled[axis];
    if (!setup.periodic[axis]) continue;
    const double length = setup.box_max[axis] - setup.box_min[axis];
    boundary.period[axis] = static_cast<Real>(length);
    boundary.inverse_period[axis] = static_cast<Real>(1 / length);
  }
  if (has(setup.effects, kShear)) {
    boundary.jump = static_cast<Real>(setup.shear_rate * (setup.box_max[1] - setup.box_min[1]));
  }
  return boundary;
}

// The planes a surface must pass to reach a wall; axes without walls have none.
template <int D, class Real>
struct WallReach {
  Vec<D, Real> low, high;

  // `range` is how far walls act beyond touching.
  WallReach(const Boundary<D, Real> &boundary, Real range) {
    constexpr Real kNever = std::numeric_limits<Real>::infinity();
    for (int axis = 0; axis < D; axis++) {
      const bool walled = boundary.walled[axis];
      low[axis] = walled ? boundary.low[axis] + range : -kNever;
      high[axis] = walled ? boundary.high[axis] - range : kNever;
    }
  }

  bool below(const Vec<D, Real> &x, Real r, int axis) const { return x[axis] - r < low[axis]; }
  bool above(const Vec<D, Real> &x, Real r, int axis) const { return x[axis] + r > high[axis]; }

  bool any(const Vec<D, Real> &x, Real r) const {
    bool reached = false;
    for (int axis = 0; axis < D; axis++) {  // no branch per plane
      reached |= below(x, r, axis);
      reached |= above(x, r, axis);
    }
    return reached;
  }

  // Inlined whatever the compiler thinks, else what a step costs depends on how many effects are built.
  [[gnu::always_inline]] void list(const Vec<D, Real> &x, Real r, size_t i, std::vector<hg_pair> &contacts) const {
    for (int axis = 0; axis < D; axis++) {
      if (below(x, r, axis)) contacts.push_back({static_cast<int32_t>(i), 2 * axis});
      if (above(x, r, axis)) contacts.push_back({static_cast<int32_t>(i), 2 * axis + 1});
    }
  }

  // Of bodies 0 .. count - 1.
  template <class Bodies>
  void list_all(const Bodies &bodies, size_t count, std::vector<hg_pair> &contacts) const {
    for (size_t i = 0; i < count; i++) {
      if (any(bodies.position(i), bodies.radius(i))) list(bodies.position(i), bodies.radius(i), i, contacts);
    }
  }
};

}  // namespace dem
