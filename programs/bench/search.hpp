// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What every contestant of a measurement is: a way to find all pairs, and the label of its results.
#pragma once

#include "particles/particle_set.hpp"

#include <hgrid/hgrid.hpp>

#include <cstddef>
#include <functional>
#include <string>

namespace bench {

// Pairs that belong to whoever found them, until the next search; a < b, in any order.
using PairView = hgrid::View<hg_pair>;

// What a search tells about its last run. Negative: not known.
struct Details {
  double levels = -1;
  double occupancy = -1;          // the largest m of a level: particles per cell
  double predicted_cost = -1;     // of that many levels, in the units of hg_level_cost
  double candidates = -1;         // tested, per particle
  double searches_per_step = -1;  // of a run of time steps
};

// One search that is ready to run. All that can be kept between time steps of a simulation (memory, objects, settings)
// is made before the first run.
struct Search {
  // From the doubles in memory to the complete list of pairs; returns the seconds that this took. Empty if the
  // contestant's variant makes no sense for these particles.
  std::function<double(PairView &)> run;
  std::function<Details()> details;  // may be empty
};

// Which set of pairs a search must find.
enum class Accuracy {
  kExact,    // that of real arithmetic
  kDouble,   // that of the plain double expression
  kRounded,  // the exact one, but for pairs that touch within the rounding of doubles
  kFloat     // the exact one and pairs that touch within 2^-47
};

struct Contestant {
  std::string name;     // of the program or algorithm: one word
  std::string variant;  // of its settings, "" if there is but one
  std::string isa;      // instruction set that HGRID_ISA asks for, "" = none is asked for
  int threads = 1;
  Accuracy accuracy = Accuracy::kDouble;
  bool tuned = false;  // one of several variants of a name: after a first run only the fastest of them goes on
  double skin = -1;    // of a run of time steps, in units of the smallest radius
  // Called in a process of its own, once.
  std::function<Search(const particles::ParticleSet &)> prepare;
};

}  // namespace bench
