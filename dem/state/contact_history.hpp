// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What contacts remember from step to step, where lists of pairs come and go: the stretch of their tangential springs.
#pragma once

#include "dem/effects/contact_force.hpp"
#include "dem/state/checkpoint.hpp"
#include "dem/state/contact_search.hpp"

#include <hgrid/hgrid.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace dem {

// A part of a list of pairs that one thread looks at: places first .. last - 1. Of copies, `sources` says which places
// of the list they come from.
struct ListPart {
  size_t first, last;
  const uint32_t *sources;
};

// Contacts by their pairs, ascending, and their rows by history_of(effect).
template <int D, class Real>
struct ContactRows {
  std::vector<hg_pair> pairs;
  std::array<std::vector<Vec<D, Real>>, kHistoryCount> rows;

  // Keeps its memory.
  void clear() {
    pairs.clear();
    for (auto &contacts : rows) contacts.clear();
  }

  // Where a pair stands; pairs.size(): nowhere.
  size_t find(const hg_pair &pair) const {
    const auto before = [](const hg_pair &x, const hg_pair &y) { return x.a != y.a ? x.a < y.a : x.b < y.b; };
    const auto place = std::lower_bound(pairs.begin(), pairs.end(), pair, before);
    const bool found = place != pairs.end() && !before(pair, *place);
    return found ? static_cast<size_t>(place - pairs.begin()) : pairs.size();
  }
};

// When a list ends its contacts are packed, and the library's contact history finds their places in the next one.
template <int D, class Real>
class ContactHistory {
 public:
  explicit ContactHistory(EffectSet effects) : effects_(effects & effects_with_history()) {}

  // What contacts remember when the simulation begins; of an effect that nothing is known of, nothing.
  void begin(const ContactMemory &memory) {
    unpacked_ = false;
    if (effects_ == 0) return;
    packed_.pairs = memory.pairs;
    for_rows([&](size_t row) {
      const std::vector<double> &known = memory.rows[row];
      auto &rows = packed_.rows[row];
      rows.assign(packed_.pairs.size(), Vec<D, Real>::Zero());
      for (size_t p = 0; p < rows.size() && !known.empty(); p++) {
        rows[p] = vector_at<Vec<D, double>>(known, p).template cast<Real>();
      }
    });
  }

  ContactMemory memory_of(PairView list) const {
    const ContactRows<D, Real> known = contacts_of(list);
    ContactMemory memory;
    memory.pairs = known.pairs;
    for (size_t k = 0; k < kHistoryCount; k++) {
      for (const auto &row : known.rows[k]) memory.rows[k].insert(memory.rows[k].end(), row.data(), row.data() + D);
    }
    return memory;
  }

  // Before `list` ends. Once packed it stays so, until there is a new list.
  void pack(PairView list) {
    if (!unpacked_) return;
    packed_.clear();
    add_all(list, packed_);
    unpacked_ = false;
  }

  // Old contacts keep their rows, new ones start with none. The parts that have no sources are in order, and the list
  // is all of them.
  void unpack(PairView list, const std::vector<ListPart> &parts) {
    unpacked_ = true;
    parts_.resize(parts.size());
    whole_.clear();
    for (const ListPart &part : parts) whole_.push_back(part.sources == nullptr);
    if (effects_ == 0) return;
    hgrid::History history;
    history.restore(packed_.pairs.size(), packed_.pairs.data());
    const hgrid::View<int64_t> former = history.update(list.size(), list.data());
    for (size_t k = 0; k < parts.size(); k++) {
      const ListPart &part = parts[k];
      parts_[k].first = part.first;
      parts_[k].pass = 0;
      for_rows([&](size_t row) {
        auto &rows = parts_[k].rows[row];
        rows.assign(part.last - part.first, {{0, 0, 0, -1}});
        for (size_t p = part.first; p < part.last; p++) {
          const int64_t place = former[part.sources != nullptr ? part.sources[p] : p];
          if (place < 0) continue;
          rows[p - part.first] = {};
          rows[p - part.first].template vector<D>() = packed_.rows[row][static_cast<size_t>(place)];
        }
      });
    }
  }

  History<D, Real> *part(size_t k) { return &parts_[k]; }

  bool remembers(Effect effect) const { return has(effects_, effect); }

  // Those that remember anything; a contact whose rows are 0 is as good as new.
  ContactRows<D, Real> contacts_of(PairView list) const {
    if (!unpacked_) return packed_;
    ContactRows<D, Real> result;
    add_all(list, result);
    return result;
  }

  size_t bytes() const {
    size_t bytes = 0;
    for (const History<D, Real> &part : parts_) {
      for (const auto &rows : part.rows) bytes += sizeof(Row<Real>) * rows.capacity();
    }
    return bytes;
  }

  void save(const std::string &name, PairView list, Checkpoint &checkpoint) const {
    if (effects_ == 0) return;
    const ContactRows<D, Real> packed = contacts_of(list);
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
      auto &rows = packed_.rows[history_of(row.effect)];
      rows.resize(has(effects_, row.effect) ? packed_.pairs.size() : 0);
      checkpoint.get(name + " " + row.history, rows);
    }
  }

 private:
  void add_all(PairView list, ContactRows<D, Real> &result) const {
    for (size_t k = 0; k < parts_.size(); k++) {
      if (whole_[k]) add_contacts(list, parts_[k], result);
    }
  }

  void add_contacts(PairView list, const History<D, Real> &part, ContactRows<D, Real> &result) const {
    for (size_t p = 0; p < part.rows[history_of(kFriction)].size(); p++) {
      if (is_blank(part, p)) continue;
      result.pairs.push_back(list[part.first + p]);
      for_rows([&](size_t row) { result.rows[row].push_back(part.rows[row][p].template vector<D>()); });
    }
  }

  static bool is_blank(const History<D, Real> &part, size_t p) {
    bool blank = true;
    for (const auto &rows : part.rows) {
      if (rows.empty() || rows[p].numbers[3] != part.pass) continue;
      for (int k = 0; k < D; k++) blank = blank && rows[p].numbers[k] == 0 && !std::signbit(rows[p].numbers[k]);
    }
    return blank;
  }

  template <class Visit>
  void for_rows(Visit visit) const {
    for (const EffectRow &row : kEffects) {
      if (has(effects_, row.effect)) visit(history_of(row.effect));
    }
  }

  // Checkpoints have no rows, under its name, of an effect that is off where what it needs is on.
  bool is_saved(const EffectRow &row) const { return row.history != nullptr && has(effects_, row.effect | row.needs); }

  EffectSet effects_;
  bool unpacked_ = false;                // into the parts
  std::vector<History<D, Real>> parts_;  // keep their memory
  std::vector<bool> whole_;              // whether a part is no copy
  ContactRows<D, Real> packed_;
};

}  // namespace dem
