// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The state of all particles, in rows; what forces act on and the forces share a line of the cache. Arrays of effects
// that are off stay empty.
#pragma once

#include "dem/base/large_array.hpp"
#include "dem/base/row.hpp"
#include "dem/base/vector.hpp"
#include "dem/effects/effects.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dem {

// A velocity and what changes it.
template <class Real>
struct alignas(8 * sizeof(Real)) Course {
  Row<Real> speed, push;
};

template <int D, class Real>
struct Bodies {
  LargeArray<Row<Real>> places;    // centre and radius
  LargeArray<Course<Real>> moves;  // velocity and inverse mass (0: moves as at the start, whatever pushes); force
  LargeArray<Course<Real>> turns;  // spin; torque (friction only)
  std::vector<uint8_t> materials;  // (materials)

  static constexpr int kDimension = D, kSpin = Spin<D, Real>::RowsAtCompileTime;

  size_t count() const { return places.size(); }

  auto position(size_t i) { return places[i].template vector<D>(); }
  auto position(size_t i) const { return places[i].template vector<D>(); }
  auto velocity(size_t i) { return moves[i].speed.template vector<D>(); }
  auto velocity(size_t i) const { return moves[i].speed.template vector<D>(); }
  auto force(size_t i) { return moves[i].push.template vector<D>(); }
  auto force(size_t i) const { return moves[i].push.template vector<D>(); }
  auto spin(size_t i) { return turns[i].speed.template vector<kSpin>(); }
  auto spin(size_t i) const { return turns[i].speed.template vector<kSpin>(); }
  auto torque(size_t i) { return turns[i].push.template vector<kSpin>(); }
  auto torque(size_t i) const { return turns[i].push.template vector<kSpin>(); }
  Real &radius(size_t i) { return places[i].numbers[3]; }
  Real radius(size_t i) const { return places[i].numbers[3]; }
  Real &inverse_mass(size_t i) { return moves[i].speed.numbers[3]; }
  Real inverse_mass(size_t i) const { return moves[i].speed.numbers[3]; }
  bool rotating() const { return !turns.empty(); }

  void resize(size_t count, EffectSet effects) {
    places.resize(count);
    moves.resize(count);
    if (has(effects, kFriction)) turns.resize(count);
    if (has(effects, kMaterials)) materials.resize(count);
  }

  // Particle order[k] of these comes k-th; behind them is room for `more`, without forces and spins.
  Bodies reordered(const std::vector<uint32_t> &order, size_t more) const {
    Bodies result;
    const auto take = [&](const auto &rows, auto &taken) {
      if (rows.empty()) return;
      taken.reserve(order.size() + more);
      for (const uint32_t i : order) taken.push_back(rows[i]);
      taken.resize(order.size() + more);
    };
    take(places, result.places);
    take(moves, result.moves);
    take(turns, result.turns);
    take(materials, result.materials);
    return result;
  }

  size_t bytes() const {
    return sizeof(Row<Real>) * count() + sizeof(Course<Real>) * (moves.size() + turns.size()) + materials.size();
  }

  // 1 / I from 1 / m.
  Real inverse_inertia(size_t i) const { return Real(inverse_shape(D)) * inverse_mass(i) / (radius(i) * radius(i)); }
};

// All quantities under the names that they have in checkpoints: visit(name, count, width, numbers_of), where
// numbers_of(i) are those of particle i. What is written and what is read is one list.
template <class SomeBodies, class Visit>
void visit_quantities(SomeBodies &bodies, Visit visit) {
  const size_t count = bodies.count(), turning = bodies.turns.size();
  const auto width = static_cast<size_t>(bodies.kDimension), spin_width = static_cast<size_t>(bodies.kSpin);
  visit("position", count, width, [&](size_t i) { return bodies.places[i].numbers; });
  visit("velocity", count, width, [&](size_t i) { return bodies.moves[i].speed.numbers; });
  visit("force", count, width, [&](size_t i) { return bodies.moves[i].push.numbers; });
  visit("radius", count, size_t{1}, [&](size_t i) { return bodies.places[i].numbers + 3; });
  visit("inverse mass", count, size_t{1}, [&](size_t i) { return bodies.moves[i].speed.numbers + 3; });
  visit("spin", turning, spin_width, [&](size_t i) { return bodies.turns[i].speed.numbers; });
  visit("torque", turning, spin_width, [&](size_t i) { return bodies.turns[i].push.numbers; });
}

}  // namespace dem
