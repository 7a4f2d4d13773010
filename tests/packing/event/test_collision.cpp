// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Meeting times, exits from hulls and impulses against closed forms and against the equation that they solve.
#include "packing/event/collision.hpp"
#include "packing/random.hpp"
#include "tests/support/frame.h"

#include <cmath>
#include <cstdio>

namespace {

using packing::Random;
using packing::square;
using packing::Vector;
using namespace packing::event;

constexpr uint64_t kSeed = 4711;
constexpr int kCases = 20000;

bool near(double found, double expected, double tolerance) {
  if (found == expected || std::fabs(found - expected) <= tolerance) return true;
  std::fprintf(stderr, "found %.17g, expected %.17g\n", found, expected);
  return false;
}

// Distances 10, radii 1: by hand.
void meetings_on_a_line(void **) {
  const Vector x(10, 0, 0);
  assert_true(near(meeting_time(x, Vector(-2, 0, 0), 2, 0), 4, 1e-15));
  assert_true(near(meeting_time(x, Vector(-2, 0, 0), 2, 2), 2, 1e-15));    // both surfaces come
  assert_true(near(meeting_time(x, Vector(0, 0, 0), 2, 0.5), 16, 1e-14));  // growth alone
  assert_true(near(meeting_time(x, Vector(1, 0, 0), 2, 3), 4, 1e-14));     // surfaces catch up with a fleeing centre
  assert_true(meeting_time(x, Vector(1, 0, 0), 2, 0.5) == kNever);
  assert_true(meeting_time(x, Vector(-2, 0, 0), 2, 0, 3.9) == kNever);  // the limit
  assert_true(meeting_time(Vector(2, 0, 0), Vector(-1, 0, 0), 2, 0) == 0);
  assert_true(meeting_time(Vector(1.9, 0, 0), Vector(-1, 0, 0), 2, 0) == 0);      // overlap, approaching
  assert_true(meeting_time(Vector(1.9, 0, 0), Vector(1, 0, 0), 2, 0) == kNever);  // overlap, parting
}

// Off the line of centres by b < sigma: the way is 10 - sqrt(sigma^2 - b^2); b > sigma misses.
void oblique_meetings(void **) {
  assert_true(near(meeting_time(Vector(10, 1.2, 0), Vector(-1, 0, 0), 2, 0), 10 - 1.6, 1e-14));
  assert_true(meeting_time(Vector(10, 2.0001, 0), Vector(-1, 0, 0), 2, 0) == kNever);
}

// |x + v t| - sigma - a t, whose first root the meeting time is.
double gap(const Vector &x, const Vector &v, double sigma, double a, double t) {
  return std::sqrt(square(x + v * t)) - sigma - a * t;
}

bool meetings_solve_their_equation() {
  Random random(kSeed);
  for (int k = 0; k < kCases; k++) {
    const Vector x(4 * random.normal(), 4 * random.normal(), 4 * random.normal());
    const Vector v(random.normal(), random.normal(), random.normal());
    const double sigma = 2 * random.uniform(), a = random.uniform();
    if (gap(x, v, sigma, a, 0) <= 0) continue;
    const double tau = meeting_time(x, v, sigma, a);
    const double until = tau == kNever ? 1000 : tau;
    bool ok = tau == kNever || std::fabs(gap(x, v, sigma, a, tau)) < 1e-9 * (1 + tau);
    for (int step = 0; step < 200; step++) ok = ok && gap(x, v, sigma, a, until * step / 200) > -1e-9 * (1 + until);
    ok = ok && (tau == kNever || meeting_time(x, v, sigma, a, tau * (1 + 1e-9) + 1e-12) == tau);
    if (ok) continue;
    std::fprintf(stderr, "seed %llu, case %d: tau %.17g\n", static_cast<unsigned long long>(kSeed), k, tau);
    return false;
  }
  return true;
}

bool exits_solve_their_equation() {
  Random random(kSeed);
  for (int k = 0; k < kCases; k++) {
    const double room = 1 + random.uniform(), a = 2 * random.uniform();
    Vector u(random.uniform(), random.uniform(), random.uniform());
    u *= 0.5 * room;
    const Vector v(random.normal(), random.normal(), random.normal());
    const double tau = exit_time(u, v, room, a);
    bool ok = std::isfinite(tau) && std::fabs(std::sqrt(square(u + v * tau)) - room + a * tau) < 1e-12 * (1 + tau);
    for (int step = 0; step < 100; step++) {
      const double t = tau * step / 100;
      ok = ok && std::sqrt(square(u + v * t)) <= room - a * t + 1e-12;
    }
    if (ok) continue;
    std::fprintf(stderr, "seed %llu, case %d: tau %.17g\n", static_cast<unsigned long long>(kSeed), k, tau);
    return false;
  }
  return true;
}

void exits_from_hulls(void **) {
  assert_true(near(exit_time(Vector::Zero(), Vector(0, 2, 0), 1, 0), 0.5, 1e-15));
  assert_true(near(exit_time(Vector::Zero(), Vector(0, 2, 0), 1, 2), 0.25, 1e-15));
  assert_true(near(exit_time(Vector(0.5, 0, 0), Vector(-1, 0, 0), 1, 0), 1.5, 1e-15));
  assert_true(exit_time(Vector::Zero(), Vector::Zero(), 1, 0) == kNever);
  assert_true(exit_time(Vector(1, 0, 0), Vector(1, 0, 0), 1, 0) == 0);
}

void walls(void **) {
  assert_true(near(wall_time(3, 2, 0), 1.5, 0));
  assert_true(near(wall_time(3, 2, 1), 1, 0));
  assert_true(wall_time(3, -2, 1) == kNever);
  assert_true(wall_time(-1e-17, 2, 0) == 0);
  assert_true(near(wall_rebound(-2, 0), 2, 0));
  assert_true(near(wall_rebound(-2, 0.5), 3, 0));
  assert_true(wall_rebound(0.5, 0.5) > 0.5);  // a surface at rest against the wall still parts
}

// Equal masses at rest growth exchange their normal velocities; in the frame of the moving surfaces the relative speed
// turns round; the energy gain is 2 mu a (a - v_n).
bool impulses_are_elastic() {
  Random random(kSeed);
  for (int k = 0; k < kCases; k++) {
    const double m1 = 0.1 + random.uniform(), m2 = 0.1 + 9 * random.uniform(), mu = m1 * m2 / (m1 + m2);
    const double a = random.uniform(), u1 = random.normal(), u2 = u1 + a - random.uniform() - 0.01;
    const double impulse = pair_impulse(mu, u2 - u1, a);
    const double w1 = u1 - impulse / m1, w2 = u2 + impulse / m2;
    const double gain = (m1 * w1 * w1 + m2 * w2 * w2 - m1 * u1 * u1 - m2 * u2 * u2) / 2;
    const bool ok = near(w2 - w1 - a, -(u2 - u1 - a), 1e-12) && near(gain, 2 * mu * a * (a - (u2 - u1)), 1e-11) &&
                    near(m1 * w1 + m2 * w2, m1 * u1 + m2 * u2, 1e-12);
    if (ok) continue;
    std::fprintf(stderr, "seed %llu, case %d\n", static_cast<unsigned long long>(kSeed), k);
    return false;
  }
  // Surfaces that do not approach part all the same.
  return near(pair_impulse(0.5, -3, 0), 3, 0) && pair_impulse(1, 0.5, 0.5) > 0;
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(meetings_on_a_line),
      cmocka_unit_test(oblique_meetings),
      cmocka_unit_test(passes<meetings_solve_their_equation>),
      cmocka_unit_test(exits_from_hulls),
      cmocka_unit_test(passes<exits_solve_their_equation>),
      cmocka_unit_test(walls),
      cmocka_unit_test(passes<impulses_are_elastic>),
  };
  return cmocka_run_group_tests_name("collision", tests, nullptr, nullptr);
}
