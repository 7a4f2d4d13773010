// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Who comes and who goes: what inflows and removals do to the particles, looked at once in the time of the shortest
// contact. All of it follows from the setup, the step and the places of particles, so that neither threads nor the skin
// nor a restart change anything.
#pragma once

#include "dem/state/bodies.hpp"
#include "dem/state/boundary.hpp"
#include "dem/state/checkpoint.hpp"
#include "dem/state/contact_search.hpp"
#include "dem/state/surfaces.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace dem {

// What has passed through an inflow or a removal since the setup began.
struct Passage {
  std::string name;
  uint64_t count = 0;
  double mass = 0;       // of particles that can move
  uint64_t waiting = 0;  // that are due and have found no room yet (inflow)
};

template <int D>
struct Newcomer {
  Vec<D, double> center, velocity;
  double radius, mass;
  uint8_t material;
};

template <int D, class Real>
class Exchange {
 public:
  explicit Exchange(const Setup &setup);

  bool empty() const { return interval_ == 0; }
  bool is_due(uint64_t step) const { return interval_ > 0 && step % interval_ == 0; }

  // Those that lie in no removal, ascending; the others are counted.
  std::vector<uint32_t> staying(const Bodies<D, Real> &bodies);

  // Those that are due by `time` since the setup began and find room among the particles and walls where they are now.
  // `search` has looked for pairs, which still hold.
  std::vector<Newcomer<D>> coming(double time, uint64_t step, const Bodies<D, Real> &bodies,
                                  const ContactSearch &search, const Surfaces<D> &surfaces);

  std::vector<Passage> passages() const;

  void save(Checkpoint &checkpoint) const;
  void restore(const Checkpoint &checkpoint);

 private:
  // As in checkpoints.
  struct Passed {
    uint64_t count = 0, waiting = 0;
    double mass = 0;
  };

  bool is_free(const Newcomer<D> &one, const std::vector<Newcomer<D>> &others, const Bodies<D, Real> &bodies,
               const ContactSearch &search, const Surfaces<D> &surfaces) const;

  std::vector<Inflow> inflows_;
  std::vector<Region> removals_;
  std::vector<Passed> passed_;  // through inflows, then removals
  Boundary<D, double> boundary_;
  double start_;  // of the setup, in the time of the run
  uint64_t interval_;
};

}  // namespace dem
