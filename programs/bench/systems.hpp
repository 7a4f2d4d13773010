// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The particles that are measured: read from a file or made for the occasion.
#pragma once

#include "particles/particle_set.hpp"

#include <string>

namespace bench {

struct System {
  std::string name;  // the law, or ARRANGEMENT-LAW, or the file's name without folder and ending
  particles::ParticleSet particles;

  double size_ratio() const;  // largest over smallest radius
};

// A file, or LAW:RATIO:COUNT[:ARRANGEMENT] for a packing that is made here and now: the size laws (log-normal: its
// sigma for RATIO) and arrangements of `hgrid pack` at its densities, in random order; even ones are thrown at random
// and relaxed by `sweeps` sweeps only. Throws std::exception if there is no such file, law or arrangement, or no
// particle.
System load_system(const std::string &source, int sweeps);

// All axes are taken as open.
void open_axes(System &system);

}  // namespace bench
