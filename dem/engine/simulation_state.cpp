// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Looking at a simulation, saving and restoring it.
#include "dem/base/error.hpp"
#include "dem/engine/measure.hpp"
#include "dem/engine/simulation.hpp"
#include "dem/state/wall_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem {
namespace {

template <int D, class Real>
std::vector<Vec<D, double>> in_double(const Vec<D, Real> *rows, size_t count) {
  std::vector<Vec<D, double>> result(rows == nullptr ? 0 : count);
  for (size_t k = 0; k < result.size(); k++) result[k] = rows[k].template cast<double>();
  return result;
}

// Brings rows back from the order of the arrays.
void undo_order(std::vector<double> &rows, const std::vector<uint32_t> &order) {
  if (rows.empty()) return;
  const size_t width = rows.size() / order.size();
  std::vector<double> result(rows.size());
  for (size_t k = 0; k < order.size(); k++) {
    std::copy_n(&rows[k * width], width, &result[order[k] * width]);
  }
  rows.swap(result);
}

// What decides the course of a simulation besides its state.
struct Fingerprint {
  uint64_t dimension, precision, effects, count;
  double time_step;
};

// The arrays of a checkpoint: what is written and what is read is one list.
template <class SomeBodies, class Visit>
void visit_arrays(SomeBodies &bodies, Visit visit) {
  visit("position", bodies.position);
  visit("velocity", bodies.velocity);
  visit("force", bodies.force);
  visit("radius", bodies.radius);
  visit("inverse mass", bodies.inverse_mass);
  visit("spin", bodies.spin);
  visit("torque", bodies.torque);
}

}  // namespace

template <int D, class Real>
Snapshot Simulation<D, Real>::state_now() {
  // Half kicks need the forces of the positions.
  const bool lags = setup_.scheme.shared_kick != 0 && steps_ > 0;
  if (lags) find_forces();
  const auto kick = static_cast<Real>(lags ? setup_.scheme.shared_kick * setup_.time_step : 0);
  const auto lead = static_cast<Real>(setup_.scheme.shared_drift * setup_.time_step);
  Snapshot state;
  state.dimension = D;
  state.time = time();
  const size_t count = bodies_.count();
  for (size_t i = 0; i < count; i++) {
    Vec<D, Real> acceleration = bodies_.force[i] * bodies_.inverse_mass[i];
    if (has(setup_.effects, kGravity) && bodies_.inverse_mass[i] > 0) acceleration += gravity_;
    if (has(setup_.effects, kDrag)) {
      acceleration -= drag_ * bodies_.radius[i] * bodies_.inverse_mass[i] * bodies_.velocity[i];
    }
    const Vec<D, Real> v = bodies_.velocity[i] + kick * acceleration;
    const Vec<D, Real> x = bodies_.position[i] - lead * v;
    state.centers.insert(state.centers.end(), x.data(), x.data() + D);
    state.velocities.insert(state.velocities.end(), v.data(), v.data() + D);
    state.radii.push_back(bodies_.radius[i]);
    state.masses.push_back(bodies_.inverse_mass[i] > 0 ? 1.0 / static_cast<double>(bodies_.inverse_mass[i])
                                                       : kImmovable);
    if (bodies_.spin.empty()) continue;
    const Spin<D, Real> spin = bodies_.spin[i] + (kick * bodies_.inverse_inertia(i)) * bodies_.torque[i];
    state.spins.insert(state.spins.end(), spin.data(), spin.data() + spin.size());
  }
  return state;
}

template <int D, class Real>
Snapshot Simulation<D, Real>::snapshot() {
  Snapshot state = state_now();
  for (auto *rows : {&state.centers, &state.velocities, &state.radii, &state.masses, &state.spins}) {
    undo_order(*rows, order_);
  }
  for (size_t i = 0; i < state.radii.size(); i++) {
    for (size_t k = 0; k < D; k++) {
      if (!setup_.periodic[k]) continue;
      double &x = state.centers[i * D + k];
      const double low = setup_.box_min[k], length = setup_.box_max[k] - low;
      x -= length * std::floor((x - low) / length);
      if (!(x < setup_.box_max[k])) x = low;  // a tiny negative distance rounds to a whole length
    }
  }
  return state;
}

