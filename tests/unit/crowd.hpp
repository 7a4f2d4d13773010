// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A built index over random particles of many sizes, for tests of what searches it.
#pragma once

#include "src/exact/overlap.hpp"
#include "src/index/build_index.hpp"
#include "src/particles/bounds.hpp"
#include "src/search/search_tasks.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/rng.hpp"
#include "tests/unit/domains.hpp"
#include "tests/unit/stores.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hgtest {

// All but kEven make the index chunked, if there are enough particles.
enum class Filling {
  kEven,
  kOutlier,  // one particle far away
  kCorner    // all around a corner of the box: one place where it is periodic, else several far apart
};

struct CrowdShape {
  int dimension = 3;
  bool periodic = false;
  double tilt[3] = {0, 0, 0};  // in lengths
  Filling filling = Filling::kEven;
  size_t count = 0;
  hg::Interaction interaction;
  double skin = 0;  // by which the reach of the index is wider
};

inline CrowdShape any_shape(Rng &rng, size_t count) {
  CrowdShape shape;
  shape.dimension = rng.integer(2, 3);
  shape.periodic = rng.chance(0.5);
  if (shape.periodic && rng.chance(0.5)) {
    for (int k = 0; k < (shape.dimension == 3 ? 3 : 1); k++) shape.tilt[k] = rng.chance(0.3) ? 0 : rng.uniform(-2, 2);
  }
  if (rng.chance(0.4)) shape.filling = shape.periodic || rng.chance(0.5) ? Filling::kCorner : Filling::kOutlier;
  shape.count = count;
  return shape;
}

class Crowd {
 public:
  static constexpr double kEdge = 100;  // of the box

  Crowd(uint64_t seed, hg::Memory &memory, const CrowdShape &shape)
      : Crowd(memory, box_of(shape), shape.interaction, shape.skin, particles_of(seed, shape)) {}
  Crowd(hg::Memory &memory, const hg::Domain &domain, const hg::Interaction &interaction, double skin,
        Particles of_particles, double level_ratio = 2)
      : particles(std::move(of_particles)),
        index(memory, domain, interaction.widened(skin)),
        tasks(memory),
        store(make_store(memory, domain, interaction)),
        overlap(interaction, HG_EXACT, domain),
        scratch_(memory),
        level_ratio_(level_ratio) {
    store.insert(particles.count(), particles.centers.data(), particles.radii.data());
    build(1);
  }

  void build(int threads) {
    const hg::Bounds bounds = hg::bounds_of(store, index.domain, threads);
    const double coarsest = index.interaction.diameter(bounds.max_radius);
    double sizes[4] = {0, 0, 0, coarsest};
    for (int h = 3; h > 0; h--) sizes[h - 1] = sizes[h] / level_ratio_;
    if (store.slots() > 0) index.map = hg::FixedPoint::over(bounds, index.domain, coarsest);
    hg::build_index(index, scratch_, store, hg::user_levels(sizes, 4, index.interaction), threads);
    tasks.list(index);
  }

  // Puts the particles of the store where those of `particles` are; the index stays.
  void move() { store.move(particles.count(), particles.centers.data(), particles.radii.data()); }

  // The truth.
  hg_grid_def rule() const { return rule_of(index.domain, overlap.interaction()); }
  Pairs pairs() const { return all_pairs(rule(), particles, exact_interact); }

 private:
  static hg::Domain box_of(const CrowdShape &shape) {
    hg::Domain domain = open_space(shape.dimension);
    for (int axis = 0; axis < shape.dimension; axis++) set_box(domain, axis, 0, kEdge, shape.periodic);
    for (int k = 0; k < 3; k++) domain.tilt[k] = kEdge * shape.tilt[k];
    return domain;
  }

  static Particles particles_of(uint64_t seed, const CrowdShape &shape) {
    Rng rng(seed);
    Particles particles;
    particles.dimension = shape.dimension;
    const double edge = std::pow(static_cast<double>(shape.count), 1.0 / shape.dimension);
    const bool corner = shape.filling == Filling::kCorner;
    const double filled = corner ? 0.05 * kEdge : kEdge;
    for (size_t i = 0; i < shape.count; i++) {
      double center[3];
      for (double &x : center) {
        x = corner ? std::fmod(kEdge + filled * (rng.uniform() - 0.5), kEdge) : kEdge * rng.uniform();
      }
      if (shape.filling == Filling::kOutlier && i == 0) center[0] = 1e9;
      // A periodic box allows no reach above half its edge.
      particles.add(center, filled * std::min(0.3 / std::sqrt(1 - 0.99 * rng.uniform()) / edge, 0.2));
    }
    return particles;
  }

 public:
  Particles particles;
  hg::Index index;
  hg::SearchTasks tasks;
  hg::ParticleStore store;
  hg::Overlap overlap;

 private:
  hg::BuildScratch scratch_;
  double level_ratio_;  // of the cell sizes of two levels
};

}  // namespace hgtest
