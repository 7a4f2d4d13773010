// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What contacts remember from step to step: the stretch of their tangential springs.
#pragma once

#include "dem/effects/contact_force.hpp"
#include "dem/state/checkpoint.hpp"
#include "dem/state/contact_search.hpp"

#include <hgrid/hgrid.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace dem {

// For each effect with history one row per contact of the present list, carried over from list to list by the library's
// contact history.
template <int D, class Real>
class ContactHistory {
 public:
  explicit ContactHistory(EffectSet effects) : effects_(effects & effects_with_history()) {
    if (effects_ != 0) history_.emplace();
  }

  // Makes the rows those of this list: old contacts keep theirs, new ones start with zero.
  void follow(PairView pairs) {
    if (effects_ == 0) return;
    history_->update(pairs.size(), pairs.data());
    for (const EffectRow &row : kEffects) {
      if (!has(effects_, row.effect)) continue;
      Rows &rows = rows_[history_of(row.effect)];
      old_.swap(rows);
      rows.resize(pairs.size());
      history_->carry(sizeof rows.front(), old_.data(), rows.data());
    }
  }

  // By history_of(effect); null where there are none.
  std::array<Vec<D, Real> *, kHistoryCount> rows() {
    std::array<Vec<D, Real> *, kHistoryCount> result;
    for (size_t k = 0; k < kHistoryCount; k++) result[k] = rows_[k].data();
    return result;
  }

  size_t bytes() const {
    size_t count = old_.capacity();
    for (const Rows &rows : rows_) count += rows.capacity();
    return sizeof(Vec<D, Real>) * count;
  }

  void save(const std::string &name, Checkpoint &checkpoint) const {
    if (effects_ == 0) return;
    const PairView pairs = history_->pairs();
    checkpoint.put(name + " pairs", pairs.data(), pairs.size());
    for (const EffectRow &row : kEffects) {
      if (is_saved(row)) checkpoint.put(name + " " + row.history, rows_[history_of(row.effect)]);
    }
  }

  void restore(const std::string &name, const Checkpoint &checkpoint) {
    if (effects_ == 0) return;
    std::vector<hg_pair> pairs;
    checkpoint.get_all(name + " pairs", pairs);
    history_->restore(pairs.size(), pairs.data());
    for (const EffectRow &row : kEffects) {
      if (!is_saved(row)) continue;
      Rows &rows = rows_[history_of(row.effect)];
      rows.resize(has(effects_, row.effect) ? pairs.size() : 0);
      checkpoint.get(name + " " + row.history, rows);
    }
  }

 private:
  using Rows = std::vector<Vec<D, Real>>;

  // Checkpoints have no rows, under its name, of an effect that is off where what it needs is on.
  bool is_saved(const EffectRow &row) const { return row.history != nullptr && has(effects_, row.effect | row.needs); }

  EffectSet effects_;
  std::optional<hgrid::History> history_;
  std::array<Rows, kHistoryCount> rows_;
  Rows old_;
};

}  // namespace dem
