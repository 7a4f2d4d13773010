// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The power of everything that takes energy out of a simulation or puts it in.
#include "dem/engine/work.hpp"

#include "dem/effects/body_force.hpp"

#include <cmath>

namespace dem {
namespace {

// What a fixed particle or a wall that moves, or turns, does to the particle that touches it.
template <int D>
double push_of_fixed(const Snapshot &state, const ContactLoad<D> &load) {
  const Vec<D, double> force = load.force();
  if (load.b == ContactLoad<D>::kWall) {
    const double roll = load.reduced_radius * moment<D, double>(load.normal, load.resistance).dot(load.wall_spin);
    return force.dot(load.wall_velocity) + roll;
  }
  const auto push = [&](size_t fixed, double sign, double arm) {
    double power = sign * force.dot(vector_at<Vec<D, double>>(state.velocities, fixed));
    if (state.spins.empty()) return power;
    const Spin<D, double> spin = vector_at<Spin<D, double>>(state.spins, fixed);
    power -= arm * moment<D, double>(load.normal, load.tangential).dot(spin);
    return power + sign * load.reduced_radius * moment<D, double>(load.normal, load.resistance).dot(spin);
  };
  // The force is that on a: b does -(-F) . v, a -F . v.
  if (!std::isfinite(state.masses[load.b])) return push(load.b, 1, load.arm_b);
  if (!std::isfinite(state.masses[load.a])) return push(load.a, -1, load.arm_a);
  return 0;
}

}  // namespace

template <int D>
Work power_of(const Setup &setup, const Snapshot &lagging, const Snapshot &state,
              const std::vector<ContactLoad<D>> &loads) {
  Work power;
  for (const ContactLoad<D> &load : loads) {
    const SurfaceMotion<D> motion = surface_motion(state, load);
    power.dashpot += load.dashpot * motion.velocity.dot(load.normal);
    power.friction -= load.tangential.dot(motion.slip);
    power.rolling -= load.resistance.dot(motion.roll);
    power.input += load.force()[0] * load.image_speed + push_of_fixed(state, load);
  }
  for (size_t i = 0; i < state.count() && has(setup.effects, kDrag); i++) {
    if (!std::isfinite(state.masses[i])) continue;
    const auto seen = vector_at<Vec<D, double>>(lagging.velocities, i),
               now = vector_at<Vec<D, double>>(state.velocities, i);
    power.drag += drag_of(setup) * state.radii[i] * seen.dot(now);
  }
  return power;
}

template <int D>
Work without_springs(Work work, const std::vector<ContactLoad<D>> &loads) {
  for (const ContactLoad<D> &load : loads) {
    work.friction -= load.friction;
    work.rolling -= load.rolling;
  }
  return work;
}

template Work power_of(const Setup &, const Snapshot &, const Snapshot &, const std::vector<ContactLoad<2>> &);
template Work without_springs(Work, const std::vector<ContactLoad<2>> &);
template Work power_of(const Setup &, const Snapshot &, const Snapshot &, const std::vector<ContactLoad<3>> &);
template Work without_springs(Work, const std::vector<ContactLoad<3>> &);

}  // namespace dem
