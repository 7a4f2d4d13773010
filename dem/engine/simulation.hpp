// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The engine of one dimension and precision: the order of work within a step.
#pragma once

#include "dem/engine/contact_loads.hpp"
#include "dem/engine/engine.hpp"
#include "dem/kernels/contact_kernel.hpp"
#include "dem/kernels/motion_kernel.hpp"
#include "dem/kernels/surface_kernel.hpp"
#include "dem/state/contact_history.hpp"
#include "dem/state/exchange.hpp"
#include "dem/state/room.hpp"
#include "dem/state/shares.hpp"

#include <cstdint>
#include <vector>

namespace dem {

// The state between two steps is (x_n, v, forces not yet computed), v lagging as the scheme says; or, after someone
// looked at it, the same with the forces of x_n computed. Both go on to the same bits.
template <int D, class Real>
class Simulation final : public Engine {
 public:
  // Particle i as it was given is places[i] of the setup; what is shown comes in the order they were given in.
  Simulation(const Setup &setup, std::vector<uint32_t> places);

  void run(uint64_t steps) override;
  Measurement measure() override;
  Snapshot snapshot() override;
  Handover hand_over() override;
  std::vector<WallReport> walls_now() override;
  std::vector<Passage> passages() const override { return exchange_.passages(); }
  std::vector<ContactLine> contacts() override;
  void count_work() override;

  uint64_t steps_done() const override { return steps_; }
  double time() const override { return setup_.beginning.time + since_beginning(); }
  size_t particle_count() const override { return bodies_.count(); }
  size_t pair_count() const override { return pair_count_; }
  size_t state_bytes() const override;
  hg_grid_stats grid_stats() const override { return search_.stats(); }

  void save(Checkpoint &checkpoint) const override;
  void restore(const Checkpoint &checkpoint) override;

 private:
  void require_speed() const;
  void load_bodies(const Setup &setup);
  void load_history(const Beginning &beginning);
  void list_walls(double within);
  PairView walls() const { return {walls_.data(), walls_.size()}; }

  // Lists of the pairs and walls that may touch, for the present places.
  void find_pairs();
  bool lists_hold();
  void find_forces();
  void find_surface_forces(size_t thread);
  ContactTask<D, Real> task_of(const LawTable<Real> &laws);
  void advance(const Stage &stage);
  double grow();
  void cross_sheared_faces();

  // Takes away who is in a removal, and adds who comes.
  void exchange();
  void replace(std::vector<uint32_t> staying, const std::vector<Newcomer<D>> &newcomers);
  void keep_contacts(const std::vector<uint32_t> &numbers);

  // The state at the time of the step, in the order of the arrays; centres not yet brought into the box. Half kicks
  // need the forces of the positions.
  Snapshot state_now();
  // The same with velocities advanced by `kick`: those that the forces see by 0.
  Snapshot state_after(double kick) const;
  double lag() const;  // of velocities behind positions
  void visit_loads_of(const Snapshot &lagging, const LoadVisit<D> &visit);
  void tally(double kick);

  uint64_t steps_since_beginning() const { return steps_ - setup_.beginning.step; }
  double since_beginning() const { return static_cast<double>(steps_since_beginning()) * setup_.time_step; }
  double image_offset() const;

  Setup setup_;  // without its arrays of particles and contacts
  std::vector<uint32_t> places_;
  int threads_;
  Bodies<D, Real> bodies_;
  Boundary<D, Real> boundary_;
  BodyForce<D, Real> body_force_;
  LawTable<Real> pair_laws_, wall_laws_;
  BatchFiller<D, Real> batch_filler_;
  RoughKernels<D, Real> rough_kernels_;
  ContactKernel<D, Real> pair_kernel_, wall_kernel_;
  MotionKernel<D, Real> motion_kernel_;

  double slack_;  // for the rounding of distances
  ContactSearch search_;
  Room<D, Real> room_;
  PairView pairs_;
  std::vector<hg_pair> walls_;  // particles and walls
  Shares shares_;
  ContactHistory<D, Real> pair_history_, wall_history_;
  Surfaces<D> surfaces_;
  SurfaceKernel<D> surface_kernel_ = nullptr;
  ContactHistory<D, double> surface_history_;
  Exchange<D, Real> exchange_;
  uint64_t unsorted_ = 0;  // newcomers since particles were last put into the order of space
  size_t pair_count_ = 0;

  double fastest_allowed_;  // approach that the time step is short enough for
  uint64_t steps_;
  double last_drift_ = 0;  // time between the present forces and those before
  bool forces_known_ = false, radii_new_ = false;
  bool counts_work_ = false;
  Work work_;  // of all kicks so far
};

}  // namespace dem
