// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The state of all particles. What belongs together in the loops stands together: rows of four numbers, a vector and
// one number beside it. Arrays of effects that are off stay empty.
#pragma once

#include "dem/base/vector.hpp"
#include "dem/effects/effects.hpp"

#include <cstddef>
#include <vector>

namespace dem {

// In two dimensions the third number is 0.
template <class Real>
struct alignas(4 * sizeof(Real)) Row {
  Real numbers[4];

  template <int D>
  Eigen::Map<Vec<D, Real>> vector() {
    return Eigen::Map<Vec<D, Real>>(numbers);
  }
  template <int D>
  Eigen::Map<const Vec<D, Real>> vector() const {
    return Eigen::Map<const Vec<D, Real>>(numbers);
  }
};

template <int D, class Real>
struct Bodies {
  std::vector<Row<Real>> places;            // centre and radius
  std::vector<Row<Real>> motions;           // velocity and inverse mass; 0: moves as at the start, whatever pushes
  std::vector<Row<Real>> forces;            // and 0
  std::vector<Spin<D, Real>> spin, torque;  // friction only

  size_t count() const { return places.size(); }

  auto position(size_t i) { return places[i].template vector<D>(); }
  auto position(size_t i) const { return places[i].template vector<D>(); }
  auto velocity(size_t i) { return motions[i].template vector<D>(); }
  auto velocity(size_t i) const { return motions[i].template vector<D>(); }
  auto force(size_t i) { return forces[i].template vector<D>(); }
  auto force(size_t i) const { return forces[i].template vector<D>(); }
  Real &radius(size_t i) { return places[i].numbers[3]; }
  Real radius(size_t i) const { return places[i].numbers[3]; }
  Real &inverse_mass(size_t i) { return motions[i].numbers[3]; }
  Real inverse_mass(size_t i) const { return motions[i].numbers[3]; }

  void resize(size_t count, EffectSet effects) {
    places.resize(count);
    motions.resize(count);
    forces.resize(count);
    if (has(effects, kFriction)) {
      const Spin<D, Real> still = Spin<D, Real>::Zero();
      spin.resize(count, still);
      torque.resize(count, still);
    }
  }

  size_t bytes() const {
    return sizeof(Row<Real>) * 3 * count() + sizeof(Spin<D, Real>) * (spin.size() + torque.size());
  }

  // 1 / I from 1 / m.
  Real inverse_inertia(size_t i) const { return Real(inverse_shape(D)) * inverse_mass(i) / (radius(i) * radius(i)); }
};

// The quantities that stand in rows, as checkpoints hold them, by name: visit(name, rows, first, width) for `width`
// numbers of each row from `first` on. What is written and what is read is one list.
template <int D, class SomeRows, class Visit>
void visit_columns(SomeRows &places, SomeRows &motions, SomeRows &forces, Visit visit) {
  visit("position", places, size_t{0}, size_t{D});
  visit("velocity", motions, size_t{0}, size_t{D});
  visit("force", forces, size_t{0}, size_t{D});
  visit("radius", places, size_t{3}, size_t{1});
  visit("inverse mass", motions, size_t{3}, size_t{1});
}

}  // namespace dem
