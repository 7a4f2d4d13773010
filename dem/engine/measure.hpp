// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Energies, momenta and overlaps of a state, in double whatever the state is kept in.
#pragma once

#include "dem/effects/body_force.hpp"
#include "dem/engine/contact_loads.hpp"
#include "dem/engine/engine.hpp"

#include <vector>

namespace dem {

// What a particle adds to the energies and momenta, for whoever adds them up.
template <int D>
class ParticleMeasure {
 public:
  explicit ParticleMeasure(const Setup &setup);
  // Particle i; fixed ones have nothing.
  void add(const Snapshot &state, size_t i, Measurement &sum) const;

 private:
  BodyForce<D, double> body_force_;
  double (*potential_)(const BodyForce<D, double> &, const Vec<D, double> &, double);
};

// What a contact adds to the energies and counts, and to the largest overlap.
template <int D>
void add_contact(const ContactLoad<D> &load, Measurement &sum);

template <int D>
Measurement measure_state(const Setup &setup, const Snapshot &state, const std::vector<ContactLoad<D>> &loads);

}  // namespace dem
