// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Arrays as hosts have them: packed at odd addresses, floats.
#include "tests/support/compare.hpp"
#include "tests/support/rng.hpp"

#include <cstring>
#include <vector>

namespace {

using namespace hgtest;

// The values at an odd address, as a host that packs records has them.
template <class T>
class Misaligned {
 public:
  explicit Misaligned(const std::vector<T> &values) : bytes_(values.size() * sizeof(T) + 1 + alignof(T)) {
    offset_ = 1 + alignof(T) - reinterpret_cast<uintptr_t>(bytes_.data()) % alignof(T);
    std::memcpy(bytes_.data() + offset_, values.data(), values.size() * sizeof(T));
  }
  const T *get() const { return reinterpret_cast<const T *>(bytes_.data() + offset_); }

 private:
  std::vector<unsigned char> bytes_;
  size_t offset_;
};

Particles draw(uint64_t seed) {
  Rng rng(seed);
  Particles particles;
  for (int i = 0; i < 500; i++) {
    const double center[3] = {rng.uniform(0, 10), rng.uniform(0, 10), rng.uniform(0, 10)};
    particles.add(center, rng.uniform(0.1, 1));
  }
  return particles;
}

void odd_addresses(void **) {
  assert_true(holds(1, [](uint64_t seed) {
    const Particles particles = draw(seed);
    const hg_grid_def def = hg_default_grid_def();
    const Pairs expected = all_pairs(def, particles, exact_interact);
    const Misaligned<double> centers(particles.centers), radii(particles.radii);
    Grid grid(def);
    grid.insert(particles.count(), centers.get(), radii.get());
    require_same("inserted", sorted_pairs_of(grid), expected);
    grid.move(particles.count(), centers.get(), radii.get());
    require_same("moved", sorted_pairs_of(grid), expected);
    const Misaligned<double> center({5, 5, 5});
    const hgrid::View<int32_t> found = grid.query_sphere(center.get(), 1);
    const double same[3] = {5, 5, 5};
    require_same("sphere", std::vector<int32_t>(found.begin(), found.end()),
                 all_in_sphere(def, particles, {same, 1}, exact_interact));
    const Misaligned<int32_t> ids(std::vector<int32_t>{3, 77});
    grid.remove(2, ids.get());
    for (const hg_pair &pair : pairs_of(grid)) {
      require(pair.a != 3 && pair.b != 3 && pair.a != 77 && pair.b != 77, "a removed particle has a pair");
    }
  }));
}

void bad_values_at_odd_addresses_are_named(void **) {
  assert_true(holds(2, [](uint64_t) {
    const Misaligned<double> centers({0, 0, 0, 1, 1, 1}), radii({1, -1});
    Grid grid;
    const hg_status status = status_of([&] { grid.insert(2, centers.get(), radii.get()); });
    require(status == HG_ERR_ARGUMENT, "a negative radius is taken");
    require(std::strstr(hg_last_error(), "radii[1]") != nullptr, std::string("not named: ") + hg_last_error());
  }));
}

// Floats become doubles without rounding; the verdict is that on their values.
void floats_widened_to_doubles(void **) {
  assert_true(holds(4, [](uint64_t seed) {
    Rng rng(seed);
    Particles particles;
    for (int i = 0; i < 300; i++) {
      const float radius = 0.25f;
      const double center[3] = {static_cast<double>(0.1f * static_cast<float>(i % 10)),
                                static_cast<double>(0.1f * static_cast<float>(i / 10 % 10)),
                                static_cast<double>(static_cast<float>(rng.uniform(0, 3)))};
      particles.add(center, static_cast<double>(radius));
    }
    const hg_grid_def def = hg_default_grid_def();
    require_same("floats", sorted_pairs_of(make_grid(def, particles)), all_pairs(def, particles, exact_interact));
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(odd_addresses), cmocka_unit_test(bad_values_at_odd_addresses_are_named),
                              cmocka_unit_test(floats_widened_to_doubles)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
