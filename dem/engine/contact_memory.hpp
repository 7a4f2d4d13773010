// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What contacts remember from step to step: the stretch of their tangential springs.
#pragma once

#include "dem/engine/checkpoint.hpp"
#include "dem/engine/contact_search.hpp"
#include "dem/engine/effects.hpp"
#include "dem/engine/vector.hpp"

#include <hgrid/hgrid.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dem {

// One row per contact of the present list, carried over from list to list by the library's contact history.
template <int D, class Real>
class ContactMemory {
 public:
  explicit ContactMemory(EffectSet effects) : slips_(has(effects, kFriction)), rolls_(has(effects, kRolling)) {
    if (slips_) history_.emplace();
  }

  // Makes the rows those of this list: old contacts keep theirs, new ones start with zero.
  void follow(PairView pairs) {
    if (!slips_) return;
    history_->update(pairs.size(), pairs.data());
    carry(slip_, pairs.size());
    if (rolls_) carry(roll_, pairs.size());
  }

  Vec<D, Real> *slip() { return slip_.data(); }
  Vec<D, Real> *roll() { return roll_.data(); }
  size_t bytes() const { return sizeof(Vec<D, Real>) * (slip_.capacity() + roll_.capacity() + old_.capacity()); }

  void save(const std::string &name, Checkpoint &checkpoint) const {
    if (!slips_) return;
    const PairView pairs = history_->pairs();
    checkpoint.put(name + " pairs", pairs.data(), pairs.size());
    checkpoint.put(name + " slip", slip_);
    checkpoint.put(name + " roll", roll_);
  }

  void restore(const std::string &name, const Checkpoint &checkpoint) {
    if (!slips_) return;
    std::vector<hg_pair> pairs;
    checkpoint.get_all(name + " pairs", pairs);
    history_->restore(pairs.size(), pairs.data());
    slip_.resize(pairs.size());
    checkpoint.get(name + " slip", slip_);
    roll_.resize(rolls_ ? pairs.size() : 0);
    checkpoint.get(name + " roll", roll_);
  }

 private:
  void carry(std::vector<Vec<D, Real>> &rows, size_t count) {
    old_.swap(rows);
    rows.resize(count);
    history_->carry(sizeof(Vec<D, Real>), old_.data(), rows.data());
  }

  bool slips_, rolls_;
  std::optional<hgrid::History> history_;
  std::vector<Vec<D, Real>> slip_, roll_, old_;
};

}  // namespace dem
