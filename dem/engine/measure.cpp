// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Energies, momenta and overlaps of a state.
#include "dem/engine/measure.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

template <int D>
using Vector = Vec<D, double>;

template <int D>
Vector<D> row(const std::vector<double> &numbers, size_t i) {
  return Eigen::Map<const Vector<D>>(&numbers[i * D]);
}

// The elastic part of a contact: its force and energy.
struct Spring {
  double force = 0, energy = 0;
  double stiffness = 0;  // dF/dd, which the tangential springs follow
};

Spring spring_of(const ContactLaw<double> &law, const ContactParameters &parameters, EffectSet effects, double overlap,
                 double inverse_radius) {
  Spring spring;
  const bool adhesive = has(effects, kAdhesion);
  if (adhesive && overlap < 0) {
    const double gap_left = std::max(0.0, parameters.adhesion_range + overlap);
    spring.force = -law.adhesion_force * gap_left * law.inverse_range;
    spring.energy = spring.force * gap_left / 2;
    return spring;
  }
  Meeting<double> meeting{};
  meeting.overlap = overlap;
  meeting.inverse_radius = inverse_radius;
  const NormalForce<double> normal =
      has(effects, kHertz) ? normal_force<kHertz>(law, meeting) : normal_force<0>(law, meeting);
  spring.force = normal.value;
  spring.stiffness = normal.stiffness;
  spring.energy = (has(effects, kHertz) ? 0.4 : 0.5) * normal.value * overlap;
  if (adhesive) {
    spring.force -= law.adhesion_force;
    spring.energy -= law.adhesion_force * (overlap + parameters.adhesion_range / 2);
  }
  return spring;
}

template <int D>
void measure_particles(const Setup &setup, const Snapshot &state, Measurement &result) {
  Vector<D> momentum = Vector<D>::Zero();
  Spin<D, double> angular = Spin<D, double>::Zero();
  constexpr int kSpinSize = Spin<D, double>::RowsAtCompileTime;
  constexpr double kShape = D == 3 ? 0.4 : 0.5;  // I / (m r^2)
  const Vector<D> gravity = Eigen::Map<const Vector<D>>(setup.gravity);
  for (size_t i = 0; i < state.radii.size(); i++) {
    const double m = state.masses[i];
    if (!std::isfinite(m)) continue;
    const Vector<D> x = row<D>(state.centers, i), v = row<D>(state.velocities, i);
    result.translation += 0.5 * m * v.squaredNorm();
    if (has(setup.effects, kGravity)) result.gravity -= m * gravity.dot(x);
    momentum += m * v;
    angular += moment<D, double>(x, m * v);
    if (state.spins.empty()) continue;
    const Spin<D, double> spin = Eigen::Map<const Spin<D, double>>(&state.spins[i * kSpinSize]);
    const double inertia = kShape * m * state.radii[i] * state.radii[i];
    result.rotation += 0.5 * inertia * spin.squaredNorm();
    angular += inertia * spin;
  }
  std::copy_n(momentum.data(), D, result.momentum);
  std::copy_n(angular.data(), kSpinSize, result.angular_momentum);
}

template <int D>
double stretch_energy(const std::vector<Vector<D>> &stretches, size_t p, double stiffness) {
  return stretches.empty() ? 0 : 0.5 * stiffness * stretches[p].squaredNorm();
}

template <int D>
Vector<D> nearest(const Boundary<D, double> &boundary, EffectSet effects, Vector<D> separation) {
  if (has(effects, kShear)) {
    boundary.template nearest<kPeriodic | kShear>(separation);
  } else if (has(effects, kPeriodic)) {
    boundary.template nearest<kPeriodic>(separation);
  }
  return separation;
}

template <int D>
void measure_pairs(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                   const ContactState<D> &contacts, Measurement &result) {
  const ContactLaw<double> law = make_law<double>(setup.contact, setup.effects, Partner::kParticle);
  for (size_t p = 0; p < contacts.pairs.size(); p++) {
    const auto a = static_cast<size_t>(contacts.pairs[p].a);
    const auto b = static_cast<size_t>(contacts.pairs[p].b);
    // Neighbours in a wall of fixed particles may overlap as they like: nothing comes of it.
    if (!std::isfinite(state.masses[a]) && !std::isfinite(state.masses[b])) continue;
    const Vector<D> between = row<D>(state.centers, b) - row<D>(state.centers, a);
    const double distance = nearest<D>(boundary, setup.effects, between).norm();
    const double overlap = state.radii[a] + state.radii[b] - distance;
    const Spring spring =
        spring_of(law, setup.contact, setup.effects, overlap, 1 / state.radii[a] + 1 / state.radii[b]);
    result.contact += spring.energy;
    result.contact += stretch_energy<D>(contacts.pair_slip, p, law.tangential_ratio * spring.stiffness);
    result.contact += stretch_energy<D>(contacts.pair_roll, p, law.rolling_ratio * spring.stiffness);
    result.virial += spring.force * distance;
    if (overlap > 0) result.contacts++;
    result.largest_overlap = std::max(result.largest_overlap, overlap / std::min(state.radii[a], state.radii[b]));
  }
}

template <int D>
void measure_walls(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                   const ContactState<D> &contacts, Measurement &result) {
  const ContactLaw<double> law = make_law<double>(setup.contact, setup.effects, Partner::kWall);
  for (size_t p = 0; p < contacts.walls.size(); p++) {
    const auto i = static_cast<size_t>(contacts.walls[p].a);
    const int32_t wall = contacts.walls[p].b;
    const double overlap =
        wall_overlap(boundary, state.centers[i * D + static_cast<size_t>(axis_of(wall))], state.radii[i], wall);
    const Spring spring = spring_of(law, setup.contact, setup.effects, overlap, 1 / state.radii[i]);
    result.contact += spring.energy;
    result.contact += stretch_energy<D>(contacts.wall_slip, p, law.tangential_ratio * spring.stiffness);
    result.contact += stretch_energy<D>(contacts.wall_roll, p, law.rolling_ratio * spring.stiffness);
    if (overlap > 0) result.wall_contacts++;
    result.largest_overlap = std::max(result.largest_overlap, overlap / state.radii[i]);
  }
}

}  // namespace

template <int D>
Measurement measure_state(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                          const ContactState<D> &contacts) {
  Measurement result;
  result.time = state.time;
  measure_particles<D>(setup, state, result);
  measure_pairs<D>(setup, boundary, state, contacts, result);
  measure_walls<D>(setup, boundary, state, contacts, result);
  return result;
}

template Measurement measure_state(const Setup &, const Boundary<2, double> &, const Snapshot &,
                                   const ContactState<2> &);
template Measurement measure_state(const Setup &, const Boundary<3, double> &, const Snapshot &,
                                   const ContactState<3> &);

}  // namespace dem