template <int D, class Real>
Measurement Simulation<D, Real>::measure() {
  const Snapshot state = state_now();
  Boundary<D, double> boundary = make_boundary<D, double>(setup_);
  boundary.offset = image_offset();
  ContactState<D> contacts;
  std::vector<hg_pair> walls = wall_contacts_;
  if (setup_.scheme.shared_drift == 0) {
    find_pairs();
    contacts.pairs = pairs_;
    contacts.pair_slip = in_double<D, Real>(pair_memory_.slip(), pairs_.count);
    contacts.pair_roll = in_double<D, Real>(pair_memory_.roll(), pairs_.count);
    contacts.wall_slip = in_double<D, Real>(wall_memory_.slip(), walls.size());
    contacts.wall_roll = in_double<D, Real>(wall_memory_.roll(), walls.size());
  } else {
    // Positions are ahead of the step: its contacts are others than those of the forces.
    contacts.pairs = search_.find(state.centers.data(), nullptr, image_offset());
    pairs_known_ = false;
    const WallReach<D, double> reach(boundary, wall_range());
    walls.clear();
    for (size_t i = 0; i < state.radii.size(); i++) {
      reach.list(Eigen::Map<const Vec<D, double>>(&state.centers[i * D]), state.radii[i], i, walls);
    }
  }
  contacts.walls = {walls.data(), walls.size()};
  return measure_state<D>(setup_, boundary, state, contacts);
}

template <int D, class Real>
void Simulation<D, Real>::save(Checkpoint &checkpoint) const {
  checkpoint.put_value("fingerprint", Fingerprint{D, sizeof(Real), setup_.effects, bodies_.count(), setup_.time_step});
  checkpoint.put_value("steps", steps_);
  checkpoint.put_value("forces known", static_cast<uint64_t>(forces_known_));
  checkpoint.put_value("last drift", last_drift_);
  visit_arrays(bodies_, [&](const char *name, const auto &array) { checkpoint.put(name, array); });
  pair_memory_.save("pair", checkpoint);
  wall_memory_.save("wall", checkpoint);
}

template <int D, class Real>
void Simulation<D, Real>::restore(const Checkpoint &checkpoint) {
  const auto print = checkpoint.get_value<Fingerprint>("fingerprint");
  if (print.dimension != D || print.precision != sizeof(Real)) {
    throw Error("the checkpoint is of " + std::to_string(print.dimension) + " dimensions in numbers of " +
                std::to_string(print.precision) + " bytes, the scene of " + std::to_string(D) + " in " +
                std::to_string(sizeof(Real)));
  }
  if (print.effects != setup_.effects) {
    throw Error("the checkpoint has the effects " + names_of(static_cast<EffectSet>(print.effects)) +
                ", the scene has " + names_of(setup_.effects));
  }
  if (print.count != bodies_.count()) {
    throw Error("the checkpoint holds " + std::to_string(print.count) + " particles, the scene " +
                std::to_string(bodies_.count()));
  }
  if (print.time_step != setup_.time_step) {
    throw Error("the checkpoint was made with the time step " + text(print.time_step) + ", the scene has " +
                text(setup_.time_step));
  }
  steps_ = checkpoint.get_value<uint64_t>("steps");
  forces_known_ = checkpoint.get_value<uint64_t>("forces known") != 0;
  last_drift_ = checkpoint.get_value<double>("last drift");
  visit_arrays(bodies_, [&](const char *name, auto &array) { checkpoint.get(name, array); });
  pair_memory_.restore("pair", checkpoint);
  wall_memory_.restore("wall", checkpoint);
  list_wall_contacts();
  radii_new_ = true;
  pairs_known_ = false;
}

#define DEM_INSTANTIATE(D, Real)                                         \
  template Snapshot Simulation<D, Real>::state_now();                    \
  template Snapshot Simulation<D, Real>::snapshot();                     \
  template Measurement Simulation<D, Real>::measure();                   \
  template void Simulation<D, Real>::save(Checkpoint &checkpoint) const; \
  template void Simulation<D, Real>::restore(const Checkpoint &checkpoint);

DEM_INSTANTIATE(2, double)
DEM_INSTANTIATE(3, double)
DEM_INSTANTIATE(2, float)
DEM_INSTANTIATE(3, float)

}  // namespace dem
