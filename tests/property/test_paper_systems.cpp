// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The paper's four size laws at its own N = 125 001, where comparing all pairs would take too long: the oracle sorts
// particles into cells by powers of two of their size and decides every near pair exactly.
#include "tests/support/compare.hpp"
#include "tests/support/rng.hpp"
#include "tests/support/size_laws.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using hgtest::Particles;
using hgtest::Sphere;

constexpr size_t kCount = 125001;

// Particles of one class of sizes in the cells of a periodic or open cube.
class SizeClass {
 public:
  SizeClass(const Particles &particles, const std::vector<size_t> &members, double low, double edge, double cell)
      : low_(low),
        cells_(std::clamp(static_cast<long>(std::floor(edge / cell)), 1L, 64L)),
        width_(edge / static_cast<double>(cells_)) {
    begin_.assign(static_cast<size_t>(cells_ * cells_ * cells_ + 1), 0);
    for (const size_t i : members) ++begin_[cell_of(particles.center(i)) + 1];
    for (size_t c = 1; c < begin_.size(); c++) begin_[c] += begin_[c - 1];
    std::vector<size_t> next(begin_.begin(), begin_.end() - 1);
    member_.resize(members.size());
    for (const size_t i : members) member_[next[cell_of(particles.center(i))]++] = i;
  }

  // Calls visit for every member in the cells that meet [center - reach, center + reach], each member once.
  template <class Visit>
  void near(const double *center, double reach, bool periodic, Visit visit) const {
    long first[3], count[3];
    for (int k = 0; k < 3; k++) {
      first[k] = static_cast<long>(std::floor((center[k] - reach - low_) / width_)) - 1;
      const long last = static_cast<long>(std::floor((center[k] + reach - low_) / width_)) + 1;
      if (!periodic) first[k] = std::clamp(first[k], 0L, cells_ - 1);
      count[k] = (periodic ? last : std::clamp(last, 0L, cells_ - 1)) - first[k] + 1;
      count[k] = std::min(count[k], cells_);
    }
    for (long z = 0; z < count[2]; z++) {
      for (long y = 0; y < count[1]; y++) {
        for (long x = 0; x < count[0]; x++) {
          const size_t c = index(wrap(first[0] + x), wrap(first[1] + y), wrap(first[2] + z));
          for (size_t m = begin_[c]; m < begin_[c + 1]; m++) visit(member_[m]);
        }
      }
    }
  }

 private:
  long wrap(long c) const { return ((c % cells_) + cells_) % cells_; }
  size_t index(long x, long y, long z) const { return static_cast<size_t>((z * cells_ + y) * cells_ + x); }
  size_t cell_of(const double *center) const {
    long c[3];
    for (int k = 0; k < 3; k++) {
      c[k] = std::clamp(static_cast<long>(std::floor((center[k] - low_) / width_)), 0L, cells_ - 1);
    }
    return index(c[0], c[1], c[2]);
  }

  double low_;
  long cells_;
  double width_;
  std::vector<size_t> begin_, member_;
};

hgtest::Pairs oracle_pairs(const hg_grid_def &def, const Particles &particles) {
  const double low = def.box_min[0], edge = def.box_max[0] - def.box_min[0];
  const bool periodic = def.periodic[0] != 0;
  std::vector<std::vector<size_t>> members;
  const auto class_of = [](double radius) { return static_cast<size_t>(std::max(0, std::ilogb(radius))); };
  for (size_t i = 0; i < particles.count(); i++) {
    members.resize(std::max(members.size(), class_of(particles.radii[i]) + 1));
    members[class_of(particles.radii[i])].push_back(i);
  }
  hgtest::Pairs pairs;
  for (size_t c = 0; c < members.size(); c++) {
    const double largest = std::ldexp(1.0, static_cast<int>(c) + 1);  // above every radius of the class
    const SizeClass fine(particles, members[c], low, edge, 2 * largest);
    for (size_t i = 0; i < particles.count(); i++) {
      if (class_of(particles.radii[i]) < c) continue;
      const Sphere a{particles.center(i), particles.radii[i]};
      const double reach = (particles.radii[i] + largest + def.margin) * (1 + 1e-9);
      fine.near(a.center, reach, periodic, [&](size_t j) {
        if (class_of(particles.radii[i]) == c && j <= i) return;
        if (!hgtest::exact_interact(def, a, {particles.center(j), particles.radii[j]})) return;
        const auto p = static_cast<int32_t>(i) + def.index_base, q = static_cast<int32_t>(j) + def.index_base;
        pairs.push_back({std::min(p, q), std::max(p, q)});
      });
    }
  }
  return hgtest::sorted(std::move(pairs));
}

Particles thrown(const std::vector<double> &radii, double density, double low, uint64_t seed, double *edge) {
  double volume = 0;
  for (const double r : radii) volume += 4.0 / 3.0 * 3.14159265358979 * r * r * r;
  *edge = std::cbrt(volume / density);
  hgtest::Rng rng(seed);
  Particles particles;
  for (const double r : radii) {
    double center[3];
    for (double &x : center) x = low + rng.uniform(0, *edge);
    particles.add(center, r);
  }
  return particles;
}

void compare(const std::string &name, const std::vector<double> &radii, double low, bool periodic, double margin,
             uint64_t seed) {
  double edge = 0;
  const Particles particles = thrown(radii, 0.3, low, seed, &edge);
  hg_grid_def def = hg_default_grid_def();
  for (int k = 0; k < 3; k++) {
    def.periodic[k] = periodic ? 1 : 0;
    def.box_min[k] = low;
    def.box_max[k] = low + edge;
  }
  def.margin = margin;
  const hgtest::Pairs expected = oracle_pairs(def, particles);
  hgtest::require(expected.size() > kCount / 10, name + ": the oracle finds too few pairs for a test");
  hgtest::require_same(name.c_str(), hgtest::sorted_pairs_of(hgtest::make_grid(def, particles)), expected);
}

std::vector<double> law(int which) {
  switch (which) {
    case 0:
      return std::vector<double>(kCount, 1.0);
    case 1:
      return hgtest::two_sizes(10, kCount);
    case 2:
      return hgtest::sample(hgtest::uniform_size, 50, kCount);
    default:
      return hgtest::sample(hgtest::uniform_volume, 50, kCount);
  }
}

void open_box(void **) {
  assert_true(hgtest::holds(1, [](uint64_t seed) {
    for (int k = 0; k < 4; k++) compare("open, law " + std::to_string(k), law(k), 0, false, 0, seed);
  }));
}

void periodic_box(void **) {
  assert_true(hgtest::holds(2, [](uint64_t seed) {
    for (int k = 0; k < 4; k++) compare("periodic, law " + std::to_string(k), law(k), 0, true, 0, seed);
  }));
}

void margin(void **) {
  assert_true(hgtest::holds(3, [](uint64_t seed) {
    for (int k = 0; k < 4; k++) compare("margin, law " + std::to_string(k), law(k), 0, k % 2 == 0, 0.125, seed);
  }));
}

// Coordinates are so coarse there that many pairs exactly touch or coincide.
void far_from_the_origin(void **) {
  assert_true(hgtest::holds(4, [](uint64_t seed) {
    for (int k = 0; k < 4; k++) compare("far away, law " + std::to_string(k), law(k), 0x1p50, false, 0, seed);
  }));
}

}  // namespace

int main() {
  const struct CMUnitTest tests[] = {cmocka_unit_test(open_box), cmocka_unit_test(periodic_box),
                                     cmocka_unit_test(margin), cmocka_unit_test(far_from_the_origin)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
