// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Energies, momenta and overlaps of a state.
#include "dem/engine/measure.hpp"

#include "dem/effects/body_force.hpp"
#include "dem/effects/choice.hpp"
#include "dem/engine/bulk.hpp"
#include "dem/engine/step_load.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

template <int D>
using Vector = Vec<D, double>;

template <int D>
void measure_particles(const Setup &setup, const Snapshot &state, Measurement &result) {
  Vector<D> momentum = Vector<D>::Zero();
  Spin<D, double> angular = Spin<D, double>::Zero();
  const auto body_force = make_body_force<D, double>(setup);
  const auto potential =
      choose<kBodyEffects, double>(setup.effects, [](auto set) { return &potential_energy<decltype(set)::value, D>; });
  for (size_t i = 0; i < state.radii.size(); i++) {
    const double m = state.masses[i];
    if (!std::isfinite(m)) continue;
    const Vector<D> x = vector_at<Vector<D>>(state.centers, i), v = vector_at<Vector<D>>(state.velocities, i);
    result.translation += 0.5 * m * v.squaredNorm();
    result.gravity += potential(body_force, x, m);
    momentum += m * v;
    angular += moment<D, double>(x, m * v);
    if (state.spins.empty()) continue;
    const Spin<D, double> spin = vector_at<Spin<D, double>>(state.spins, i);
    const double inertia = m * state.radii[i] * state.radii[i] / inverse_shape(D);
    result.rotation += 0.5 * inertia * spin.squaredNorm();
    angular += inertia * spin;
  }
  std::copy_n(momentum.data(), D, result.momentum);
  std::copy_n(angular.data(), angular.size(), result.angular_momentum);
}

template <int D>
void measure_contacts(const std::vector<ContactLoad<D>> &loads, Measurement &result) {
  for (const ContactLoad<D> &load : loads) {
    const bool wall = load.b == ContactLoad<D>::kWall;
    result.contact += load.elastic + load.friction + load.rolling;
    result.largest_overlap = std::max(result.largest_overlap, load.overlap / load.smaller_radius);
    if (load.overlap > 0) (wall ? result.wall_contacts : result.contacts)++;
    if (wall && load.overlap > load.smaller_radius) result.behind_walls++;
    if (!wall) result.virial += load.spring * (load.arm_a + load.arm_b);
  }
}

}  // namespace

template <int D>
Measurement measure_state(const Setup &setup, const Snapshot &state, const std::vector<ContactLoad<D>> &loads) {
  Measurement result;
  result.time = state.time;
  measure_particles<D>(setup, state, result);
  measure_contacts<D>(loads, result);
  result.bulk = measure_bulk<D>(setup, state, loads);
  result.step_load = step_load<D>(setup, state, loads);
  return result;
}

template Measurement measure_state(const Setup &, const Snapshot &, const std::vector<ContactLoad<2>> &);
template Measurement measure_state(const Setup &, const Snapshot &, const std::vector<ContactLoad<3>> &);

}  // namespace dem
