// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The forces of the pairs that this rank has found, by the engine's own kernels.
//
// Kernels add a force to each particle as they go, which rounds by the order of its contacts. Here each pair gets two
// bodies of its own, copied for a moment, so that what a contact does can be read off alone and added up without
// rounding: a few pairs at a time, and of these those that touch.
#pragma once

#include "dem/effects/contact_law.hpp"
#include "dem/kernels/contact_kernel.hpp"
#include "dem/state/contact_history.hpp"
#include "dem_mpi/push_sums.hpp"

#include <cstdint>
#include <vector>

namespace dem::ranks {

template <int D>
class PairForces {
 public:
  explicit PairForces(const Setup &setup);

  // Before rows of particles change their meaning: what contacts remember stays under their names, the numbers that
  // particles have on all ranks.
  void pack() { history_.pack(names()); }
  ContactMemory memory() const { return history_.memory_of(names()); }
  // In place of all that contacts remember; pairs ascending.
  void remember(const ContactMemory &memory) { history_.begin(memory); }

  // Pairs of particles by their rows, and their names. Each is turned so that the first particle has the smaller name:
  // whoever finds it computes it alike.
  void list(const hg_pair *pairs, size_t count, const std::vector<int64_t> &names);

  // Adds what contacts do; `step`: the time since the forces before.
  void add(const Bodies<D, double> &bodies, const Boundary<D, double> &boundary, double step, PushSums &sums);

  PairView rows() const { return {rows_.data(), rows_.size()}; }
  PairView names() const { return {names_.data(), names_.size()}; }
  const ContactHistory<D, double> &history() const { return history_; }

 private:
  static constexpr size_t kAtOnce = 256;

  size_t later_row(size_t k) const;
  void copy_bodies(const Bodies<D, double> &bodies);
  void add_contacts(const Boundary<D, double> &boundary, double step);

  EffectSet effects_;
  double range_;
  LawTable<double> laws_;
  BatchFiller<D, double> batch_filler_;
  RoughKernels<D, double> rough_kernels_;
  ContactKernel<D, double> kernel_;
  ContactHistory<D, double> history_;
  std::vector<hg_pair> rows_, names_;  // ascending by name
  ContactBatch<double> touching_;      // some of them
  std::vector<hg_pair> copies_;        // where the bodies of each of these are copied to
  Bodies<D, double> bodies_;           // those
  History<D, double> remembered_;      // and what they remember
};

// The force of a contact that is as deep as the largest particle, whatever the materials.
double deepest_force(const Setup &setup);

}  // namespace dem::ranks
