// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The floating-point state belongs to the host: other rounding modes, subnormal numbers flushed to zero. HG_EXACT must
// not notice, on one thread or several.
#include "tests/support/compare.hpp"
#include "tests/support/scenes.hpp"

#include <cfenv>
#include <cmath>
#include <initializer_list>
#include <limits>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace {

using namespace hgtest;

// Sets a rounding mode for the life of the object.
class Rounding {
 public:
  explicit Rounding(int mode) : before_(std::fegetround()) { std::fesetround(mode); }
  ~Rounding() { std::fesetround(before_); }
  Rounding(const Rounding &) = delete;
  Rounding &operator=(const Rounding &) = delete;

 private:
  int before_;
};

#if defined(__SSE2__)
constexpr bool kCanFlush = true;
// Results that are subnormal become zero (bit 15), and so do operands (bit 6).
class Flushing {
 public:
  Flushing() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
  ~Flushing() { _mm_setcsr(before_); }
  Flushing(const Flushing &) = delete;
  Flushing &operator=(const Flushing &) = delete;

 private:
  unsigned before_;
};
#else
constexpr bool kCanFlush = false;
struct Flushing {};
#endif

Scene draw(uint64_t seed) {
  Rng rng(seed);
  return any_scene(rng, 100);
}

// Pairs one unit in the last place around touching, where each rounding counts.
Scene draw_near_ties(uint64_t seed) {
  Rng rng(seed);
  Scene scene;
  scene.name = "near ties";
  scene.def.thread_count = 1;
  for (int i = 0; i < 60; i++) {
    const double r = rng.uniform(0.1, 1), s = rng.uniform(0.1, 1), angle = rng.uniform(0, 6.28);
    const double a[3] = {16.0 * i + rng.uniform(), rng.uniform(), rng.uniform()};
    const double b[3] = {a[0] + (r + s) * std::cos(angle), a[1] + (r + s) * std::sin(angle), a[2]};
    scene.particles.add(a, r);
    scene.particles.add(b, s);
  }
  return scene;
}

template <class State, class... Arguments>
void check(const Scene &scene, Arguments... arguments) {
  const Pairs expected = all_pairs(scene.def, scene.particles, exact_interact);
  Pairs got;
  {
    const State state{arguments...};
    got = sorted_pairs_of(make_grid(scene.def, scene.particles));
  }
  require_same(scene.name.c_str(), got, expected);
}

void any_rounding_mode(void **) {
  for (const int mode : {FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
    assert_true(sweep(120, [=](uint64_t seed) { check<Rounding>(draw(seed), mode); }));
    assert_true(sweep(40, [=](uint64_t seed) { check<Rounding>(draw_near_ties(seed), mode); }));
  }
}

void flush_to_zero(void **) {
  if (!kCanFlush) skip();
  assert_true(sweep(120, [](uint64_t seed) { check<Flushing>(draw(seed)); }));
}

// Subnormal coordinates and radii are zero to the host's arithmetic, not to the set of pairs.
void flush_to_zero_with_subnormal_input(void **) {
  if (!kCanFlush) skip();
  assert_true(sweep(60, [](uint64_t s) {
    Rng rng(s);
    Scene scene;
    scene.name = "subnormal";
    const double unit = rng.chance(0.5) ? 0x1p-1074 : 0x1p-1030;
    scene.def.margin = rng.chance(0.3) ? unit : 0;
    for (int i = 0; i < 50; i++) {
      double x[3];
      for (double &coordinate : x) coordinate = rng.integer(-20, 20) * unit;
      scene.particles.add(x, rng.integer(0, 6) * unit);
    }
    const double ordinary[3] = {1, 0, 0};
    if (rng.chance(0.5)) scene.particles.add(ordinary, 1);
    check<Flushing>(scene);
  }));
}

// -2^-1074 is negative, though it compares equal to zero in this state.
void negative_subnormal_radius_is_refused(void **) {
  if (!kCanFlush) skip();
  assert_true(holds(0, [](uint64_t) {
    Grid grid;
    const double center[3] = {0, 0, 0}, negative = -0x1p-1074, zero = -0.0;
    hg_status status, sphere, fine;
    {
      const Flushing state;
      status = status_of([&] { grid.insert(1, center, &negative); });
      sphere = status_of([&] { grid.query_sphere(center, negative); });
      fine = status_of([&] { grid.insert(1, center, &zero); });
    }
    require(status == HG_ERR_ARGUMENT, "hg_insert takes a negative radius");
    require(sphere == HG_ERR_ARGUMENT, "hg_query_sphere takes a negative radius");
    require(fine == HG_OK, "hg_insert refuses a radius of -0.0");
  }));
}

// Enough particles that threads share the work; those threads may have begun in another state than the caller's.
void threads_in_another_state(void **) {
  assert_true(holds(9, [](uint64_t seed) {
    Rng rng(seed);
    Scene scene = open_scene(rng, 3, 25000, Sizes::kUniformVolume, Places::kUniform);
    scene.def.accuracy = HG_EXACT;
    scene.def.margin = 0;
    const Pairs expected = swept_pairs(scene.def, scene.particles, exact_interact);
    for (const int threads : {1, 4}) {
      scene.def.thread_count = threads;
      require_same("nearest", sorted_pairs_of(make_grid(scene.def, scene.particles)), expected);
      for (const int mode : {FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
        Pairs got;
        {
          const Rounding state(mode);
          got = sorted_pairs_of(make_grid(scene.def, scene.particles));
        }
        require_same("another rounding mode", got, expected);
      }
    }
  }));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_rounding_mode), cmocka_unit_test(flush_to_zero),
                              cmocka_unit_test(flush_to_zero_with_subnormal_input),
                              cmocka_unit_test(negative_subnormal_radius_is_refused),
                              cmocka_unit_test(threads_in_another_state)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
