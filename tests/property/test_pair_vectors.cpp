// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What leads from one particle of a pair to the other: the shifts and vectors of real arithmetic, each component the
// double nearest to the exact value, in any box, for any history of the grid. Contacts bring the same in batches.
#include "oracle/cell.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/rounded.hpp"
#include "tests/support/scenes.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace hgtest;

// A pair with its geometry. Open axes have no shift.
struct Contact {
  int32_t a, b;
  int64_t shift[3];
  double vector[3], reach;
};

bool is_same(const Contact &c, const Contact &d) {
  return c.a == d.a && c.b == d.b && std::equal(c.shift, c.shift + 3, d.shift) &&
         std::memcmp(c.vector, d.vector, sizeof c.vector) == 0 && c.reach == d.reach;
}

void require_same_contacts(const std::string &what, const std::vector<Contact> &got,
                           const std::vector<Contact> &expected) {
  require(got.size() == expected.size(), what + ": another number of contacts");
  for (size_t k = 0; k < got.size(); k++) {
    require(is_same(got[k], expected[k]), what + ": another contact (" + std::to_string(got[k].a) + ", " +
                                              std::to_string(got[k].b) + ") at place " + std::to_string(k));
  }
}

double reach_of(const hg_grid_def &def, double r, double s) {
  return (def.interaction == HG_MAX_RANGE ? std::fmax(r, s) : r + s) + def.margin;
}

void require_rounded(const Scene &scene, const Contact &contact) {
  const oracle::Cell<mpq_class> cell(scene.def);
  const auto row = [&](int32_t id) { return static_cast<size_t>(id - scene.def.index_base); };
  const double *from = scene.particles.center(row(contact.a)), *to = scene.particles.center(row(contact.b));
  for (int axis = 0; axis < scene.def.dimension; axis++) {
    mpq_class exact = mpq_class(to[axis]) - mpq_class(from[axis]);
    for (int edge = axis; edge < scene.def.dimension; edge++) exact += contact.shift[edge] * cell.edge[axis][edge];
    require(is_rounded(exact, contact.vector[axis]), scene.name + ": a component is not rounded correctly");
  }
}

// A particle's own images count once for two opposite shifts: for that whose last edge is taken forward.
bool is_forward(const oracle::Shift &shift) {
  for (int k = 2; k >= 0; k--) {
    if (shift.n[k] != 0) return shift.n[k] > 0;
  }
  return false;
}

using Met = std::tuple<int32_t, int32_t, std::vector<int64_t>>;

// Ids and shifts of all pairs, ascending.
std::vector<Met> all_met(const Scene &scene) {
  std::vector<Met> met;
  const Pairs pairs = all_pairs(scene.def, scene.particles, exact_interact);
  for (size_t k = 0; k < pairs.size(); k++) {
    if (k > 0 && oracle::pair_equal(pairs[k], pairs[k - 1])) continue;
    const auto sphere = [&](int32_t id) {
      const auto row = static_cast<size_t>(id - scene.def.index_base);
      return oracle::Sphere{scene.particles.center(row), scene.particles.radii[row]};
    };
    for (const oracle::Shift &shift : oracle::exact_shifts(scene.def, sphere(pairs[k].a), sphere(pairs[k].b))) {
      if (pairs[k].a == pairs[k].b && !is_forward(shift)) continue;
      met.emplace_back(pairs[k].a, pairs[k].b, std::vector<int64_t>(shift.n, shift.n + 3));
    }
  }
  return met;
}

// In the order of the library.
std::vector<Contact> contacts_of(const Grid &grid, const Scene &scene) {
  const hgrid::View<hg_pair> pairs = grid.query_pairs();
  const auto [vectors, shifts] = grid.query_pair_vectors();
  const auto dimension = static_cast<size_t>(scene.def.dimension);
  const auto radius = [&](int32_t id) { return scene.particles.radii[static_cast<size_t>(id - scene.def.index_base)]; };
  std::vector<Contact> contacts;
  for (size_t p = 0; p < pairs.size(); p++) {
    Contact contact{pairs[p].a, pairs[p].b, {0, 0, 0}, {0, 0, 0}, 0};
    std::copy_n(shifts.data() + p * dimension, dimension, contact.shift);
    std::copy_n(vectors.data() + p * dimension, dimension, contact.vector);
    contact.reach = reach_of(scene.def, radius(contact.a), radius(contact.b));
    contacts.push_back(contact);
  }
  return contacts;
}

// Equal pairs stay in the order in which they stood.
std::vector<Contact> ascending(std::vector<Contact> contacts) {
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const Contact &c, const Contact &d) { return std::pair(c.a, c.b) < std::pair(d.a, d.b); });
  return contacts;
}

