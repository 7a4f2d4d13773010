// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Of lists of pairs that may touch those that act on each other in a state, and what they remember.
#pragma once

#include "dem/effects/choice.hpp"
#include "dem/engine/contact_loads.hpp"
#include "dem/state/contact_history.hpp"

#include <cstddef>
#include <vector>

namespace dem {

template <int D>
ContactState<D> pairs_in(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                         PairView list) {
  const auto nearest = choose<kImageEffects, double>(
      setup.effects, [](auto set) { return &Boundary<D, double>::template nearest<decltype(set)::value>; });
  ContactState<D> result;
  for (const hg_pair &pair : list) {
    const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
    Vec<D, double> separation =
        vector_at<Vec<D, double>>(state.centers, b) - vector_at<Vec<D, double>>(state.centers, a);
    (boundary.*nearest)(separation);
    const double reach = state.radii[a] + state.radii[b] + contact_range(setup);
    if (separation.squaredNorm() < reach * reach) result.list.push_back(pair);
  }
  return result;
}

template <int D>
ContactState<D> walls_in(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                         PairView list) {
  ContactState<D> result;
  for (const hg_pair &pair : list) {
    const auto i = static_cast<size_t>(pair.a);
    const double x = state.centers[i * D + static_cast<size_t>(axis_of(pair.b))];
    if (wall_overlap(boundary, x, state.radii[i], pair.b) > -contact_range(setup)) result.list.push_back(pair);
  }
  return result;
}

// What these contacts remember, of a history of `list`. They are called as they are there.
template <int D, class Real>
void add_history(const ContactHistory<D, Real> &history, PairView list, const std::vector<hg_pair> &names,
                 ContactState<D> &contacts) {
  const ContactRows<D, Real> known = history.contacts_of(list);
  for (const EffectRow &row : kEffects) {
    if (row.history == nullptr || !history.remembers(row.effect)) continue;
    const auto &rows = known.rows[history_of(row.effect)];
    size_t next = 0;  // mostly they follow one another in both
    for (const hg_pair &pair : names) {
      const bool here = next < known.pairs.size() && known.pairs[next].a == pair.a && known.pairs[next].b == pair.b;
      const size_t place = here ? next : known.find(pair);
      Vec<D, double> stretch = Vec<D, double>::Zero();
      if (place < rows.size()) {
        stretch = rows[place].template cast<double>();
        next = place + 1;
      }
      contacts.history[history_of(row.effect)].push_back(stretch);
    }
  }
}

}  // namespace dem
