// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A running simulation, whatever its dimension, effects and precision. All that is chosen at run time is chosen here,
// once: a call of the engine does whole steps.
#pragma once

#include "dem/setup/setup.hpp"
#include "dem/state/checkpoint.hpp"
#include "dem/state/exchange.hpp"
#include "dem/state/handover.hpp"
#include "dem/state/surfaces.hpp"

#include <hgrid/hgrid.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace dem {

// The state at the time of a step, of all particles in order; centres inside the box on periodic axes, no spins without
// friction.
struct Snapshot : ParticleArrays {
  int dimension = 3;
  double time = 0;
  double image_offset = 0;  // how far the images above have moved along x (shear)
};

// Averages over the box, of components xx, yy, zz, xy, xz, yz; pressing counts as positive.
struct Bulk {
  double stress[6]{}, kinetic_stress[6]{};  // all of it, and what particles carry that move against the mean flow
  double pressure = 0;                      // the mean of the first ones of the stress
  double fabric[6]{};                       // mean of n n over the contacts of particles: its trace is 1
  double coordination = 0;                  // contacts per particle that is free to move
  double backbone = 0;                      // the same without rattlers, and contacts with them
  size_t rattlers = 0;
  double temperature = 0;  // mean square of the velocity against the mean flow, per component, by mass
};

// Energy that has left or entered since the work has been counted.
struct Work {
  double dashpot = 0, friction = 0, rolling = 0, drag = 0;  // dissipated
  double input = 0;                                         // put in by images and fixed particles that move

  double dissipated() const { return dashpot + friction + rolling + drag; }
};

// Where a contact is and what it bears.
struct ContactLine {
  double from[3]{}, to[3]{};  // the centres, the second one of the image that the first meets; or a point of a wall
  int64_t a = 0, b = 0;       // particles in the order of the setup; b is -1 for walls
  double overlap = 0;
  double normal = 0, tangential = 0;  // forces; normal ones that push apart are positive
};

// Sums over all particles and contacts at the time of a step.
struct Measurement {
  double time = 0;
  double translation = 0, rotation = 0;  // kinetic energy
  double contact = 0;    // elastic energy of contacts, less that of adhesion; tangential springs included
  double gravity = 0;    // potential energy, 0 at the origin
  double wall_work = 0;  // that walls which move have done on particles since the setup began
  double momentum[3]{};
  double angular_momentum[3]{};            // about the origin, spins included; one component in two dimensions
  size_t contacts = 0, wall_contacts = 0;  // that overlap
  double largest_overlap = 0;              // over the radius of the smaller particle
  size_t behind_walls = 0;                 // centres
  double virial = 0;                       // sum over pairs of (elastic force x distance of the centres)
  double step_load = 0;   // of the present contacts on the time step: below 1 it is stable (step_load.hpp)
  double press_load = 0;  // of planes that press: above 1 they never come to rest (measure.cpp)
  Bulk bulk;
  Work work;  // 0 unless it is counted

  double energy() const { return translation + rotation + contact + gravity; }
  // Stays as it is but for the errors of the time step.
  double balance() const { return energy() + work.dissipated() - work.input; }
};

class Engine {
 public:
  Engine() = default;
  virtual ~Engine() = default;
  Engine(const Engine &) = delete;
  Engine &operator=(const Engine &) = delete;

  virtual void run(uint64_t steps) = 0;

  // All leave the further course as it is, to the last bit.
  virtual Measurement measure() = 0;
  virtual Snapshot snapshot() = 0;
  // What another simulation goes on from, as one that begins: the state at the time of the step.
  virtual Handover hand_over() = 0;
  // The walls beside those of the box.
  virtual std::vector<WallReport> walls_now() = 0;
  // What has come in through inflows and gone out through removals.
  virtual std::vector<Passage> passages() const = 0;

  virtual std::vector<ContactLine> contacts() = 0;  // those that overlap, by a and b; a is before b

  // From now on, and in steps that take longer. Throws Error where no work is counted: with schemes other than
  // velocity Verlet, with growth, and where particles come or go.
  virtual void count_work() = 0;

  virtual uint64_t steps_done() const = 0;  // those before the setup began included
  virtual double time() const = 0;
  virtual size_t particle_count() const = 0;
  virtual size_t pair_count() const = 0;   // pairs that the last step looked at
  virtual size_t state_bytes() const = 0;  // arrays of the particles and contacts, without the library's
  virtual hg_grid_stats grid_stats() const = 0;

  // A simulation of the same setup that is restored goes on to the same bits.
  virtual void save(Checkpoint &checkpoint) const = 0;
  virtual void restore(const Checkpoint &checkpoint) = 0;
};

enum class Precision { kDouble, kFloat };

// Checks the setup and its time step and makes the engine for it, its state in numbers of this precision.
// Throws Error naming what is wrong.
std::unique_ptr<Engine> make_engine(const Setup &setup, Precision precision = Precision::kDouble);

}  // namespace dem
