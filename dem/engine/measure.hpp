// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Energies, momenta and overlaps of a state, in double whatever the state is kept in.
//
// Looking is rare, so one function serves all effects and asks for them as it goes.
#pragma once

#include "dem/engine/engine.hpp"
#include "dem/state/boundary.hpp"
#include "dem/state/contact_search.hpp"

namespace dem {

// The contacts of a state. The stretches of the springs with memory belong to `pairs` and `walls` one by one,
// [count][D].
template <int D>
struct ContactState {
  PairView pairs, walls;
  std::vector<Vec<D, double>> pair_slip, pair_roll, wall_slip, wall_roll;  // empty without the effect
};

template <int D>
Measurement measure_state(const Setup &setup, const Boundary<D, double> &boundary, const Snapshot &state,
                          const ContactState<D> &contacts);

}  // namespace dem
