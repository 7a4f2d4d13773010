// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A simulation that runs over ranks: the kernels and laws of dem/, the pairs and ghosts of libhgrid_mpi.
//
// Each rank owns some of the particles. What a particle feels is added up without rounding (push_sums.hpp), and whoever
// computes a contact computes it from the same bits in the same order; so all that follows has the same bits on any
// number of ranks, whoever owns what, and after any restart.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem_mpi/ranks.hpp"

#include <hgrid/mpi.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dem::ranks {

// The particles that a rank owns, as a Snapshot has them; numbers: as they were given.
struct OwnedParticles : Snapshot {
  std::vector<int64_t> numbers;
};

class RankEngine {
 public:
  RankEngine() = default;
  virtual ~RankEngine() = default;
  RankEngine(const RankEngine &) = delete;
  RankEngine &operator=(const RankEngine &) = delete;

  // Collective. Throw Error on all ranks if something went wrong on any.
  virtual void run(uint64_t steps) = 0;
  // Of all particles and contacts, the same on all ranks; without `bulk`, `work` and `step_load`, which are 0. Sums are
  // exact, then rounded.
  virtual Measurement measure() = 0;
  virtual OwnedParticles owned() = 0;

  // Local.
  virtual void save(Checkpoint &part) const = 0;
  virtual uint64_t steps_done() const = 0;
  virtual double time() const = 0;
  virtual hg_mpi_stats stats() const = 0;
  // Why owners stay as they are; empty if they are chosen anew as asked.
  virtual const std::string &balance_fault() const = 0;
};

// What is to be run over ranks; the setup has all particles, on each rank, and is the same on all.
struct RankPlan {
  const Setup &setup;
  const Ranks &ranks;
  uint64_t balance_every;  // steps between choices of new owners, as near as lists of pairs allow; 0: never
};

// Which keys of a setup are not done over ranks, one of them with its reason; empty: all are.
std::string fault_over_ranks(const Setup &setup);

// From the start, or from parts of a checkpoint: this rank's share of them, all parts on all ranks together.
// Collective.
std::unique_ptr<RankEngine> make_rank_engine(const RankPlan &plan);
std::unique_ptr<RankEngine> make_rank_engine(const RankPlan &plan, const std::vector<Checkpoint> &parts);

}  // namespace dem::ranks
