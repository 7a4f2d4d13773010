// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where particles lie: evenly in a box, or as unevenly as worlds are.
#pragma once

#include "packing/arrangements/places.hpp"

#include <string>
#include <vector>

namespace packing {

struct Arrangement {
  const char *name;    // the word of `hgrid pack --arrangement`
  const char *places;  // where particles are, in words
  double density;      // the usual one, of what is filled
  // Lays all places; null: even, thrown into a box and pushed apart. Only that takes walls, periodic axes and sweeps.
  void (*lay)(Places &places);
  bool takes_density = true;  // else nothing is filled

  bool is_even() const { return lay == nullptr; }
};

// All arrangements: what is offered, described, refused and laid comes from here. The first is the even one.
const std::vector<Arrangement> &arrangements();

// For help: the usual density, by arrangement where it is another.
std::string usual_densities();

// Throws particles::Error naming it if there is none.
const Arrangement &arrangement_called(const std::string &name);

}  // namespace packing
