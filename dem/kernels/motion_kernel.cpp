// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The one pass over the particles in each step, row by row: a vector of four numbers each, of which the last, a radius
// or an inverse mass, is multiplied by 0 and so stays. No operation is fused, so all widths give the same bits.
#include "dem/kernels/motion_kernel.hpp"

#include "dem/base/vectors.hpp"
#include "dem/effects/choice.hpp"

namespace dem {
namespace {

template <EffectSet E, int D, class Real>
inline Vec<D, Real> acceleration_of(const Bodies<D, Real> &bodies, const BodyForce<D, Real> &body_force, size_t i) {
  return acceleration<E, D, Real>(body_force, bodies.force(i), bodies.velocity(i), bodies.radius(i),
                                  bodies.inverse_mass(i));
}

// One loop, inlined into a function for each width of vectors.
template <EffectSet E, int D, class Real>
[[gnu::always_inline]] inline Real move_rows(const MotionTask<D, Real> &task, size_t first, size_t last) {
  using Four = typename Row<Real>::Four;
  Row<Real> *places = task.bodies->places.data();
  Course<Real> *moves = task.bodies->moves.data();
  [[maybe_unused]] Course<Real> *turns = task.bodies->turns.data();
  const Four kick{task.kick, task.kick, task.kick, 0}, drift{task.drift, task.drift, task.drift, 0};
  [[maybe_unused]] Four gravity{};
  for (int axis = 0; axis < D; axis++) gravity[axis] = task.body_force.gravity[axis];
  Real fastest = 0, none = 0;
  for (size_t i = first; i < last; i++) {
    const Four place = places[i].four(), speed = moves[i].speed.four();
    const Real inverse_mass = speed[3];
    // As acceleration() has it.
    Four a = moves[i].push.four() * inverse_mass;
    if constexpr (has(E, kGravity)) a = inverse_mass > 0 ? a + gravity : a;
    if constexpr (has(E, kDrag)) a -= (task.body_force.drag * place[3] * inverse_mass) * speed;
    const Four v = speed + kick * a, square = v * v;
    const Real sum = square[0] + square[1] + square[2];
    moves[i].speed.four() = v;
    moves[i].push.four() = Four{};
    places[i].four() = place + drift * v;
    fastest = sum > fastest ? sum : fastest;
    none += sum - sum;  // 0 of a number
    if constexpr (has(E, kFriction)) {
      const Real turned = task.kick * (Real(inverse_shape(D)) * inverse_mass / (place[3] * place[3]));
      turns[i].speed.four() += turned * turns[i].push.four();
      turns[i].push.four() = Four{};
    }
  }
  return fastest + none;
}

template <EffectSet E, int D, class Real>
Real move_plain(const MotionTask<D, Real> &task, size_t first, size_t last) {
  return move_rows<E>(task, first, last);
}

#ifdef DEM_HAS_VECTORS
template <EffectSet E, int D, class Real>
DEM_AVX2 Real move_wide(const MotionTask<D, Real> &task, size_t first, size_t last) {
  return move_rows<E>(task, first, last);
}
#endif

}  // namespace

template <int D, class Real>
MotionKernel<D, Real> find_motion_kernel(EffectSet effects) {
#ifdef DEM_HAS_VECTORS
  if (usable_vectors() != Vectors::kPlain)
    return choose<kMotionEffects, Real>(effects, [](auto set) { return &move_wide<decltype(set)::value, D, Real>; });
#endif
  return choose<kMotionEffects, Real>(effects, [](auto set) { return &move_plain<decltype(set)::value, D, Real>; });
}

template <int D, class Real>
AccelerationKernel<D, Real> find_acceleration(EffectSet effects) {
  return choose<kBodyEffects, Real>(effects, [](auto set) { return &acceleration_of<decltype(set)::value, D, Real>; });
}

#define DEM_INSTANTIATE(D, Real)                                \
  template MotionKernel<D, Real> find_motion_kernel(EffectSet); \
  template AccelerationKernel<D, Real> find_acceleration(EffectSet);

DEM_INSTANTIATE(2, double)
DEM_INSTANTIATE(3, double)
DEM_INSTANTIATE(2, float)
DEM_INSTANTIATE(3, float)

}  // namespace dem
