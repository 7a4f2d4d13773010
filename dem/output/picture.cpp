// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The state of a simulation as a set of particles.
#include "dem/output/picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace output {
namespace {

void copy_box(const dem::Setup &setup, particles::ParticleSet &set) {
  set.has_box = setup.box_max[0] > setup.box_min[0];
  std::copy_n(setup.box_min, 3, set.box_min);
  std::copy_n(setup.box_max, 3, set.box_max);
  if (setup.dimension == 2) set.box_max[2] = set.box_min[2] + 1;  // viewers take no flat box
  for (int axis = 0; axis < 3; axis++) set.periodic[axis] = setup.periodic[axis] ? 1 : 0;
}

// In two dimensions spins point along z.
std::vector<double> spin_vectors(dem::Snapshot &state) {
  if (state.dimension == 3) return std::move(state.spins);
  std::vector<double> result;
  for (const double spin : state.spins) result.insert(result.end(), {0.0, 0.0, spin});
  return result;
}

}  // namespace

particles::ParticleSet picture_of(const dem::Setup &setup, uint64_t step, dem::Snapshot state) {
  particles::ParticleSet set;
  set.dimension = state.dimension;
  set.moment = {step, state.time};
  copy_box(setup, set);
  // Of all tilts of the same lattice the least: LAMMPS takes no other.
  if (state.image_offset != 0) set.tilt[0] = std::remainder(state.image_offset, setup.box_max[0] - setup.box_min[0]);
  set.columns.push_back({"velocity", 3, particles::in_three_dimensions(std::move(state.velocities), state.dimension)});
  set.columns.push_back({"mass", 1, std::move(state.masses)});
  if (!state.spins.empty()) set.columns.push_back({"spin", 3, spin_vectors(state)});
  if (!state.material_ids.empty())
    set.columns.push_back({"material", 1, {state.material_ids.begin(), state.material_ids.end()}});
  set.centers = std::move(state.centers);
  set.radii = std::move(state.radii);
  return set;
}

}  // namespace output
