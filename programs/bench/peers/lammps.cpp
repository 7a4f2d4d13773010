// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// LAMMPS through its library: the half neighbour list of granular spheres, styles `bin` and `multi`.
#include "programs/bench/peers/lammps_session.hpp"
#include "programs/bench/peers/peer.hpp"

#include <lammps/library.h>

#include <memory>
#include <stdexcept>

namespace bench {
namespace {

// One LAMMPS with all particles as atoms. It keeps them sorted in space from one run to the next, as in a simulation.
class Instance {
 public:
  // collections: 0 for the style `bin`, else their number for `multi`.
  Instance(const Particles &particles, int collections);

  void find(std::vector<hg_pair> &pairs);

 private:
  void put_particles_in_place();
  void collect(std::vector<hg_pair> &pairs) const;

  Particles particles_;
  std::vector<Sphere> spheres_;
  LammpsSession lammps_;
};

Instance::Instance(const Particles &particles, int collections)
    : particles_(particles), lammps_(particles, "/dev/stderr") {
  lammps_.sort_atoms_every(1);
  lammps_.command("pair_style gran/hooke 1 NULL 0 NULL 0 0");
  lammps_.command("pair_coeff * *");
  const double smallest = *std::min_element(particles.radii, particles.radii + particles.count);
  lammps_.choose_neighbor_list(1e-9 * smallest, collections);
  lammps_.command("neigh_modify delay 0 every 1 check no");
}

void Instance::put_particles_in_place() {
  const int *tags = lammps_.tags();
  double **x = lammps_.vectors("x");
  double *radius = lammps_.scalars("radius");
  for (size_t i = 0; i < particles_.count; i++) {
    const size_t particle = static_cast<size_t>(tags[i]) - 1;
    for (size_t k = 0; k < 3; k++) x[i][k] = particles_.centers[3 * particle + k];
    radius[i] = particles_.radii[particle];
  }
}

void Instance::collect(std::vector<hg_pair> &pairs) const {
  const int *tags = lammps_.tags();
  const int list = lammps_find_pair_neighlist(lammps_.handle(), "gran/hooke", 1, 0, 0);
  if (list < 0) throw std::runtime_error("LAMMPS has no neighbour list");
  const int rows = lammps_neighlist_num_elements(lammps_.handle(), list);
  for (int row = 0; row < rows; row++) {
    int atom = 0, count = 0, *neighbors = nullptr;
    lammps_neighlist_element_neighbors(lammps_.handle(), list, row, &atom, &count, &neighbors);
    for (int k = 0; k < count; k++) keep_if_overlapping(spheres_, tags[atom] - 1, tags[neighbors[k]] - 1, pairs);
  }
}

// A run of no steps: it sorts the atoms, builds the list and sums forces once; there is no command for the list alone.
void Instance::find(std::vector<hg_pair> &pairs) {
  copy_spheres(particles_, spheres_);
  put_particles_in_place();
  lammps_.command("run 0 post no");
  collect(pairs);
}

Peer peer(const char *name, const std::string &variant, int collections) {
  return {name, variant, [collections](const Particles &particles) -> PairFinder {
            const auto [smallest, largest] = std::minmax_element(particles.radii, particles.radii + particles.count);
            if (collections > 0 && !(*largest > 1.01 * *smallest)) return nullptr;  // all sizes are one
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
