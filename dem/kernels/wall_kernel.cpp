// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Forces of the box's walls on the particles that reach them.
#include "dem/kernels/wall_kernel.hpp"

#include "dem/effects/built_effects.hpp"

#include <array>
#include <utility>

namespace dem {
namespace {

template <EffectSet E, int D, class Real>
void wall_force(const WallTask<D, Real> &task, size_t p) {
  Bodies<D, Real> &bodies = *task.bodies;
  const int32_t wall = task.contacts[p].b;
  const auto i = static_cast<size_t>(task.contacts[p].a);
  Contact<D, Real> contact;
  contact.normal = Vec<D, Real>::Zero();
  contact.normal[axis_of(wall)] = is_upper(wall) ? Real(1) : Real(-1);
  contact.meeting.overlap = wall_overlap(*task.boundary, bodies.position[i][axis_of(wall)], bodies.radius[i], wall);
  if constexpr (has(E, kDissipation)) contact.meeting.inverse_mass = bodies.inverse_mass[i];
  if constexpr (has(E, kHertz) || has(E, kRolling)) contact.meeting.inverse_radius = 1 / bodies.radius[i];
  if constexpr (has(E, kDissipation) || has(E, kFriction)) contact.velocity = bodies.velocity[i];
  if constexpr (has(E, kFriction)) {
    const Real arm = bodies.radius[i] - contact.meeting.overlap;
    const Spin<D, Real> turning = arm * bodies.spin[i];
    contact.surface_velocity = contact.velocity + turn<D, Real>(turning, contact.normal);
    contact.step = task.step;
    contact.slip = task.slip + p;
    if constexpr (has(E, kRolling)) {
      contact.spin = bodies.spin[i];
      contact.roll = task.roll + p;
    }
    const Effort<D, Real> effort = contact_effort<E>(*task.law, contact);
    bodies.force[i] += effort.force;
    bodies.torque[i] += arm * effort.moment;
    if constexpr (has(E, kRolling)) bodies.torque[i] += effort.rolling;
  } else {
    bodies.force[i] += contact_effort<E>(*task.law, contact).force;
  }
}

template <EffectSet E, int D, class Real>
void wall_forces(const WallTask<D, Real> &task, size_t first, size_t last) {
  for (size_t p = first; p < last; p++) wall_force<E>(task, p);
}

template <EffectSet E, int D, class Real>
constexpr WallKernel<D, Real> wall_kernel_or_null() {
  if constexpr (is_possible(E) && is_built<Real>(E)) {
    return &wall_forces<E, D, Real>;
  } else {
    return nullptr;
  }
}

template <int D, class Real, EffectSet... laws>
WallKernel<D, Real> pick(EffectSet law, std::integer_sequence<EffectSet, laws...>) {
  static constexpr std::array<WallKernel<D, Real>, sizeof...(laws)> kTable = {wall_kernel_or_null<laws, D, Real>()...};
  return kTable[law];
}

}  // namespace

template <int D, class Real>
WallKernel<D, Real> find_wall_kernel(EffectSet effects) {
  require_possible(effects);
  const EffectSet law = effects & kLawEffects;
  const WallKernel<D, Real> kernel = pick<D, Real>(law, std::make_integer_sequence<EffectSet, kLawEffects + 1>());
  if (kernel == nullptr) refuse_unbuilt(law | kWalls);
  return kernel;
}

template WallKernel<2, double> find_wall_kernel(EffectSet);
template WallKernel<3, double> find_wall_kernel(EffectSet);
template WallKernel<2, float> find_wall_kernel(EffectSet);
template WallKernel<3, float> find_wall_kernel(EffectSet);

}  // namespace dem