std::vector<Met> met_by(const std::vector<Contact> &contacts) {
  std::vector<Met> met;
  for (const Contact &c : contacts) met.emplace_back(c.a, c.b, std::vector<int64_t>(c.shift, c.shift + 3));
  return met;
}

// What batches bring is what the lists hold, in their order; shifts are not told.
void require_batches(const Grid &grid, const Scene &scene) {
  std::vector<Contact> listed = contacts_of(grid, scene), visited;
  for (Contact &contact : listed) std::fill_n(contact.shift, 3, 0);
  grid.visit_contacts([&](const hg_contact_batch &batch) {
    require(batch.count > 0 && batch.count <= HG_MAX_BATCH, "a batch of another size");
    require((batch.dz == nullptr) == (scene.def.dimension == 2), "dz is there without need, or missing");
    for (size_t k = 0; k < batch.count; k++) {
      const double dz = batch.dz != nullptr ? batch.dz[k] : 0;
      visited.push_back({batch.a[k], batch.b[k], {0, 0, 0}, {batch.dx[k], batch.dy[k], dz}, batch.reach[k]});
    }
  });
  require_same_contacts("batches", visited, listed);
}

// Exact truth, then the same bits in any order, on any number of threads, in one grid and by any way to it.
void check(Scene &scene, Rng &rng) {
  scene.def.pair_order = HG_ORDER_ID;
  const Grid by_id = make_grid(scene.def, scene.particles);
  const std::vector<Contact> truth = contacts_of(by_id, scene);
  require(met_by(truth) == all_met(scene), scene.name + ": other pairs or shifts");
  for (const Contact &contact : truth) require_rounded(scene, contact);
  require_batches(by_id, scene);

  scene.def.pair_order = HG_ORDER_GRID;
  scene.def.skin = 0.5 * largest_reach(scene.def, scene.particles);
  const size_t count = scene.particles.count();
  const auto dimension = static_cast<size_t>(scene.def.dimension);
  std::vector<double> elsewhere = scene.particles.centers;
  for (double &x : elsewhere) x += 0.2 * scene.def.skin * rng.uniform(-1, 1);
  std::vector<Contact> one_thread;
  for (const int32_t threads : {1, 3}) {
    scene.def.thread_count = threads;
    Grid grid(scene.def);
    grid.set(count, elsewhere.data(), scene.particles.radii.data());
    grid.query_pairs();
    grid.set(count, scene.particles.centers.data(), scene.particles.radii.data());
    const std::vector<Contact> moved = contacts_of(grid, scene);
    require_same_contacts("with a skin", ascending(moved), truth);
    if (threads == 1) one_thread = moved;
    require_same_contacts("more threads", moved, one_thread);
    require_batches(grid, scene);
  }

  // Ids with gaps: strangers stood between the particles.
  if (scene.def.images == HG_ALL_IMAGES || count < 2) return;
  Grid grid(scene.def);
  grid.insert(1, elsewhere.data(), scene.particles.radii.data());
  grid.insert(count - 1, scene.particles.centers.data(), scene.particles.radii.data());
  const int32_t gone = scene.def.index_base;
  grid.remove(1, &gone);
  grid.insert(1, scene.particles.centers.data() + (count - 1) * dimension, scene.particles.radii.data() + (count - 1));
  std::vector<Contact> shifted = truth;
  for (Contact &contact : shifted) contact.a++, contact.b++;
  const hgrid::View<hg_pair> pairs = grid.query_pairs();
  const auto [vectors, shifts] = grid.query_pair_vectors();
  std::vector<Contact> with_gaps;
  for (size_t p = 0; p < pairs.size(); p++) {
    Contact contact{pairs[p].a, pairs[p].b, {0, 0, 0}, {0, 0, 0}, 0};
    std::copy_n(shifts.data() + p * dimension, dimension, contact.shift);
    std::copy_n(vectors.data() + p * dimension, dimension, contact.vector);
    with_gaps.push_back(contact);
  }
  for (Contact &contact : shifted) contact.reach = 0;
  require_same_contacts("ids with gaps", ascending(with_gaps), shifted);
}

void open_and_periodic_boxes(void **) {
  assert_true(sweep(250, [](uint64_t seed) {
    Rng rng(seed);
    const int dimension = rng.integer(2, 3), axes = rng.integer(0, (1 << dimension) - 1);
    const auto sizes = static_cast<Sizes>(rng.below(kSizesCount));
    const auto places = static_cast<Places>(rng.below(kPlacesCount));
    Scene scene = axes == 0 ? open_scene(rng, dimension, rng.below(80), sizes, places)
                            : periodic_scene(rng, dimension, axes, rng.below(80), sizes);
    check(scene, rng);
  }));
}

