// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What contacts remember from step to step: the stretch of their tangential springs.
#pragma once

#include "dem/base/large_array.hpp"
#include "dem/effects/contact_force.hpp"
#include "dem/state/checkpoint.hpp"
#include "dem/state/contact_search.hpp"

#include <hgrid/hgrid.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace dem {

// For each effect with history one row per pair that may touch, found by its place in the list of those. When that list
// is made anew, what touches now is packed, and the library's contact history finds its places in the new one.
template <int D, class Real>
class ContactHistory {
 public:
  explicit ContactHistory(EffectSet effects) : effects_(effects & effects_with_history()) {}

  // Before `list` ends. Once packed it stays so, until there is a new list.
  void pack(PairView list) {
    if (effects_ != 0 && unpacked_) packed_ = contacts_of(list);
    unpacked_ = false;
  }

  // Old contacts keep their rows, new ones start with zero. `copies` are places in the list whose pairs are looked at
  // twice: their second rows stand behind the others.
  void unpack(PairView list, const std::vector<uint32_t> &copies) {
    unpacked_ = true;
    if (effects_ == 0) return;
    hgrid::History history;
    history.restore(packed_.pairs.size(), packed_.pairs.data());
    history.update(list.size(), list.data());
    met_.assign(list.size() + copies.size(), pass_);
    for (const EffectRow &row : kEffects) {
      if (!has(effects_, row.effect)) continue;
      Rows &rows = rows_[history_of(row.effect)];
      rows.resize(list.size() + copies.size());
      history.carry(sizeof(Vec<D, Real>), packed_.rows[history_of(row.effect)].data(), rows.data());
      for (size_t k = 0; k < copies.size(); k++) rows[list.size() + k] = rows[copies[k]];
    }
  }

  // A pass over all contacts begins; `step`: the time since the last one.
  History<D, Real> next_pass(Real step) {
    pass_++;
    History<D, Real> result{{}, met_.data(), pass_, step};
    for (size_t k = 0; k < kHistoryCount; k++) result.rows[k] = rows_[k].empty() ? nullptr : rows_[k].data();
    return result;
  }

  bool remembers(Effect effect) const { return has(effects_, effect); }

  // What pair p of the list remembers of such an effect.
  Vec<D, Real> row_of(size_t p, Effect effect) const {
    if (met_[p] != pass_) return Vec<D, Real>::Zero();
    return rows_[history_of(effect)][p];
  }

  size_t bytes() const {
    size_t count = 0;
    for (const Rows &rows : rows_) count += rows.capacity();
    return sizeof(Vec<D, Real>) * count + sizeof(uint32_t) * met_.capacity();
  }

  void save(const std::string &name, PairView list, Checkpoint &checkpoint) const {
    if (effects_ == 0) return;
    const Packed packed = unpacked_ ? contacts_of(list) : packed_;
    checkpoint.put(name + " pairs", packed.pairs);
    for (const EffectRow &row : kEffects) {
      if (is_saved(row)) checkpoint.put(name + " " + row.history, packed.rows[history_of(row.effect)]);
    }
  }

  void restore(const std::string &name, const Checkpoint &checkpoint) {
    unpacked_ = false;
    if (effects_ == 0) return;
    checkpoint.get_all(name + " pairs", packed_.pairs);
    for (const EffectRow &row : kEffects) {
      if (!is_saved(row)) continue;
      Rows &rows = packed_.rows[history_of(row.effect)];
      rows.resize(has(effects_, row.effect) ? packed_.pairs.size() : 0);
      checkpoint.get(name + " " + row.history, rows);
    }
  }

 private:
  using Rows = LargeArray<Vec<D, Real>>;

  struct Packed {
    std::vector<hg_pair> pairs;
    std::array<Rows, kHistoryCount> rows;
  };

  // The pairs that remember anything; a contact whose rows are 0 is as good as new.
  Packed contacts_of(PairView list) const {
    Packed result;
    for (size_t p = 0; p < list.size(); p++) {
      if (met_[p] != pass_ || is_blank(p)) continue;
      result.pairs.push_back(list[p]);
      for (size_t k = 0; k < kHistoryCount; k++) {
        if (!rows_[k].empty()) result.rows[k].push_back(rows_[k][p]);
      }
    }
    return result;
  }

  bool is_blank(size_t p) const {
    static const Vec<D, Real> kZero = Vec<D, Real>::Zero();
    bool blank = true;
    for (const Rows &rows : rows_) {
      blank = blank && (rows.empty() || std::memcmp(rows[p].data(), kZero.data(), D * sizeof(Real)) == 0);
    }
    return blank;
  }

  // Checkpoints have no rows, under its name, of an effect that is off where what it needs is on.
  bool is_saved(const EffectRow &row) const { return row.history != nullptr && has(effects_, row.effect | row.needs); }

  EffectSet effects_;
  std::array<Rows, kHistoryCount> rows_;
  LargeArray<uint32_t> met_;  // the last pass in which each pair touched
  uint32_t pass_ = 0;
  Packed packed_;
  bool unpacked_ = false;
};

}  // namespace dem
