// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Energies, momenta and overlaps of a state, in double whatever the state is kept in.
#pragma once

#include "dem/effects/body_force.hpp"
#include "dem/engine/bulk.hpp"
#include "dem/engine/contact_loads.hpp"
#include "dem/engine/engine.hpp"
#include "dem/engine/step_load.hpp"

#include <memory>
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

// All of a state, which it refers to: its contacts are added, and the particles come at the end.
template <int D>
class StateMeasure {
 public:
  StateMeasure(const Setup &setup, const Snapshot &state);
  void add(const ContactLoad<D> &load);
  Measurement result() const;

 private:
  double press_load() const;

  const Setup &setup_;
  const Snapshot &state_;
  Measurement contacts_;
  BulkMeasure<D> bulk_;
  std::unique_ptr<StepLoad<D>> step_load_;
  std::vector<double> answers_;  // of walls that press
};

}  // namespace dem
