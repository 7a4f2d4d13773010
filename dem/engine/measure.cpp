// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Energies, momenta and overlaps of a state.
#include "dem/engine/measure.hpp"

#include "dem/effects/choice.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

template <int D>
using Vector = Vec<D, double>;

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
StateMeasure<D>::StateMeasure(const Setup &setup, const Snapshot &state)
    : setup_(setup), state_(state), step_load_(make_step_load<D>(setup, state)), answers_(setup.walls.size(), 0.0) {}

template <int D>
void StateMeasure<D>::add(const ContactLoad<D> &load) {
  add_contact(load, contacts_);
  bulk_.add(load);
  step_load_->add(load);
  if (load.wall < 0 || !(load.overlap > 0)) return;
  answers_[static_cast<size_t>(load.wall)] += load.stiffness * setup_.time_step / 2 + load.damping;
}

template <int D>
Measurement StateMeasure<D>::result() const {
  Measurement result = contacts_;
  result.time = state_.time;
  const ParticleMeasure<D> particles(setup_);
  for (size_t i = 0; i < state_.count(); i++) particles.add(state_, i, result);
  result.bulk = bulk_.of(setup_, state_);
  result.step_load = step_load_->largest();
  result.press_load = press_load();
  return result;
}

// A plane moves with v = V (1 - f / F), where springs K and dashpots C answer with f = K x + C v a step later. With
// a = V K dt / F and c = V C / F a miss of v goes as powers of the roots of s^2 - (1 - a - c) s - c: they fade if
// a / 2 + c < 1.
template <int D>
double StateMeasure<D>::press_load() const {
  double largest = 0;
  for (size_t k = 0; k < setup_.walls.size(); k++) {
    const WallBody &wall = setup_.walls[k];
    if (wall.presses()) largest = std::max(largest, wall.fastest * answers_[k] / wall.force);
  }
  return largest;
}

#define DEM_INSTANTIATE(D)           \
  template class ParticleMeasure<D>; \
  template class StateMeasure<D>;    \
  template void add_contact(const ContactLoad<D> &, Measurement &);

DEM_INSTANTIATE(2)
DEM_INSTANTIATE(3)

}  // namespace dem
