// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Reports of pairs of a former step: particles that moved, grew, were wrapped or removed, and a list that did not
// follow.
#include "tests/reports/rebuild.hpp"

#include <cmath>
#include <utility>

namespace {

using namespace hgtest;

using Lives = std::vector<Life>;

Life life(std::string name, std::vector<Particles> steps, std::vector<size_t> pairs = {}) {
  Life result;
  result.name = std::move(name);
  result.steps = std::move(steps);
  result.pairs = std::move(pairs);
  return result;
}

Life periodic(Life life, double length) {
  for (size_t axis = 0; axis < 3; axis++) {
    life.def.periodic[axis] = 1;
    life.def.box_max[axis] = length;
  }
  return life;
}

// A pair that comes apart stayed in the list.
Lives celllistmap_86() {
  return {periodic(life("apart and back",
                        {spheres({{0, 0, 0}, {0, 0, 0.05}}, 0.05), spheres({{0, 0, 0}, {0, 0, 0.2}}, 0.05),
                         spheres({{0, 0, 0}, {0, 0, 0.95}}, 0.05)},
                        {1, 0, 1}),
                   1)};
}

// All far apart, then two at one place: more neighbours than were made room for.
Lives jax_md_165() {
  return {life("four",
               {spheres({{20, 20, 0}, {30, 30, 0}, {40, 40, 0}, {50, 50, 0}}, 1.5),
                spheres({{20, 20, 0}, {20, 20, 0}, {40, 40, 0}, {50, 50, 0}}, 1.5)},
               {0, 1})};
}

// Radii that change in place, then beyond the cells there were.
Lives aabbcc_5() {
  Rng rng(1);
  const std::vector<Point> centers = cloud(2, 400, {0, 0, 0}, {1, 1, 0.1});
  std::vector<Particles> steps;
  for (const double largest : {0.01, 0.05, 0.001, 0.2}) {
    Particles step;
    for (const Point &center : centers) step.add(center.data(), largest * rng.uniform());
    steps.push_back(step);
  }
  return {life("discs", steps)};
}

// A longer cut-off in the middle of a run.
Lives dissolve_957() {
  const std::vector<Point> atoms = cloud(3, 300, {0, 0, 0}, {12, 12, 12});
  return {periodic(
      life("cut-offs", {spheres(atoms, 0.5), spheres(atoms, 1.25), spheres(atoms, 0.75), spheres(atoms, 3)}), 12)};
}

// A body set down elsewhere, into another and away again, while the others rest.
Lives godot_54855() {
  const Point there = {50, 0, 0}, here = {0, 0, 0}, beside = {0.5, 0, 0};
  return {life("one jumps", {spheres({here, there}, 0.5), spheres({here, beside}, 0.5), spheres({here, there}, 0.5)},
               {0, 1, 0})};
}

// All moved by the same, after the pairs had been asked for.
Lives hoomd_2022() {
  std::vector<Point> atoms = cloud(4, 300, {0, 0, 0}, {8, 8, 8});
  std::vector<Particles> steps;
  for (int step = 0; step < 6; step++) {
    steps.push_back(spheres(atoms, 0.5));
    for (Point &atom : atoms) atom = {atom[0] + 0.3, atom[1] - 0.7, atom[2] + 2.1};
  }
  return {periodic(life("drift", steps), 8)};
}

// Two come near through a face, a little in each step: the image has to follow while the stored list is used, and the
// list must end in time.
Lives librascal_143() {
  std::vector<Particles> steps;
  steps.reserve(60);
  for (int step = 0; step < 60; step++) {
    steps.push_back(spheres({{0.7 - 0.005 * step, 5, 5}, {9.4 + 0.005 * step, 5, 5}, {2, 2, 0.01 * step}}, 0.5));
  }
  return {periodic(life("across a face", steps), 10)};
}

// Atoms that are wrapped into the box now and then: they have hardly moved, their coordinates have.
Lives nvalchemi_toolkit_153() {
  const std::vector<Point> velocities = cloud(8, 200, {-0.02, -0.02, -0.02}, {0.02, 0.02, 0.02});
  std::vector<Point> atoms = cloud(5, 200, {0, 0, 0}, {7, 7, 7});
  std::vector<Particles> steps;
  for (int step = 0; step < 15; step++) {
    steps.push_back(spheres(atoms, 0.5));
    for (size_t i = 0; i < atoms.size(); i++) {
      for (size_t axis = 0; axis < 3; axis++) {
        double &x = atoms[i][axis];
        x += velocities[i][axis];
        if (step % 3 == 2) x -= 7 * std::floor(x / 7);
      }
    }
  }
  return {periodic(life("wrapped", steps), 7)};
}

// Steps much longer than the skin.
Lives ladds_59() {
  std::vector<Particles> steps;
  for (uint64_t step = 0; step < 5; step++) steps.push_back(spheres(cloud(10 + step, 200, {0, 0, 0}, {6, 6, 6}), 0.4));
  return {life("open", steps), periodic(life("periodic", steps), 6)};
}

// The images of those across two faces slide along them, and the cell flips once it leans by half: by whole edges, as
// the sheared faces do.
Lives espresso_5267() {
  Lives lives;
  for (const double step : {0.05, 0.7}) {
    Life life = periodic({}, 8);
    life.name = std::to_string(step);
    std::vector<Point> atoms = cloud(11, 250, {0, 0, 0}, {8, 8, 8});
    for (int k = 0; k < 40; k++) {
      life.def.tilt[0] += step;
      if (life.def.tilt[0] > 4) life.def.tilt[0] -= 8;
      for (Point &atom : atoms) atom[0] += step * atom[1] / 8;
      life.steps.push_back(spheres(atoms, 0.5));
      life.boxes.push_back(life.def);
    }
    life.def = life.boxes[0];
    lives.push_back(life);
  }
  return lives;
}

// A box that shrinks a little in each step, its atoms with it or not: they come nearer than the stored list foresaw.
Lives lammps_1701() {
  Lives lives;
  for (const bool affine : {false, true}) {
    for (const double tilt : {0.0, 2.0}) {
      Life life = periodic({}, 8);
      life.name = affine ? "atoms shrink along" : "atoms stay";
      life.def.tilt[1] = tilt;
      std::vector<Point> atoms = cloud(12, 200, {0, 0, 0}, {8, 8, 8});
      for (int k = 0; k < 40; k++) {
        life.steps.push_back(spheres(atoms, 0.5));
        life.boxes.push_back(life.def);
        const double factor = k < 30 ? 0.995 : 0.97;
        for (double &x : life.def.box_max) x *= factor;
        life.def.tilt[1] *= factor;
        for (Point &atom : atoms) {
          for (double &x : atom) x *= affine ? factor : 1;
        }
      }
      life.def = life.boxes[0];
      lives.push_back(life);
    }
  }
  return lives;
}

// Two atoms at rest in a box that shrinks from 10 to 9: they meet through its faces once it is shorter than 9.5.
Lives jax_md_399() {
  Life life = periodic({}, 10);
  life.name = "through the faces";
  for (int k = 0; k <= 20; k++) {
    for (double &x : life.def.box_max) x = 10 - 0.05 * k;
    life.steps.push_back(spheres({{0.25, 4, 4}, {8.75, 4, 4}}, 0.5));
    life.boxes.push_back(life.def);
    life.pairs.push_back(life.def.box_max[0] < 9.5 ? 1 : 0);
  }
  life.def = life.boxes[0];
  return {life};
}

// Pairs of those that are left, by the ids they had: with holes between them, and with new ones behind.
void require_pairs_of_the_rest(const hg_grid_def &def) {
  const Particles all = spheres(cloud(6, 200, {0, 0, 0}, {7, 7, 7}), 0.5);
  Grid grid = make_grid(def, all);
  require_same("before", sorted_pairs_of(grid), all_pairs(def, all, exact_interact));
  Particles rest;
  std::vector<int32_t> ids, gone;
  const auto keep = [&](const double *center, int32_t id) {
    rest.add(center, 0.5);
    ids.push_back(id);
  };
  for (int32_t id = 0; id < 200; id++) {
    if (id % 3 == 1 || id > 190) {
      gone.push_back(id);
    } else {
      keep(all.center(static_cast<size_t>(id)), id);
    }
  }
  grid.remove(gone.size(), gone.data());
  require_same("with holes", sorted_pairs_of(grid), all_pairs(def, rest, ids, exact_interact));
  const Particles more = spheres(cloud(7, 50, {0, 0, 0}, {7, 7, 7}), 0.5);
  grid.insert(more.count(), more.centers.data(), more.radii.data());
  for (int32_t k = 0; k < 50; k++) keep(more.center(static_cast<size_t>(k)), 200 + k);
  require_same("with more", sorted_pairs_of(grid), all_pairs(def, rest, ids, exact_interact));
}

// Numbers with holes: pairs were lost. Removed particles stayed in stored lists (AutoPas 37, SAPHRON 9).
void espresso_4622(void **) {
  assert_true(holds(0, [](uint64_t) {
    for (const double skin : {0.0, 0.1, 2.0}) {
      for (const int32_t threads : {1, 4}) {
        hg_grid_def def = hg_default_grid_def();
        def.skin = skin;
        def.thread_count = threads;
        require_pairs_of_the_rest(def);
        def.periodic[0] = def.periodic[2] = 1;
        def.box_max[0] = def.box_max[2] = 7;
        require_pairs_of_the_rest(def);
      }
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test((report<celllistmap_86>)),
                              cmocka_unit_test((report<jax_md_165>)),
                              cmocka_unit_test((report<aabbcc_5>)),
                              cmocka_unit_test((report<dissolve_957>)),
                              cmocka_unit_test((report<godot_54855>)),
                              cmocka_unit_test((report<hoomd_2022>)),
                              cmocka_unit_test((report<librascal_143>)),
                              cmocka_unit_test((report<nvalchemi_toolkit_153>)),
                              cmocka_unit_test((report<ladds_59>)),
                              cmocka_unit_test((report<espresso_5267>)),
                              cmocka_unit_test((report<lammps_1701>)),
                              cmocka_unit_test((report<jax_md_399>)),
                              cmocka_unit_test(espresso_4622)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
