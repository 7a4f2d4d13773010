// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The power of everything that takes energy out of a simulation or puts it in.
#include "dem/engine/work.hpp"

#include "dem/effects/body_force.hpp"

#include <cmath>

namespace dem {

template <int D>
PowerMeasure<D>::PowerMeasure(const Setup &setup, const Snapshot &lagging, const Snapshot &state)
    : setup_(setup), lagging_(lagging), state_(state) {}

// What a fixed particle or a wall that moves, or turns, does to the particle that touches it.
template <int D>
double PowerMeasure<D>::push_of_fixed(const ContactLoad<D> &load) const {
  const Vec<D, double> force = load.force();
  if (load.b == ContactLoad<D>::kWall) {
    const double roll = load.reduced_radius * moment<D, double>(load.normal, load.resistance).dot(load.wall_spin);
    return force.dot(load.wall_velocity) + roll;
  }
  const auto push = [&](size_t fixed, double sign, double arm) {
    double power = sign * force.dot(vector_at<Vec<D, double>>(state_.velocities, fixed));
    if (state_.spins.empty()) return power;
    const Spin<D, double> spin = vector_at<Spin<D, double>>(state_.spins, fixed);
    power -= arm * moment<D, double>(load.normal, load.tangential).dot(spin);
    return power + sign * load.reduced_radius * moment<D, double>(load.normal, load.resistance).dot(spin);
  };
  // The force is that on a: b does -(-F) . v, a -F . v.
  if (!std::isfinite(state_.masses[load.b])) return push(load.b, 1, load.arm_b);
  if (!std::isfinite(state_.masses[load.a])) return push(load.a, -1, load.arm_a);
  return 0;
}

template <int D>
void PowerMeasure<D>::add(const ContactLoad<D> &load) {
  const SurfaceMotion<D> motion = surface_motion(state_, load);
  contacts_.dashpot += load.dashpot * motion.velocity.dot(load.normal);
  contacts_.friction -= load.tangential.dot(motion.slip);
  contacts_.rolling -= load.resistance.dot(motion.roll);
  contacts_.input += load.force()[0] * load.image_speed + push_of_fixed(load);
  held_.friction += load.friction;
  held_.rolling += load.rolling;
}

template <int D>
Work PowerMeasure<D>::power() const {
  Work power = contacts_;
  for (size_t i = 0; i < state_.count() && has(setup_.effects, kDrag); i++) {
    if (!std::isfinite(state_.masses[i])) continue;
    const auto seen = vector_at<Vec<D, double>>(lagging_.velocities, i),
               now = vector_at<Vec<D, double>>(state_.velocities, i);
    power.drag += drag_of(setup_) * state_.radii[i] * seen.dot(now);
  }
  return power;
}

template class PowerMeasure<2>;
template class PowerMeasure<3>;

}  // namespace dem
