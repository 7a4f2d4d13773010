// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Bodies from arrays in double, and back.
#include "dem/engine/snapshots.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

template <int D, class Real>
Snapshot snapshot_of(const Bodies<D, Real> &bodies, size_t count, EffectSet effects,
                     const BodyForce<D, Real> &body_force, Real kick, Real lead) {
  constexpr size_t kSpin = Spin<D, Real>::RowsAtCompileTime;
  Snapshot state;
  state.dimension = D;
  const AccelerationKernel<D, Real> acceleration = find_acceleration<D, Real>(effects);
  state.centers.resize(D * count);
  state.velocities.resize(D * count);
  state.radii.resize(count);
  state.masses.resize(count);
  if (bodies.rotating()) state.spins.resize(kSpin * count);
  for (size_t i = 0; i < count; i++) {
    const Vec<D, Real> v = bodies.velocity(i) + kick * acceleration(bodies, body_force, i);
    const Vec<D, Real> x = bodies.position(i) - lead * v;
    std::copy_n(x.data(), D, &state.centers[D * i]);
    std::copy_n(v.data(), D, &state.velocities[D * i]);
    state.radii[i] = bodies.radius(i);
    state.masses[i] = bodies.inverse_mass(i) > 0 ? 1.0 / static_cast<double>(bodies.inverse_mass(i)) : kImmovable;
    if (!bodies.rotating()) continue;
    const Spin<D, Real> spin = bodies.spin(i) + (kick * bodies.inverse_inertia(i)) * bodies.torque(i);
    std::copy_n(spin.data(), kSpin, &state.spins[kSpin * i]);
  }
  return state;
}

template <int D, class Real>
void set_body(const Setup &setup, size_t particle, Bodies<D, Real> &bodies, size_t i) {
  bodies.velocity(i) = vector_at<Vec<D, double>>(setup.velocities, particle).template cast<Real>();
  bodies.position(i) = vector_at<Vec<D, double>>(setup.centers, particle).template cast<Real>();
  bodies.radius(i) = static_cast<Real>(setup.radii[particle]);
  bodies.inverse_mass(i) = static_cast<Real>(1 / setup.masses[particle]);
  if (!bodies.materials.empty()) bodies.materials[i] = setup.material_ids[particle];
  if (!bodies.rotating() || setup.spins.empty()) return;
  bodies.spin(i) = vector_at<Spin<D, double>>(setup.spins, particle).template cast<Real>();
}

void bring_into_box(const Setup &setup, Snapshot &state) {
  const auto dimension = static_cast<size_t>(state.dimension);
  for (size_t i = 0; i < state.radii.size(); i++) {
    for (size_t axis = 0; axis < dimension; axis++) {
      if (!setup.periodic[axis]) continue;
      double &x = state.centers[i * dimension + axis];
      const double low = setup.box_min[axis], length = setup.box_max[axis] - low;
      x -= length * std::floor((x - low) / length);
      if (!(x < setup.box_max[axis])) x = low;  // a tiny negative distance rounds to a whole length
    }
  }
}

#define DEM_INSTANTIATE(D, Real)                                                                                     \
  template Snapshot snapshot_of(const Bodies<D, Real> &, size_t, EffectSet, const BodyForce<D, Real> &, Real, Real); \
  template void set_body(const Setup &, size_t, Bodies<D, Real> &, size_t);

DEM_INSTANTIATE(2, double)
DEM_INSTANTIATE(3, double)
DEM_INSTANTIATE(2, float)
DEM_INSTANTIATE(3, float)

}  // namespace dem
