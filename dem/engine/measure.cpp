// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Energies, momenta and overlaps of a state.
#include "dem/engine/measure.hpp"

#include "dem/effects/choice.hpp"
#include "dem/engine/bulk.hpp"
#include "dem/engine/step_load.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

template <int D>
using Vector = Vec<D, double>;

// A plane moves with v = V (1 - f / F), where springs K and dashpots C answer with f = K x + C v a step later. With
// a = V K dt / F and c = V C / F a miss of v goes as powers of the roots of s^2 - (1 - a - c) s - c: they fade if
// a / 2 + c < 1.
template <int D>
double press_load(const Setup &setup, const std::vector<ContactLoad<D>> &loads) {
  std::vector<double> answer(setup.walls.size(), 0.0);
  for (const ContactLoad<D> &load : loads) {
    if (load.wall < 0 || !(load.overlap > 0)) continue;
    answer[static_cast<size_t>(load.wall)] += load.stiffness * setup.time_step / 2 + load.damping;
  }
  double largest = 0;
  for (size_t k = 0; k < setup.walls.size(); k++) {
    const WallBody &wall = setup.walls[k];
    if (wall.presses()) largest = std::max(largest, wall.fastest * answer[k] / wall.force);
  }
  return largest;
}

}  // namespace

template <int D>
ParticleMeasure<D>::ParticleMeasure(const Setup &setup)
    : body_force_(make_body_force<D, double>(setup)),
      potential_(choose<kBodyEffects, double>(setup.effects,
                                              [](auto set) { return &potential_energy<decltype(set)::value, D>; })) {}

template <int D>
void ParticleMeasure<D>::add(const Snapshot &state, size_t i, Measurement &sum) const {
  const double m = state.masses[i];
  if (!std::isfinite(m)) return;
  const Vector<D> x = vector_at<Vector<D>>(state.centers, i), v = vector_at<Vector<D>>(state.velocities, i);
  sum.translation += 0.5 * m * v.squaredNorm();
  sum.gravity += potential_(body_force_, x, m);
  Eigen::Map<Vector<D>>(sum.momentum) += m * v;
  Eigen::Map<Spin<D, double>> angular(sum.angular_momentum);
  angular += moment<D, double>(x, m * v);
  if (state.spins.empty()) return;
  const Spin<D, double> spin = vector_at<Spin<D, double>>(state.spins, i);
  const double inertia = m * state.radii[i] * state.radii[i] / inverse_shape(D);
  sum.rotation += 0.5 * inertia * spin.squaredNorm();
  angular += inertia * spin;
}

template <int D>
void add_contact(const ContactLoad<D> &load, Measurement &sum) {
  const bool wall = load.b == ContactLoad<D>::kWall;
  sum.contact += load.elastic + load.friction + load.rolling;
  sum.largest_overlap = std::max(sum.largest_overlap, load.overlap / load.smaller_radius);
  if (load.overlap > 0) (wall ? sum.wall_contacts : sum.contacts)++;
  if (wall && load.overlap > load.smaller_radius) sum.behind_walls++;
  if (!wall) sum.virial += load.spring * (load.arm_a + load.arm_b);
}

template <int D>
Measurement measure_state(const Setup &setup, const Snapshot &state, const std::vector<ContactLoad<D>> &loads) {
  Measurement result;
  result.time = state.time;
  const ParticleMeasure<D> particles(setup);
  for (size_t i = 0; i < state.count(); i++) particles.add(state, i, result);
  for (const ContactLoad<D> &load : loads) add_contact(load, result);
  result.bulk = measure_bulk<D>(setup, state, loads);
  result.step_load = step_load<D>(setup, state, loads);
  result.press_load = press_load<D>(setup, loads);
  return result;
}

template class ParticleMeasure<2>;
template void add_contact(const ContactLoad<2> &, Measurement &);
template Measurement measure_state(const Setup &, const Snapshot &, const std::vector<ContactLoad<2>> &);
template class ParticleMeasure<3>;
template void add_contact(const ContactLoad<3> &, Measurement &);
template Measurement measure_state(const Setup &, const Snapshot &, const std::vector<ContactLoad<3>> &);

}  // namespace dem
