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

namespace hgtest {

// All but kEven make the index chunked, if there are enough particles.
enum class Filling {
  kEven,
  kOutlier,  // one particle far away
  kCorner,   // all around a corner of the box: one place where it is periodic, else several far apart
  kGiants    // as kCorner, and half of them dust
};

struct CrowdShape {
  int dimension = 3;
  bool periodic = false;
  Filling filling = Filling::kEven;
  size_t count = 0;
  hg::Interaction interaction;
  double skin = 0;  // by which the reach of the index is wider
};

inline CrowdShape any_shape(Rng &rng, size_t count) {
  CrowdShape shape;
  shape.dimension = rng.integer(2, 3);
  shape.periodic = rng.chance(0.5);
  if (rng.chance(0.4)) shape.filling = shape.periodic || rng.chance(0.5) ? Filling::kCorner : Filling::kOutlier;
  shape.count = count;
  return shape;
}

class Crowd {
 public:
  static constexpr double kEdge = 100;  // of the box

  Crowd(uint64_t seed, hg::Memory &memory, const CrowdShape &shape)
      : index(memory, domain_of(shape), shape.interaction.widened(shape.skin)),
        tasks(memory),
        store(make_store(memory, index.domain, shape.interaction)),
        overlap(shape.interaction, HG_EXACT, index.domain),
        scratch_(memory) {
    Rng rng(seed);
    particles.dimension = shape.dimension;
    const double edge = std::pow(static_cast<double>(shape.count), 1.0 / shape.dimension);
    const bool corner = shape.filling == Filling::kCorner || shape.filling == Filling::kGiants;
    const double filled = corner ? 0.05 * kEdge : kEdge;
    for (size_t i = 0; i < shape.count; i++) {
      double center[3];
      for (double &x : center)
        x = corner ? std::fmod(kEdge + filled * (rng.uniform() - 0.5), kEdge) : kEdge * rng.uniform();
      if (shape.filling == Filling::kOutlier && i == 0) center[0] = 1e9;
      // A periodic box allows no reach above half its edge.
      const bool giants = shape.filling == Filling::kGiants, dust = giants && rng.chance(0.5);
      const double spread = giants ? 0.9 : 0.99;  // giants share a level or two, dust has the finest one for itself
      const double radius = filled * std::min(0.3 / std::sqrt(1 - spread * rng.uniform()) / edge, 0.2);
      particles.add(center, dust ? 1e-6 * radius : radius);
    }
    store.insert(shape.count, particles.centers.data(), particles.radii.data());
    build(1);
  }

  void build(int threads) {
    const hg::Bounds bounds = hg::bounds_of(store, index.domain, threads);
    const double coarsest = index.interaction.diameter(bounds.max_radius);
    const double sizes[4] = {coarsest / 8, coarsest / 4, coarsest / 2, coarsest};
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
  static hg::Domain domain_of(const CrowdShape &shape) {
    hg::Domain domain = open_space(shape.dimension);
    for (int axis = 0; axis < shape.dimension; axis++) set_box(domain, axis, 0, kEdge, shape.periodic);
    return domain;
  }

 public:
  Particles particles;
  hg::Index index;
  hg::SearchTasks tasks;
  hg::ParticleStore store;
  hg::Overlap overlap;

 private:
  hg::BuildScratch scratch_;
};

}  // namespace hgtest
