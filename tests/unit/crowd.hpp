// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A built index over random particles of many sizes, for tests of what searches it.
#pragma once

#include "src/exact/overlap.hpp"
#include "src/index/build_index.hpp"
#include "src/particles/bounds.hpp"
#include "src/search/search_tasks.hpp"
#include "tests/support/rng.hpp"
#include "tests/unit/stores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace hgtest {

struct CrowdShape {
  int dimension = 3;
  bool periodic = false;
  bool outlier = false;  // one particle far away, which makes levels sparse
  size_t count = 0;
  int threads = 1;  // to build with
};

class Crowd {
 public:
  Crowd(uint64_t seed, hg::Memory &memory, const CrowdShape &shape)
      : domain_(domain_of(shape)),
        index(memory, domain_, interaction_),
        tasks(memory),
        scratch_(memory),
        store(make_store(memory, domain_, interaction_)),
        overlap(interaction_, HG_EXACT, domain_) {
    Rng rng(seed);
    std::vector<double> centers, radii;
    const double edge = std::pow(static_cast<double>(shape.count), 1.0 / shape.dimension);
    for (size_t i = 0; i < shape.count; i++) {
      for (int k = 0; k < shape.dimension; k++) centers.push_back(domain_.length[k] * rng.uniform());
      // No larger than a quarter of the box, as a periodic one allows.
      radii.push_back(std::min(0.3 / std::sqrt(1 - 0.99 * rng.uniform()) / edge, 0.24) * domain_.length[0]);
    }
    if (shape.outlier && shape.count > 0) centers[0] = 1e9;
    store.insert(shape.count, centers.data(), radii.data());
    build(shape.threads);
  }

  void build(int threads) {
    const hg::Bounds bounds = hg::bounds_of(store, domain_, threads);
    const double finest = 2 * bounds.max_radius / 8;
    const double sizes[4] = {finest, 2 * finest, 4 * finest, 8 * finest};
    if (store.slots() > 0) index.map = hg::FixedPoint::over(bounds, domain_, 2 * bounds.max_radius);
    hg::build_index(index, scratch_, store, hg::user_levels(sizes, 4, interaction_), threads);
    tasks.list(index);
  }

 private:
  static hg::Domain domain_of(const CrowdShape &shape) {
    hg::Domain domain;
    domain.dimension = shape.dimension;
    domain.any_periodic = shape.periodic;
    for (int k = 0; k < shape.dimension; k++) {
      domain.periodic[k] = shape.periodic;
      domain.box_max[k] = domain.length[k] = 100;
    }
    return domain;
  }

  hg::Domain domain_;
  hg::Interaction interaction_;

 public:
  hg::Index index;
  hg::SearchTasks tasks;

 private:
  hg::BuildScratch scratch_;

 public:
  hg::ParticleStore store;
  hg::Overlap overlap;
};

}  // namespace hgtest
