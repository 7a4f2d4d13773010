// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Energies, momenta and overlaps of a state, in double whatever the state is kept in.
#pragma once

#include "dem/engine/contact_loads.hpp"
#include "dem/engine/engine.hpp"

#include <vector>

namespace dem {

template <int D>
Measurement measure_state(const Setup &setup, const Snapshot &state, const std::vector<ContactLoad<D>> &loads);

}  // namespace dem
