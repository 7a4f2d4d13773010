// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which skin pays.
#pragma once

#include "src/exact/domain.hpp"
#include "src/exact/interaction.hpp"
#include "src/space/bounds.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

// More candidates than that cost more to keep and to filter than most searches.
inline constexpr size_t kMostCandidatesPerParticle = 256;

// A skin of fewer quanta is eaten up by what the fixed-point places are off by.
inline constexpr double kLeastQuanta = 64;

// The widest skin up to `wanted` that candidates can be collected with in this system; 0 if none is worth it.
double usable_skin(double wanted, const Interaction &interaction, const Domain &domain, const Bounds &bounds,
                   int32_t accuracy, size_t particles);

}  // namespace hg
