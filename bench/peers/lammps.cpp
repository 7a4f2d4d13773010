// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// LAMMPS through its library: the half neighbour list of granular spheres, styles `bin` and `multi`.
#include "peer.hpp"

#include <lammps/library.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace bench {
namespace {

// Of the list for spheres: what a particle may have, and a page of neighbours, which must hold ten particles' at least.
constexpr int kMostNeighbors = 200000;
constexpr int kPage = 10 * kMostNeighbors;

struct Extent {
  double low[3], high[3];
  double smallest, largest;  // radius
};

Extent extent_of(const Particles &particles) {
  const auto [smallest, largest] = std::minmax_element(particles.radii, particles.radii + particles.count);
  Extent extent{{}, {}, *smallest, *largest};
  for (std::size_t k = 0; k < 3; ++k) {
    extent.low[k] = extent.high[k] = particles.centers[k];
    for (std::size_t i = 1; i < particles.count; ++i) {
      extent.low[k] = std::min(extent.low[k], particles.centers[3 * i + k]);
      extent.high[k] = std::max(extent.high[k], particles.centers[3 * i + k]);
    }
  }
  return extent;
}

// One LAMMPS with all particles as atoms. It keeps them sorted in space from one run to the next, as in a simulation.
class Instance {
 public:
  // collections: 0 for the style `bin`, else their number for `multi`.
  Instance(const Particles &particles, int collections);
  ~Instance() {
    lammps_close(handle_);
    lammps_mpi_finalize();
  }
  Instance(const Instance &) = delete;
  Instance &operator=(const Instance &) = delete;

  void find(std::vector<hg_pair> &pairs);

 private:
  template <class... Values>
  void command(const char *format, Values... values) {
    char text[512];
    std::snprintf(text, sizeof text, format, values...);
    lammps_command(handle_, text);
  }
  void create_atoms();
  void choose_neighbor_list(const Extent &extent, int collections);
  void put_particles_in_place();
  void collect(std::vector<hg_pair> &pairs) const;

  Particles particles_;
  std::vector<Sphere> spheres_;
  void *handle_ = nullptr;
};

Instance::Instance(const Particles &particles, int collections) : particles_(particles) {
  std::string words[] = {"lammps", "-log", "none", "-screen", "none", "-nocite"};
  char *arguments[6];
  for (int k = 0; k < 6; ++k) arguments[k] = words[k].data();
  handle_ = lammps_open_no_mpi(6, arguments, nullptr);
  if (handle_ == nullptr) throw std::runtime_error("LAMMPS does not start");
  const Extent extent = extent_of(particles);
  const double rim = 0.01 * (extent.high[0] - extent.low[0]) + extent.largest;
  command("units si");
  command("atom_style sphere");
  command("newton on");
  command("comm_modify vel yes");  // granular pairs ask for it, though nothing is communicated here
  command("boundary f f f");
  // About one atom to a bin of the sort, whatever the largest size.
  const double volume =
      (extent.high[0] - extent.low[0]) * (extent.high[1] - extent.low[1]) * (extent.high[2] - extent.low[2]);
  command("atom_modify sort 1 %.17g", std::cbrt(volume / static_cast<double>(particles.count)));
  command("region all block %.17g %.17g %.17g %.17g %.17g %.17g", extent.low[0] - rim, extent.high[0] + rim,
          extent.low[1] - rim, extent.high[1] + rim, extent.low[2] - rim, extent.high[2] + rim);
  command("create_box 1 all");
  create_atoms();
  command("pair_style gran/hooke 1 NULL 0 NULL 0 0");
  command("pair_coeff * *");
  choose_neighbor_list(extent, collections);
}

void Instance::create_atoms() {
  const int count = static_cast<int>(particles_.count);
  std::vector<int> types(particles_.count, 1);
  std::vector<int> tags(particles_.count);
  std::iota(tags.begin(), tags.end(), 1);
  const int made =
      lammps_create_atoms(handle_, count, tags.data(), types.data(), particles_.centers, nullptr, nullptr, 0);
  if (made != count)
    throw std::runtime_error("LAMMPS takes " + std::to_string(made) + " of " + std::to_string(count) + " atoms");
}

// The intervals of `multi` grow by one factor: Debian's version takes any, but offers no rule of its own.
void Instance::choose_neighbor_list(const Extent &extent, int collections) {
  command("neighbor %.17g %s", 1e-9 * extent.smallest, collections == 0 ? "bin" : "multi");
  command("neigh_modify delay 0 every 1 check no one %d page %d", kMostNeighbors, kPage);
  if (collections == 0) return;
  std::string text = "neigh_modify collection/interval " + std::to_string(collections);
  for (int k = 1; k <= collections; ++k) {
    const double share = static_cast<double>(k) / collections;
    const double diameter = 2 * extent.smallest * std::pow(extent.largest / extent.smallest, share);
    char number[32];
    std::snprintf(number, sizeof number, " %.17g", diameter * (1 + 1e-12));
    text += number;
  }
  lammps_command(handle_, text.c_str());
}

void Instance::put_particles_in_place() {
  const auto *tags = static_cast<const int *>(lammps_extract_atom(handle_, "id"));
  auto **x = static_cast<double **>(lammps_extract_atom(handle_, "x"));
  auto *radius = static_cast<double *>(lammps_extract_atom(handle_, "radius"));
  for (std::size_t i = 0; i < particles_.count; ++i) {
    const std::size_t particle = static_cast<std::size_t>(tags[i]) - 1;
    for (std::size_t k = 0; k < 3; ++k) x[i][k] = particles_.centers[3 * particle + k];
    radius[i] = particles_.radii[particle];
  }
}

void Instance::collect(std::vector<hg_pair> &pairs) const {
  const auto *tags = static_cast<const int *>(lammps_extract_atom(handle_, "id"));
  const int list = lammps_find_pair_neighlist(handle_, "gran/hooke", 1, 0, 0);
  if (list < 0) throw std::runtime_error("LAMMPS has no neighbour list");
  const int rows = lammps_neighlist_num_elements(handle_, list);
  for (int row = 0; row < rows; ++row) {
    int atom = 0, count = 0, *neighbors = nullptr;
    lammps_neighlist_element_neighbors(handle_, list, row, &atom, &count, &neighbors);
    for (int k = 0; k < count; ++k) keep_if_overlapping(spheres_, tags[atom] - 1, tags[neighbors[k]] - 1, pairs);
  }
}

// A run of no steps: it sorts the atoms, builds the list and sums forces once; there is no command for the list alone.
void Instance::find(std::vector<hg_pair> &pairs) {
  copy_spheres(particles_, spheres_);
  put_particles_in_place();
  lammps_command(handle_, "run 0 post no");
  collect(pairs);
}

Peer peer(const char *name, const std::string &variant, int collections) {
  return {name, variant, [collections](const Particles &particles) -> PairFinder {
            const Extent extent = extent_of(particles);
            if (collections > 0 && !(extent.largest > 1.01 * extent.smallest)) return nullptr;  // all sizes are one
            auto instance = std::make_shared<Instance>(particles, collections);
            return [instance](std::vector<hg_pair> &pairs) { instance->find(pairs); };
          }};
}

}  // namespace

void add_lammps(std::vector<Peer> &peers) {
  peers.push_back(peer("lammps-bin", "", 0));
  for (const int collections : {2, 3, 4, 5, 6, 8}) {
    peers.push_back(peer("lammps-multi", "collections-" + std::to_string(collections), collections));
  }
}

}  // namespace bench