void tilted_boxes(void **) {
  assert_true(sweep(250, [](uint64_t seed) {
    Rng rng(seed);
    const int dimension = rng.integer(2, 3);
    const auto sizes = static_cast<Sizes>(rng.below(kSizesCount));
    Scene scene = tilted_scene(rng, dimension, draw_tilted_axes(rng, dimension), rng.below(80), sizes);
    check(scene, rng);
  }));
}

void all_images(void **) {
  assert_true(sweep(200, [](uint64_t seed) {
    Rng rng(seed);
    const int dimension = rng.integer(2, 3), axes = rng.integer(1, (1 << dimension) - 1);
    const auto sizes = static_cast<Sizes>(rng.below(kSizesCount));
    Scene scene = many_images_scene(rng, dimension, axes, 1 + rng.below(25), sizes);
    check(scene, rng);
  }));
}

// Lattices where many touch, some through two faces: of these the smaller shift.
void touching_through_two_faces(void **) {
  assert_true(sweep(100, [](uint64_t seed) {
    Rng rng(seed);
    Scene scene;
    scene.name = "half a box apart";
    scene.def.touching = 1;
    scene.def.dimension = rng.integer(2, 3);
    scene.def.images = rng.chance(0.3) ? HG_ALL_IMAGES : HG_NEAREST_IMAGE;
    scene.particles.dimension = scene.def.dimension;
    for (int k = 0; k < scene.def.dimension; k++) {
      scene.def.periodic[k] = 1;
      scene.def.box_max[k] = 4;
    }
    if (rng.chance(0.5)) scene.def.tilt[0] = rng.integer(-9, 9) * 0.5;
    for (int i = 0; i < 30; i++) {
      double x[3];
      for (double &coordinate : x) coordinate = rng.integer(-40, 40) * 0.5;
      scene.particles.add(x, 1);
    }
    check(scene, rng);
  }));
}

// Where squares of lengths lose digits or overflow, the nearest image must not be told by them: particles a little more
// or less than half an edge apart, in a cell whose edges are about as long as each other.
void any_unit_of_length(void **) {
  assert_true(sweep(300, [](uint64_t seed) {
    Rng rng(seed);
    Scene scene;
    scene.name = "any unit";
    constexpr int kExponents[] = {-1030, -548, -547, -546, -544, -540, 505, 515, 1000};
    const double unit = std::ldexp(rng.uniform(1, 2), kExponents[rng.below(9)]);
    scene.def.periodic[0] = scene.def.periodic[1] = 1;
    scene.def.box_max[0] = 2048 * unit;
    scene.def.box_max[1] = 1774 * unit;
    scene.def.tilt[0] = 1024 * unit;
    for (int i = 0; i < 30; i++) {
      const int a = rng.integer(-3, 3), b = rng.integer(-3, 3);
      const double x[3] = {(1024 * a + 512 * b + rng.integer(-4, 4)) * unit, (887 * b + rng.integer(-4, 4)) * unit, 0};
      scene.particles.add(x, (511 - 0.5 * rng.integer(0, 3)) * unit);
    }
    check(scene, rng);
  }));
}

// Places whose exact difference has more digits than a double, and some that lie in the middle of two doubles.
void hard_roundings(void **) {
  assert_true(sweep(200, [](uint64_t seed) {
    Rng rng(seed);
    Scene scene;
    scene.name = "hard roundings";
    scene.def.periodic[0] = scene.def.periodic[1] = 1;
    const double unit = std::ldexp(1, rng.integer(-900, 900));
    const double length = unit * (rng.chance(0.5) ? 1 : 1 + rng.integer(0, 3) * 0x1p-52);
    scene.def.box_max[0] = scene.def.box_max[1] = length;
    if (rng.chance(0.5)) scene.def.tilt[0] = 0.25 * unit * (1 + rng.integer(0, 3) * 0x1p-52);
    for (int i = 0; i < 25; i++) {
      double x[3] = {0, 0, 0};
      for (int k = 0; k < 2; k++) {
        const double tiny = std::ldexp(rng.integer(-3, 3), -rng.integer(40, 100));
        x[k] = unit * (rng.integer(-8, 8) * (rng.chance(0.5) ? 1 : 0.125) + tiny);
      }
      scene.particles.add(x, 0.2 * unit);
    }
    check(scene, rng);
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(open_and_periodic_boxes),
                              cmocka_unit_test(tilted_boxes),
                              cmocka_unit_test(all_images),
                              cmocka_unit_test(touching_through_two_faces),
                              cmocka_unit_test(any_unit_of_length),
                              cmocka_unit_test(hard_roundings)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
