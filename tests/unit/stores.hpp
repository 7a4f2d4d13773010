// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A store of particles for tests, checked by the rules that are given.
#pragma once

#include "src/particles/particle_store.hpp"

#include <limits>

namespace hgtest {

inline hg::ParticleStore make_store(hg::Memory &memory, const hg::Domain &domain,
                                    const hg::Interaction &interaction = {}, int32_t index_base = 0,
                                    double largest_diameter = std::numeric_limits<double>::infinity(),
                                    int threads = 1) {
  return {memory, hg::InputCheck(domain, interaction, largest_diameter, threads), hg::ShortCell(domain, interaction),
          domain.dimension, index_base};
}

}  // namespace hgtest
