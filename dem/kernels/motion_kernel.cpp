// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The one pass over the particles in each step.
#include "dem/kernels/motion_kernel.hpp"

#include "dem/effects/built_effects.hpp"
#include "dem/state/wall_reach.hpp"

#include <array>
#include <utility>

namespace dem {
namespace {

template <EffectSet E, int D, class Real>
void move_bodies(const MotionTask<D, Real> &task, size_t first, size_t last, std::vector<hg_pair> &wall_contacts) {
  Bodies<D, Real> &bodies = *task.bodies;
  [[maybe_unused]] const WallReach<D, Real> reach(*task.boundary, task.wall_range);
  for (size_t i = first; i < last; i++) {
    Vec<D, Real> a = acceleration<E>(bodies, task.gravity, i);
    if constexpr (has(E, kDrag)) a -= (task.drag * bodies.radius[i] * bodies.inverse_mass[i]) * bodies.velocity[i];
    const Vec<D, Real> v = bodies.velocity[i] + task.kick * a;
    const Vec<D, Real> x = bodies.position[i] + task.drift * v;
    bodies.velocity[i] = v;
    bodies.position[i] = x;
    bodies.force[i].setZero();
    if constexpr (has(E, kFriction)) {
      bodies.spin[i] += (task.kick * bodies.inverse_inertia(i)) * bodies.torque[i];
      bodies.torque[i].setZero();
    }
    if constexpr (has(E, kWalls)) {
      if (reach.any(x, bodies.radius[i])) reach.list(x, bodies.radius[i], i, wall_contacts);
    }
  }
}

// The effects of motion are spread over the bits of EffectSet; here they are numbered densely.
constexpr Effect kMotionBits[] = {kFriction, kWalls, kGravity, kDrag};
constexpr unsigned kMotionSets = 16;

constexpr EffectSet effects_of_number(unsigned number) {
  EffectSet set = 0;
  for (unsigned bit = 0; bit < 4; bit++) {
    if ((number >> bit & 1u) != 0) set |= kMotionBits[bit];
  }
  return set;
}

template <EffectSet E, int D, class Real>
constexpr MotionKernel<D, Real> motion_kernel_or_null() {
  if constexpr (is_built<Real>(E)) {
    return &move_bodies<E, D, Real>;
  } else {
    return nullptr;
  }
}

template <int D, class Real, unsigned... numbers>
MotionKernel<D, Real> pick(EffectSet effects, std::integer_sequence<unsigned, numbers...>) {
  MotionKernel<D, Real> kernel = nullptr;
  ((effects_of_number(numbers) == effects ? void(kernel = motion_kernel_or_null<effects_of_number(numbers), D, Real>())
                                          : void()),
   ...);
  return kernel;
}

}  // namespace

template <int D, class Real>
MotionKernel<D, Real> find_motion_kernel(EffectSet effects) {
  const EffectSet motion = effects & kMotionEffects;
  const MotionKernel<D, Real> kernel = pick<D, Real>(motion, std::make_integer_sequence<unsigned, kMotionSets>());
  if (kernel == nullptr) refuse_unbuilt(motion);
  return kernel;
}

template MotionKernel<2, double> find_motion_kernel(EffectSet);
template MotionKernel<3, double> find_motion_kernel(EffectSet);
template MotionKernel<2, float> find_motion_kernel(EffectSet);
template MotionKernel<3, float> find_motion_kernel(EffectSet);

}  // namespace dem
