// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The engine over ranks, of one dimension: the order of work within a step.
#pragma once

#include "dem/engine/contact_loads.hpp"
#include "dem/engine/fingerprint.hpp"
#include "dem/kernels/motion_kernel.hpp"
#include "dem/state/room.hpp"
#include "dem_mpi/pair_forces.hpp"
#include "dem_mpi/rank_engine.hpp"

#include <memory>
#include <string>
#include <vector>

namespace dem::ranks {

// The state between two steps is that of dem::Simulation. Particles have names, their places along a space-filling
// curve at the start, which stay theirs on any rank.
template <int D>
class RankSimulation final : public RankEngine {
 public:
  // `sorted` has all particles, in the order of their names; numbers[name] is how particles were given.
  RankSimulation(const RankPlan &plan, const Setup &sorted, const std::vector<uint32_t> &numbers,
                 const std::vector<Checkpoint> *parts);

  void run(uint64_t steps) override;
  Measurement measure() override;
  OwnedParticles owned() override;

  void save(Checkpoint &part) const override;
  uint64_t steps_done() const override { return steps_; }
  double time() const override { return static_cast<double>(steps_) * setup_.time_step; }
  hg_mpi_stats stats() const override;
  const std::string &balance_fault() const override { return balance_fault_; }

 private:
  struct Destroy {
    void operator()(hg_mpi *world) const { hg_mpi_destroy(world); }
  };

  void take_share(const Setup &sorted, const std::vector<uint32_t> &numbers);
  void restore(const std::vector<Checkpoint> &parts);
  Fingerprint fingerprint() const;
  void add_part(const Checkpoint &part);
  void make_world();

  // Everyone who may touch is known, and stands where the owner has it.
  void meet();
  bool lists_hold();
  void renew(bool balance);
  void balance();
  void prepare_travel();
  void send_ghosts();
  // Also where there is no particle on this rank.
  bool rotates() const { return has(setup_.effects, kFriction); }
  size_t travel_rows() const { return rotates() ? 3 : 2; }
  void list_walls();
  void find_forces();
  void advance(const Stage &stage);
  void check_speed();
  void note(const std::string &fault);
  void tell_faults();

  double lag() const { return steps_ > 0 ? setup_.scheme.shared_kick * setup_.time_step : 0; }
  void visit_loads_of(const Snapshot &lagging, const LoadVisit<D> &visit) const;
  std::vector<double> packed_centers() const;
  std::vector<double> radii() const;
  template <class Rows>
  void migrate(Rows &rows, size_t count, size_t width = 1);
  void migrate_history(size_t count, const std::vector<double> &radii_before, size_t owned_before);
  PairView wall_names() const { return {wall_names_.data(), wall_names_.size()}; }

  Setup setup_;  // without its arrays of particles
  const Ranks &ranks_;
  size_t count_of_all_;
  Bodies<D, double> bodies_;  // the owned ones, then ghosts
  std::vector<int64_t> names_;
  std::vector<int64_t> numbers_;  // of the owned ones
  size_t owned_ = 0;
  std::vector<size_t> travelling_;              // owned rows that are ghosts somewhere
  LargeArray<Row<double>> leaving_, arriving_;  // what travels in each step, of owned ones and of ghosts

  Boundary<D, double> boundary_;
  BodyForce<D, double> body_force_;
  LawTable<double> wall_laws_;
  ContactKernel<D, double> wall_kernel_;
  MotionKernel<D, double> motion_kernel_;
  double slack_, skin_;
  std::unique_ptr<hg_mpi, Destroy> world_;
  Room<D, double> room_;
  PairForces<D> pairs_;
  PushSums sums_;
  std::vector<hg_pair> walls_, wall_names_;  // rows of particles, and their names, with walls
  ContactHistory<D, double> wall_history_;

  double fastest_allowed_;
  uint64_t balance_every_, next_balance_ = 0;
  std::string balance_fault_;
  std::string fault_;  // of this rank, not yet told to the others
  uint64_t steps_ = 0;
  double last_drift_ = 0;
  bool listed_ = false;  // the world has particles
  bool met_ = false, forces_known_ = false;
};

}  // namespace dem::ranks
