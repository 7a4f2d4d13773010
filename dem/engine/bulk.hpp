// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Averages over the box: stress, fabric, coordination, granular temperature.
//
//   stress    V s = sum over contacts of (force on b) (branch from a to b) + sum over particles of m c c
//             walls: the branch reaches from the centre to the contact (Love 1927; Weber 1966)
//   c         velocity less the mean of all that can move; with shear less the profile of it instead
//   rattlers  particles with fewer than D + 1 contacts, D with friction, and then those that these leave so
#pragma once

#include "dem/engine/contact_loads.hpp"

#include <vector>

namespace dem {

// Without a box on all axes there is no volume: the stress is then multiplied by it.
template <int D>
Bulk measure_bulk(const Setup &setup, const Snapshot &state, const std::vector<ContactLoad<D>> &loads);

}  // namespace dem
