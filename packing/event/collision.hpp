// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// When two growing spheres meet, when one meets a wall or leaves its hull, and what a collision does (Lubachevsky &
// Stillinger 1990). Radii grow at a constant rate, centres move at constant velocity.
#pragma once

#include "packing/vector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace packing::event {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

// Surfaces part at least this much faster than they grow. With no excess, rounding would let a pair collide for ever.
inline constexpr double kLeastParting = 1 + 1e-3;

// The first tau >= 0 with |x + v tau| = sigma + a tau; kNever if there is none before `limit`, which only saves work.
// x, v: place and velocity of one centre relative to the other; sigma: sum of the radii; a >= 0: its growth rate.
// Spheres that touch or, by rounding, overlap meet at once if they approach.
inline double meeting_time(const Vector &x, const Vector &v, double sigma, double a, double limit = kNever) {
  // A tau^2 + 2 B tau + C = 0.
  const double b = dot(x, v) - sigma * a;
  const double aa = square(v) - a * a;
  if (b >= 0 && aa >= 0) return kNever;
  const double c = square(x) - sigma * sigma;
  if (b >= 0) {
    const double tau = (b + std::sqrt(std::max(b * b - aa * c, 0.0))) / -aa;
    if (tau < limit) return tau;
    return kNever;
  }
  if (c <= 0) return 0;
  // C / (-B + root) cancels nothing; the root is at most -B where A >= 0, which bounds tau from below.
  if (aa >= 0 && c >= -2 * b * limit) return kNever;
  const double discriminant = b * b - aa * c;
  if (discriminant < 0) return kNever;
  const double tau = c / (-b + std::sqrt(discriminant));
  if (tau < limit) return tau;
  return kNever;
}

// The time until a sphere reaches a wall: gap >= 0 between the surface and the wall, outward velocity of the centre,
// growth rate of the radius.
inline double wall_time(double gap, double outward, double growth) {
  const double closing = outward + growth;
  return closing > 0 ? std::max(gap, 0.0) / closing : kNever;
}

// The time until a sphere that grows at rate a leaves the hull around it: u from the hull's centre to its own, `room`
// the hull's radius minus its own now.
inline double exit_time(const Vector &u, const Vector &v, double room, double a) {
  // |u + v tau| = room - a tau.
  const double c = square(u) - room * room;
  if (c >= 0 || room <= 0) return 0;
  const double b = dot(u, v) + room * a;
  const double aa = square(v) - a * a;
  const double root = std::sqrt(std::max(b * b - aa * c, 0.0));
  if (b < 0) return (root - b) / aa;  // here a < |v|: only then can the sphere move away from the hull's surface
  return b + root > 0 ? -c / (b + root) : kNever;
}

// The impulse along the normal between two masses of reduced mass mu that part at the speed 2 a - v_n where they
// approached at v_n <= a: elastic in the frame of the growing surfaces. The kinetic energy rises by 2 mu a (a - v_n).
inline double pair_impulse(double mu, double v_n, double a) {
  return mu * (std::max(2 * a - v_n, a * kLeastParting) - v_n);
}

// The inward speed of a sphere after it met a wall with inward speed w.
inline double wall_rebound(double w, double growth) { return std::max(2 * growth - w, growth * kLeastParting); }

}  // namespace packing::event
