// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What forces are computed with: vectors of two or three components; spins, a vector in three dimensions and one number
// in two; pi.
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace dem {

constexpr double kPi = 3.14159265358979323846;

// Of a sphere, or the area of a disc.
inline double volume_of_particle(double radius, int dimension) {
  return dimension == 2 ? kPi * radius * radius : 4 * kPi / 3 * radius * radius * radius;
}

// Without alignment, so that an array of them is the [count][D] array that the library takes.
template <int D, class Real>
using Vec = Eigen::Matrix<Real, D, 1, Eigen::DontAlign>;

template <int D, class Real>
using Spin = Eigen::Matrix<Real, D == 3 ? 3 : 1, 1, Eigen::DontAlign>;

// m r^2 / I of a ball, or a disc.
constexpr double inverse_shape(int dimension) { return dimension == 3 ? 2.5 : 2; }

// Unit vector and length of a separation. Centres that coincide are pushed apart along x, the first to the left.
template <int D, class Real>
Real normalize(const Vec<D, Real> &separation, Vec<D, Real> &direction) {
  const Real distance = std::sqrt(separation.squaredNorm());
  if (distance > 0) {
    direction = separation * (1 / distance);
  } else {
    direction = Vec<D, Real>::UnitX();
  }
  return distance;
}

// Vector i of those that stand in a row.
template <class Vector>
Eigen::Map<const Vector> vector_at(const std::vector<double> &numbers, size_t i) {
  return Eigen::Map<const Vector>(&numbers[i * Vector::RowsAtCompileTime]);
}

// spin x arm: the velocity of a point of a body at `arm` from its centre; and arm x force: the torque of a force that
// acts there. First in plain numbers, for loops over many contacts.
template <int D, class Real>
[[gnu::always_inline]] inline void turn_arm(const Real *spin, const Real *arm, Real *velocity) {
  if constexpr (D == 3) {
    velocity[0] = spin[1] * arm[2] - spin[2] * arm[1];
    velocity[1] = spin[2] * arm[0] - spin[0] * arm[2];
    velocity[2] = spin[0] * arm[1] - spin[1] * arm[0];
  } else {
    velocity[0] = -spin[0] * arm[1];
    velocity[1] = spin[0] * arm[0];
  }
}
template <int D, class Real>
[[gnu::always_inline]] inline void moment_of(const Real *arm, const Real *force, Real *torque) {
  if constexpr (D == 3) {
    turn_arm<3>(arm, force, torque);
  } else {
    torque[0] = arm[0] * force[1] - arm[1] * force[0];
  }
}

template <int D, class Real>
Vec<D, Real> turn(const Spin<D, Real> &spin, const Vec<D, Real> &arm) {
  Vec<D, Real> velocity;
  turn_arm<D>(spin.data(), arm.data(), velocity.data());
  return velocity;
}
template <int D, class Real>
Spin<D, Real> moment(const Vec<D, Real> &arm, const Vec<D, Real> &force) {
  Spin<D, Real> torque;
  moment_of<D>(arm.data(), force.data(), torque.data());
  return torque;
}

}  // namespace dem
