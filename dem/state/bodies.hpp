// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The state of all particles, one array per quantity; arrays of effects that are off stay empty.
#pragma once

#include "dem/base/vector.hpp"
#include "dem/effects/effects.hpp"

#include <cstddef>
#include <vector>

namespace dem {

template <int D, class Real>
struct Bodies {
  std::vector<Vec<D, Real>> position, velocity, force;
  std::vector<Real> radius;
  std::vector<Real> inverse_mass;           // 0: moves as it did at the start, whatever pushes
  std::vector<Spin<D, Real>> spin, torque;  // friction only

  size_t count() const { return radius.size(); }

  void resize(size_t count, EffectSet effects) {
    const Vec<D, Real> zero = Vec<D, Real>::Zero();
    position.resize(count, zero);
    velocity.resize(count, zero);
    force.resize(count, zero);
    radius.resize(count);
    inverse_mass.resize(count);
    if (has(effects, kFriction)) {
      const Spin<D, Real> still = Spin<D, Real>::Zero();
      spin.resize(count, still);
      torque.resize(count, still);
    }
  }

  size_t bytes() const {
    size_t sum = 0;
    visit_arrays(*this, [&](const char *, const auto &array) { sum += sizeof array[0] * array.size(); });
    return sum;
  }

  // 1 / I from 1 / m.
  Real inverse_inertia(size_t i) const { return Real(inverse_shape(D)) * inverse_mass[i] / (radius[i] * radius[i]); }
};

// All arrays under the names that they have in checkpoints: what is written and what is read is one list.
template <class SomeBodies, class Visit>
void visit_arrays(SomeBodies &bodies, Visit visit) {
  visit("position", bodies.position);
  visit("velocity", bodies.velocity);
  visit("force", bodies.force);
  visit("radius", bodies.radius);
  visit("inverse mass", bodies.inverse_mass);
  visit("spin", bodies.spin);
  visit("torque", bodies.torque);
}

}  // namespace dem
