// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Crystals: the number of neighbours in each shell is known, free and periodic.
//
// The reach lies between two shells, so no rounding can change a count; where it equals a shell of dyadic distances,
// strict comparison leaves that shell out.
#include "tests/support/compare.hpp"

#include <cmath>

namespace {

using namespace hgtest;

constexpr double kSc[][3] = {{0, 0, 0}};
constexpr double kBcc[][3] = {{0, 0, 0}, {0.5, 0.5, 0.5}};
constexpr double kFcc[][3] = {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};

// n^3 cells of edge 1 with the sites of `basis` in each; all radii equal.
template <size_t sites>
Particles block(int n, const double (&basis)[sites][3], double radius) {
  Particles particles;
  for (int i = 0; i < n * n * n; i++) {
    for (const double(&site)[3] : basis) {
      const double center[3] = {i % n + site[0], i / n % n + site[1], static_cast<double>(i / n / n) + site[2]};
      particles.add(center, radius);
    }
  }
  return particles;
}

hg_grid_def periodic_box(double edge) {
  hg_grid_def def = hg_default_grid_def();
  for (int k = 0; k < 3; k++) {
    def.periodic[k] = 1;
    def.box_max[k] = edge;
  }
  return def;
}

void require_count(const std::string &what, const hg_grid_def &def, const Particles &particles, size_t expected) {
  const size_t count = pairs_of(make_grid(def, particles)).size();
  require(count == expected, what + ": " + std::to_string(count) + " contacts, expected " + std::to_string(expected));
}

// Contacts of spheres, ranges, and points with a margin must all count the pairs nearer than `reach`.
template <size_t sites>
void require_within(const std::string &what, hg_grid_def def, int n, const double (&basis)[sites][3], double reach,
                    size_t expected) {
  require_count(what, def, block(n, basis, reach / 2), expected);
  def.interaction = HG_MAX_RANGE;
  require_count(what + ", ranges", def, block(n, basis, reach), expected);
  def.interaction = HG_CONTACT;
  def.margin = reach;
  require_count(what + ", margin", def, block(n, basis, 0), expected);
}

struct Shell {
  double distance2;
  size_t count;
};

// z(reach) adds up the shells below the reach; every periodic site has all of them: N z / 2 pairs.
template <size_t sites, size_t shells>
void require_shells(const char *name, const double (&basis)[sites][3], const Shell (&table)[shells]) {
  constexpr size_t kEdge = 6;
  size_t z = 0;
  for (size_t k = 0; k + 1 < shells; k++) {
    z += table[k].count;
    const double reach = std::sqrt(0.5 * (table[k].distance2 + table[k + 1].distance2));
    require_within(std::string(name) + " shells below " + std::to_string(reach), periodic_box(kEdge), kEdge, basis,
                   reach, kEdge * kEdge * kEdge * sites * z / 2);
  }
}

void periodic_shells(void **) {
  assert_true(holds(0, [](uint64_t) {
    require_shells("sc", kSc, {{1, 6}, {2, 12}, {3, 8}, {4, 6}, {5, 24}, {6, 24}});
    require_shells("bcc", kBcc, {{0.75, 8}, {1, 6}, {2, 12}, {2.75, 24}, {3, 8}, {4, 6}});
    require_shells("fcc", kFcc, {{0.5, 12}, {1, 6}, {1.5, 24}, {2, 12}, {2.5, 24}, {3, 8}});
  }));
}

void free_blocks(void **) {
  assert_true(holds(0, [](uint64_t) {
    const hg_grid_def open = hg_default_grid_def();
    for (const int n : {1, 2, 5, 10}) {
      const size_t m = static_cast<size_t>(n);
      const size_t first = 3 * m * m * (m - 1);
      const size_t second = 6 * m * (m - 1) * (m - 1);
      const size_t third = 4 * (m - 1) * (m - 1) * (m - 1);
      require_within("sc block", open, n, kSc, 1.2, first);
      require_within("sc block, 2 shells", open, n, kSc, 1.6, first + second);
      require_within("sc block, 3 shells", open, n, kSc, 1.8, first + second + third);
      require_within("bcc block", open, n, kBcc, 0.9, (2 * m - 1) * (2 * m - 1) * (2 * m - 1));
      require_within("fcc block", open, n, kFcc, 0.8, 24 * m * m * m - 24 * m * m + 6 * m);
    }
  }));
}

// Reach and distances are equal dyadic numbers: the shell does not count.
void touching_shells_do_not_count(void **) {
  assert_true(holds(0, [](uint64_t) {
    const hg_grid_def open = hg_default_grid_def();
    require_within("sc touching", open, 8, kSc, 1, 0);
    require_within("sc touching, periodic", periodic_box(8), 8, kSc, 1, 0);
    require_within("sc touching the fourth shell", periodic_box(8), 8, kSc, 2, 512 * (6 + 12 + 8) / 2);
    require_within("bcc touching the second shell", periodic_box(8), 8, kBcc, 1, 1024 * 8 / 2);
    require_within("fcc touching the second shell", periodic_box(8), 8, kFcc, 1, 2048 * 12 / 2);
  }));
}

// Rows of a triangular lattice, every other one shifted by half a spacing.
Particles triangular(int columns, int rows, double radius) {
  Particles particles;
  particles.dimension = 2;
  for (int row = 0; row < rows; row++) {
    for (int column = 0; column < columns; column++) {
      const double center[2] = {column + 0.5 * (row % 2), row * std::sqrt(0.75)};
      particles.add(center, radius);
    }
  }
  return particles;
}

void triangular_lattice(void **) {
  assert_true(holds(0, [](uint64_t) {
    hg_grid_def def = hg_default_grid_def();
    def.dimension = 2;
    const size_t columns = 20;
    const size_t rows = 14;
    // In a row: columns - 1; between rows: 2 columns - 1.
    require_count("triangular block", def, triangular(20, 14, 0.55),
                  rows * (columns - 1) + (rows - 1) * (2 * columns - 1));
    def.periodic[0] = def.periodic[1] = 1;
    def.box_max[0] = 20;
    def.box_max[1] = 14 * std::sqrt(0.75);
    require_count("triangular, periodic", def, triangular(20, 14, 0.55), rows * columns * 6 / 2);
    require_count("triangular, 2 shells", def, triangular(20, 14, 0.9), rows * columns * (6 + 6) / 2);
  }));
}

// Only unlike ions meet: 8 around each in CsCl, 6 in NaCl.
void two_species(void **) {
  assert_true(holds(0, [](uint64_t) {
    constexpr size_t kEdge = 6, kCells = kEdge * kEdge * kEdge;
    Particles cscl = block(kEdge, kBcc, 0.45);
    for (size_t i = 1; i < cscl.count(); i += 2) cscl.radii[i] = 0.43;
    require_count("CsCl", periodic_box(kEdge), cscl, kCells * 8);
    constexpr double kNacl[][3] = {{0, 0, 0},     {0.5, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0},
                                   {0.5, 0, 0.5}, {0, 0, 0.5}, {0, 0.5, 0.5}, {0.5, 0.5, 0.5}};
    Particles nacl = block(kEdge, kNacl, 0.3);
    for (size_t i = 1; i < nacl.count(); i += 2) nacl.radii[i] = 0.22;
    require_count("NaCl", periodic_box(kEdge), nacl, kCells * 8 * 6 / 2);
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(periodic_shells), cmocka_unit_test(free_blocks),
                              cmocka_unit_test(touching_shells_do_not_count), cmocka_unit_test(triangular_lattice),
                              cmocka_unit_test(two_species)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
