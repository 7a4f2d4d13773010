// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Random sequences of insert, move, remove and clear, with queries in between, against a plain list of the particles.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <algorithm>

namespace {

using namespace hgtest;

// A grid and what it must hold, driven by one random stream.
class Walk {
 public:
  Walk(uint64_t seed, double skin) : rng_(seed), scene_(any_scene(rng_, 120)) {
    scene_.def.skin = skin;
    pool_ = scene_.particles;
    live_.dimension = pool_.dimension;
    grid_ = Grid(scene_.def);
    next_id_ = scene_.def.index_base;
  }

  void run(int steps) {
    for (int step = 0; step < steps; step++) {
      const int action = rng_.integer(0, 9);
      if (action < 3) {
        insert();
      } else if (action < 6) {
        move();
      } else if (action < 8) {
        remove();
      } else if (action == 8 && rng_.chance(0.2)) {
        clear();
      } else if (action == 9) {
        grid_.build();
      }
      if (rng_.chance(0.7)) compare();
    }
    compare();
  }

 private:
  // Particles come from the pool of the scene, so that boxes and user cells always fit them.
  size_t any_of_pool() { return rng_.below(pool_.count()); }

  void insert() {
    Particles batch;
    batch.dimension = pool_.dimension;
    const int count = rng_.integer(0, 40);
    for (int k = 0; k < count; k++) {
      batch.add(pool_.center(any_of_pool()), pool_.radii[any_of_pool()]);
      live_.add(batch.center(batch.count() - 1), batch.radii.back());
      ids_.push_back(next_id_++);
    }
    grid_.insert(batch.count(), batch.centers.data(), batch.radii.data());
  }

  // Small steps, jumps, or new radii as well.
  void move() {
    const bool jump = rng_.chance(0.3);
    const bool new_radii = rng_.chance(0.4);
    const size_t dimension = static_cast<size_t>(live_.dimension);
    for (size_t i = 0; i < live_.count(); i++) {
      if (jump) {
        std::copy_n(pool_.center(any_of_pool()), dimension, &live_.centers[i * dimension]);
      } else {
        for (size_t k = 0; k < dimension; k++) {
          live_.centers[i * dimension + k] += rng_.uniform(-0.3, 0.3) * live_.radii[i];
        }
      }
      if (new_radii) live_.radii[i] = pool_.radii[any_of_pool()];
    }
    grid_.move(live_.count(), live_.centers.data(), new_radii ? live_.radii.data() : nullptr);
  }

  void remove() {
    std::vector<int32_t> gone;
    const double share = rng_.chance(0.1) ? 1 : rng_.uniform(0, 0.5);
    Particles left;
    left.dimension = live_.dimension;
    std::vector<int32_t> left_ids;
    for (size_t i = 0; i < live_.count(); i++) {
      if (rng_.chance(share)) {
        gone.insert(gone.begin() + static_cast<ptrdiff_t>(rng_.below(gone.size() + 1)), ids_[i]);
      } else {
        left.add(live_.center(i), live_.radii[i]);
        left_ids.push_back(ids_[i]);
      }
    }
    grid_.remove(gone.size(), gone.data());
    live_ = left;
    ids_ = left_ids;
  }

  void clear() {
    grid_.clear();
    live_ = Particles();
    live_.dimension = pool_.dimension;
    ids_.clear();
    next_id_ = scene_.def.index_base;
  }

  void compare() {
    require_same(scene_.name.c_str(), sorted_pairs_of(grid_), all_pairs(scene_.def, live_, ids_, exact_interact));
    require(grid_.get_stats().particle_count == static_cast<int64_t>(live_.count()), "wrong number of live particles");
  }

  Rng rng_;
  Scene scene_;
  Particles pool_;
  Particles live_;
  std::vector<int32_t> ids_;
  int32_t next_id_ = 0;
  Grid grid_;
};

void any_sequence(void **) {
  assert_true(sweep(150, [](uint64_t seed) { Walk(seed, 0).run(25); }));
}

// The skin saves searches while particles move little; the answers are the same.
void any_sequence_with_skin(void **) {
  assert_true(sweep(100, [](uint64_t seed) { Walk(500 + seed, seed % 2 == 0 ? 0.1 : 1e-5).run(25); }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_sequence), cmocka_unit_test(any_sequence_with_skin)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
