// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Energies, momenta and overlaps of a state, in double whatever the state is kept in.
//
// Looking is rare, so one function serves all effects and picks each law as it goes.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/state/boundary.hpp"
#include "dem/state/contact_history.hpp"

namespace dem {

// Contacts of one kind and what they remember, by history_of(effect) and contact; empty without the effect.
template <int D>
struct ContactState {
  std::vector<hg_pair> list;
  std::array<std::vector<Vec<D, double>>, kHistoryCount> history;
};

template <int D>
Measurement measure_state(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                          const ContactState<D> &pairs, const ContactState<D> &walls);

}  // namespace dem
