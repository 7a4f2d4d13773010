// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Commands that every use of LAMMPS begins with.
#include "programs/bench/peers/lammps_session.hpp"

#include <lammps/library.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {
namespace {

// Of the list for spheres: what a particle may have, and a page of neighbours, which must hold ten particles' at least.
constexpr int kMostNeighbors = 200000;
constexpr int kPage = 10 * kMostNeighbors;

}  // namespace

LammpsSession::LammpsSession(const Particles &particles, const char *screen) {
  std::string words[] = {"lammps", "-log", "none", "-screen", screen, "-nocite"};
  char *arguments[6];
  for (int k = 0; k < 6; k++) arguments[k] = words[k].data();
  handle_ = lammps_open_no_mpi(6, arguments, nullptr);
  if (handle_ == nullptr) throw std::runtime_error("LAMMPS does not start");
  const auto [smallest, largest] = std::minmax_element(particles.radii, particles.radii + particles.count);
  smallest_ = *smallest;
  largest_ = *largest;
  command("units si");
  command("atom_style sphere");
  command("newton on");
  command("comm_modify vel yes");  // granular pairs ask for it, though nothing is communicated here
  command("boundary f f f");
  create_box(particles);
  create_atoms(particles);
}

LammpsSession::~LammpsSession() {
  lammps_close(handle_);
  lammps_mpi_finalize();
}

void LammpsSession::send(const char *text) { lammps_command(handle_, text); }

void *LammpsSession::property(const char *name) const { return lammps_extract_atom(handle_, name); }

void LammpsSession::create_box(const Particles &particles) {
  double low[3], high[3];
  for (size_t k = 0; k < 3; k++) {
    low[k] = high[k] = particles.centers[k];
    for (size_t i = 1; i < particles.count; i++) {
      low[k] = std::min(low[k], particles.centers[3 * i + k]);
      high[k] = std::max(high[k], particles.centers[3 * i + k]);
    }
  }
  // About one atom to a bin of the sort, whatever the largest size.
  const double volume = (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
  sort_bin_ = std::cbrt(volume / static_cast<double>(particles.count));
  const double rim = 0.01 * (high[0] - low[0]) + largest_;
  command("region all block %.17g %.17g %.17g %.17g %.17g %.17g", low[0] - rim, high[0] + rim, low[1] - rim,
          high[1] + rim, low[2] - rim, high[2] + rim);
  command("create_box 1 all");
}

void LammpsSession::create_atoms(const Particles &particles) {
  const int count = static_cast<int>(particles.count);
  std::vector<int> types(particles.count, 1);
  std::vector<int> tags(particles.count);
  std::iota(tags.begin(), tags.end(), 1);
  const int made =
      lammps_create_atoms(handle_, count, tags.data(), types.data(), particles.centers, nullptr, nullptr, 0);
  if (made != count)
    throw std::runtime_error("LAMMPS takes " + std::to_string(made) + " of " + std::to_string(count) + " atoms");
}

void LammpsSession::sort_atoms_every(int steps) { command("atom_modify sort %d %.17g", steps, sort_bin_); }

// The intervals of `multi` grow by one factor: Debian's version takes any, but offers no rule of its own.
void LammpsSession::choose_neighbor_list(double skin, int collections) {
  command("neighbor %.17g %s", skin, collections == 0 ? "bin" : "multi");
  command("neigh_modify one %d page %d", kMostNeighbors, kPage);
  if (collections == 0) return;
  std::string text = "neigh_modify collection/interval " + std::to_string(collections);
  for (int k = 1; k <= collections; k++) {
    const double share = static_cast<double>(k) / collections;
    const double diameter = 2 * smallest_ * std::pow(largest_ / smallest_, share);
    char number[32];
    std::snprintf(number, sizeof number, " %.17g", diameter * (1 + 1e-12));
    text += number;
  }
  send(text.c_str());
}

}  // namespace bench
