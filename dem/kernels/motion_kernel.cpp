// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The one pass over the particles in each step.
#include "dem/kernels/motion_kernel.hpp"

#include "dem/effects/choice.hpp"

namespace dem {
namespace {

template <EffectSet E, int D, class Real>
inline Vec<D, Real> acceleration_of(const Bodies<D, Real> &bodies, const BodyForce<D, Real> &body_force, size_t i) {
  return acceleration<E, D, Real>(body_force, bodies.force(i), bodies.velocity(i), bodies.radius(i),
                                  bodies.inverse_mass(i));
}

template <EffectSet E, int D, class Real>
Real move_bodies(const MotionTask<D, Real> &task, size_t first, size_t last) {
  Bodies<D, Real> &bodies = *task.bodies;
  Real fastest = 0, none = 0;
  for (size_t i = first; i < last; i++) {
    const Vec<D, Real> a = acceleration_of<E>(bodies, task.body_force, i);
    const Vec<D, Real> v = bodies.velocity(i) + task.kick * a;
    const Real speed = v.squaredNorm();
    bodies.velocity(i) = v;
    bodies.position(i) += task.drift * v;
    bodies.force(i).setZero();
    fastest = speed > fastest ? speed : fastest;
    none += speed - speed;  // 0 of a number
    if constexpr (has(E, kFriction)) {
      bodies.spin(i) += (task.kick * bodies.inverse_inertia(i)) * bodies.torque(i);
      bodies.torque(i).setZero();
    }
  }
  return fastest + none;
}

}  // namespace

template <int D, class Real>
MotionKernel<D, Real> find_motion_kernel(EffectSet effects) {
  return choose<kMotionEffects, Real>(effects, [](auto set) { return &move_bodies<decltype(set)::value, D, Real>; });
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
