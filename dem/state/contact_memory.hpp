// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What contacts remember from step to step: the stretch of their tangential springs.
#pragma once

#include "dem/base/vector.hpp"
#include "dem/effects/effects.hpp"
#include "dem/state/checkpoint.hpp"
#include "dem/state/contact_search.hpp"
#include "particles/grid_pointer.hpp"

#include <hgrid/hgrid.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dem {

// One row per contact of the present list, carried over from list to list by the library's contact history.
template <int D, class Real>
class ContactMemory {
 public:
  explicit ContactMemory(EffectSet effects) : slips_(has(effects, kFriction)), rolls_(has(effects, kRolling)) {
    if (!slips_) return;
    hg_history *history = nullptr;
    particles::require(hg_history_create(&history));
    history_.reset(history);
  }

  // Makes the rows those of this list: old contacts keep theirs, new ones start with zero.
  void follow(PairView pairs) {
    if (!slips_) return;
    const int64_t *previous = nullptr;
    particles::require(hg_history_update(history_.get(), pairs.count, pairs.data, &previous));
    carry(slip_, pairs.count);
    if (rolls_) carry(roll_, pairs.count);
  }

  Vec<D, Real> *slip() { return slip_.data(); }
  Vec<D, Real> *roll() { return roll_.data(); }
  size_t bytes() const { return sizeof(Vec<D, Real>) * (slip_.capacity() + roll_.capacity() + old_.capacity()); }

  void save(const std::string &name, Checkpoint &checkpoint) const {
    if (!slips_) return;
    PairView pairs;
    particles::require(hg_history_pairs(history_.get(), &pairs.data, &pairs.count));
    checkpoint.put(name + " pairs", pairs.data, pairs.count);
    checkpoint.put(name + " slip", slip_);
    checkpoint.put(name + " roll", roll_);
  }

  void restore(const std::string &name, const Checkpoint &checkpoint) {
    if (!slips_) return;
    std::vector<hg_pair> pairs;
    checkpoint.get_all(name + " pairs", pairs);
    particles::require(hg_history_restore(history_.get(), pairs.size(), pairs.data()));
    slip_.resize(pairs.size());
    checkpoint.get(name + " slip", slip_);
    roll_.resize(rolls_ ? pairs.size() : 0);
    checkpoint.get(name + " roll", roll_);
  }

 private:
  void carry(std::vector<Vec<D, Real>> &rows, size_t count) {
    old_.swap(rows);
    rows.resize(count);
    particles::require(hg_history_carry(history_.get(), sizeof(Vec<D, Real>), old_.data(), rows.data()));
  }

  struct Destroy {
    void operator()(hg_history *history) const { hg_history_destroy(history); }
  };
  bool slips_, rolls_;
  std::unique_ptr<hg_history, Destroy> history_;
  std::vector<Vec<D, Real>> slip_, roll_, old_;
};

}  // namespace dem
