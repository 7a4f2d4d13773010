// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The box, and which image of a partner a particle meets.
#pragma once

#include "dem/base/vector.hpp"
#include "dem/setup/setup.hpp"

#include <cstdint>
#include <type_traits>

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
      for (int k = 0; k < D; k++) separation[k] -= period[k] * nearest_whole(separation[k] * inverse_period[k]);
    }
    return speed;
  }
};

// Wall 2k bounds axis k below, wall 2k + 1 above.
constexpr int axis_of(int32_t wall) { return wall / 2; }
constexpr bool is_upper(int32_t wall) { return wall % 2 == 1; }

// How far a particle whose centre is at x on the wall's axis reaches beyond the wall. A centre behind the wall is still
// pushed back.
template <int D, class Real>
Real wall_overlap(const Boundary<D, Real> &boundary, Real x, Real radius, int32_t wall) {
  const int k = axis_of(wall);
  return radius - (is_upper(wall) ? boundary.high[k] - x : x - boundary.low[k]);
}

template <int D, class Real>
Boundary<D, Real> make_boundary(const Setup &setup) {
  Boundary<D, Real> boundary;
  for (int k = 0; k < D; k++) {
    boundary.low[k] = static_cast<Real>(setup.box_min[k]);
    boundary.high[k] = static_cast<Real>(setup.box_max[k]);
    boundary.walled[k] = setup.walled[k];
    if (!setup.periodic[k]) continue;
    const double length = setup.box_max[k] - setup.box_min[k];
    boundary.period[k] = static_cast<Real>(length);
    boundary.inverse_period[k] = static_cast<Real>(1 / length);
  }
  if (has(setup.effects, kShear)) {
    boundary.jump = static_cast<Real>(setup.shear_rate * (setup.box_max[1] - setup.box_min[1]));
  }
  return boundary;
}

}  // namespace dem
