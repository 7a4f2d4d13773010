// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The kernels that come in several widths, each beside plain arithmetic on one contact or particle: the same bits.
#include "dem/base/vectors.hpp"
#include "dem/effects/table.hpp"
#include "dem/kernels/contact_batch.hpp"
#include "dem/kernels/motion_kernel.hpp"
#include "dem/kernels/rough_batch.hpp"
#include "tests/support/frame.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

namespace {

std::mt19937_64 generator(7);  // NOLINT: the same numbers each time

double random_in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); }

bool same_bits(double x, double y) { return std::memcmp(&x, &y, sizeof x) == 0; }

// Calls test() once for each width that HGRID_ISA can ask for; what the machine lacks falls back to plain code.
template <class Test>
void for_widths(Test test) {
  for (const char *set : {"scalar", "avx2", "avx512"}) {
    setenv("HGRID_ISA", set, 1);
    std::printf("%s: vectors %d\n", set, static_cast<int>(dem::usable_vectors()));
    test();
  }
  unsetenv("HGRID_ISA");
}

// Spring, dashpot and slider written down once more, of one contact.
template <int D>
struct Slider {
  double stiffness, damping, limit, stretch[D];

  static Slider random() {
    Slider slider;
    slider.stiffness = random_in(0, 1) < 0.1 ? 0 : random_in(0, 100);
    slider.damping = random_in(0, 1) < 0.3 ? 0 : random_in(0, 1);
    slider.limit = random_in(0, 1) < 0.1 ? 0 : random_in(-0.1, 1.5);
    for (double &component : slider.stretch) component = random_in(-0.01, 0.01);
    return slider;
  }

  template <class Columns>
  void put(size_t p, Columns &columns) const {
    columns.stiffness[p] = stiffness;
    columns.damping[p] = damping;
    columns.limit[p] = limit;
  }

  // Of contacts that were there in the last pass; others start with nothing.
  void remember(dem::Row<double> &row, bool known) {
    row.numbers[3] = known ? 6 : 5;
    for (int k = 0; k < D; k++) {
      row.numbers[k] = stretch[k];
      if (!known) stretch[k] = 0;
    }
  }

  dem::Vec<D, double> stretched() const { return Eigen::Map<const dem::Vec<D, double>>(stretch); }

  dem::Vec<D, double> force(const dem::Vec<D, double> &normal, const dem::Vec<D, double> &velocity, double step) {
    double along = 0, square = 0;
    for (int k = 0; k < D; k++) along += normal[k] * stretch[k];
    dem::Vec<D, double> turned, result;
    for (int k = 0; k < D; k++) {
      turned[k] = stretch[k] - normal[k] * along;
      stretch[k] = turned[k] + velocity[k] * step;
      result[k] = -stiffness * stretch[k] - damping * velocity[k];
      square += result[k] * result[k];
    }
    const double size = std::sqrt(square), firmness = damping + stiffness * step;
    if (size > limit) {
      for (int k = 0; k < D; k++) {
        result[k] *= limit / size;
        stretch[k] = firmness > 0 ? (damping * turned[k] - step * result[k]) * (1 / firmness) : turned[k];
      }
    }
    if (limit > 0) return result;
    for (double &component : stretch) component = 0;
    return dem::Vec<D, double>::Zero();
  }
};

template <int D>
struct RoughContact {
  using Vector = dem::Vec<D, double>;
  using Spin = dem::Spin<D, double>;

  Vector normal = Vector::Random().normalized(), velocity = Vector::Random();
  Spin turning, spin = Spin::Random(), other_spin = Spin::Random();
  double pressing = random_in(-1, 1), radius = random_in(0.2, 1);
  Slider<D> friction = Slider<D>::random(), rolling = Slider<D>::random();
  Vector force;
  Spin torque, other_torque;

  void take(double step, double arm, double other_arm) {
    turning = arm * spin + other_arm * other_spin;
    const Vector surface = dem::turn<D, double>(turning, normal) + velocity;
    const Vector tangential = friction.force(normal, surface - normal * normal.dot(surface), step);
    force = tangential - pressing * normal;
    const Spin moment = dem::moment<D, double>(normal, tangential);
    const Vector rolled = dem::turn<D, double>(spin - other_spin, normal) * radius;
    const Spin rolling_torque = dem::moment<D, double>(normal, rolling.force(normal, rolled, step)) * radius;
    torque = arm * moment + rolling_torque;
    other_torque = other_arm * moment - rolling_torque;
  }
};

template <class Vector>
bool same_row(const dem::Row<double> &row, const Vector &vector) {
  for (int k = 0; k < vector.size(); k++) {
    if (!same_bits(row.numbers[k], vector[k])) return false;
  }
  return true;
}

// Contacts of two bodies each, the first of every three not yet there in the pass before.
template <int D>
bool rough_contacts_agree(size_t count) {
  constexpr dem::EffectSet kEffects = dem::kFriction | dem::kRolling;
  static dem::RoughBatch<double> batch;
  static dem::ContactBatch<double> touching;
  const double step = 0.01;
  dem::Bodies<D, double> bodies;
  bodies.resize(2 * count, kEffects);
  dem::History<D, double> history;
  history.first = 3;
  history.pass = 7;
  for (auto &rows : history.rows) rows.resize(count);
  std::vector<hg_pair> pairs(history.first);
  std::vector<RoughContact<D>> contacts(count);
  for (size_t p = 0; p < count; p++) {
    RoughContact<D> &contact = contacts[p];
    pairs.push_back({static_cast<int32_t>(2 * p), static_cast<int32_t>(2 * p + 1)});
    touching.place[p] = static_cast<uint32_t>(history.first + p);
    touching.touching[p] = 2;
    touching.distance[p] = random_in(1.8, 2);
    for (int k = 0; k < D; k++) touching.normal[k][p] = contact.normal[k];
    bodies.velocity(2 * p) = contact.velocity;
    bodies.spin(2 * p) = contact.spin;
    bodies.spin(2 * p + 1) = contact.other_spin;
    bodies.radius(2 * p) = random_in(0.2, 1);
    bodies.radius(2 * p + 1) = random_in(0.2, 1);
    batch.pressing[p] = contact.pressing;
    batch.radius[p] = contact.radius;
    contact.friction.put(p, batch.friction);
    contact.rolling.put(p, batch.rolling);
    contact.friction.remember(history.row(dem::kFriction, touching.place[p]), p % 3 != 0);
    contact.rolling.remember(history.row(dem::kRolling, touching.place[p]), p % 3 != 0);
  }
  const auto kernels = dem::find_rough_kernels<D, double>(kEffects);
  const dem::RoughTask<D, double> task{&bodies, pairs.data(), 0, bodies.count(), &history, step, &touching, 0, count};
  kernels.gather(task, batch);
  kernels.rub(task, batch);
  for (size_t p = 0; p < count; p++) {
    RoughContact<D> &contact = contacts[p];
    const size_t a = 2 * p, b = a + 1;
    const double half = (touching.touching[p] - touching.distance[p]) / 2;
    contact.take(step, bodies.radius(a) - half, bodies.radius(b) - half);
    const auto &slip = history.row(dem::kFriction, touching.place[p]),
               &roll = history.row(dem::kRolling, touching.place[p]);
    const bool same = same_row(bodies.moves[a].push, dem::Vec<D, double>(0 + contact.force.array())) &&
                      same_row(bodies.moves[b].push, dem::Vec<D, double>(0 - contact.force.array())) &&
                      same_row(bodies.turns[a].push, dem::Spin<D, double>(0 + contact.torque.array())) &&
                      same_row(bodies.turns[b].push, dem::Spin<D, double>(0 + contact.other_torque.array())) &&
                      same_row(slip, contact.friction.stretched()) && slip.numbers[3] == 7 &&
                      same_row(roll, contact.rolling.stretched()) && roll.numbers[3] == 7;
    if (!same) return false;
  }
  return true;
}

void rough_contacts_side_by_side_are_contacts(void **) {
  for_widths([] {
    for (const size_t count : {1, 3, 8, 61, 64}) {
      assert_true(rough_contacts_agree<2>(count));
      assert_true(rough_contacts_agree<3>(count));
    }
  });
}

template <int D>
dem::Bodies<D, double> random_bodies(size_t count, dem::EffectSet effects) {
  dem::Bodies<D, double> bodies;
  bodies.resize(count, effects);
  for (size_t i = 0; i < count; i++) {
    for (int k = 0; k < D; k++) {
      bodies.position(i)[k] = random_in(-5, 5);
      bodies.velocity(i)[k] = random_in(-1, 1);
      bodies.force(i)[k] = random_in(-10, 10);
    }
    bodies.radius(i) = random_in(0.2, 1);
    bodies.inverse_mass(i) = i % 5 == 0 ? 0 : random_in(0.5, 2);
    if (!bodies.rotating()) continue;
    for (int k = 0; k < bodies.kSpin; k++) {
      bodies.spin(i)[k] = random_in(-1, 1);
      bodies.torque(i)[k] = random_in(-1, 1);
    }
  }
  return bodies;
}

template <int D>
void move_plainly(dem::Bodies<D, double> &bodies, dem::EffectSet effects, const dem::BodyForce<D, double> &outside,
                  double kick, double drift) {
  for (size_t i = 0; i < bodies.count(); i++) {
    const double light = bodies.inverse_mass(i);
    for (int k = 0; k < D; k++) {
      double a = bodies.force(i)[k] * light;
      if (dem::has(effects, dem::kGravity) && light > 0) a += outside.gravity[k];
      if (dem::has(effects, dem::kDrag)) a -= outside.drag * bodies.radius(i) * light * bodies.velocity(i)[k];
      bodies.velocity(i)[k] += kick * a;
      bodies.position(i)[k] += drift * bodies.velocity(i)[k];
      bodies.force(i)[k] = 0;
    }
    for (int k = 0; bodies.rotating() && k < bodies.kSpin; k++) {
      bodies.spin(i)[k] += kick * bodies.inverse_inertia(i) * bodies.torque(i)[k];
      bodies.torque(i)[k] = 0;
    }
  }
}

template <int D>
bool motions_agree(dem::EffectSet effects) {
  auto bodies = random_bodies<D>(37, effects), others = bodies;
  dem::BodyForce<D, double> outside{dem::Vec<D, double>::Constant(-0.3), 0.7};
  const dem::MotionTask<D, double> task{&bodies, outside, 0.01, 0.02};
  const double fastest = dem::find_motion_kernel<D, double>(effects)(task, 0, bodies.count());
  move_plainly(others, effects, outside, task.kick, task.drift);
  double most = 0;
  for (size_t i = 0; i < bodies.count(); i++) most = std::max(most, others.velocity(i).squaredNorm());
  bool same = same_bits(fastest, most);
  const auto rows_agree = [&](const auto &x, const auto &y) {
    same = same && x.size() == y.size() && (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0);
  };
  rows_agree(bodies.places, others.places);
  rows_agree(bodies.moves, others.moves);
  rows_agree(bodies.turns, others.turns);
  return same;
}

void rows_move_as_numbers_do(void **) {
  for_widths([] {
    for (const dem::EffectSet outside :
         {0u, unsigned{dem::kGravity}, unsigned{dem::kDrag}, dem::kGravity | dem::kDrag}) {
      for (const dem::EffectSet turning : {0u, unsigned{dem::kFriction}}) {
        assert_true(motions_agree<2>(outside | turning));
        assert_true(motions_agree<3>(outside | turning));
      }
    }
  });
}

void a_velocity_that_is_no_number_is_told(void **) {
  for_widths([] {
    for (const double wrong : {std::nan(""), HUGE_VAL}) {
      auto bodies = random_bodies<3>(9, 0);
      bodies.velocity(4)[1] = wrong;
      const dem::MotionTask<3, double> task{&bodies, {dem::Vec<3, double>::Zero(), 0}, 0.01, 0.02};
      assert_true(std::isnan(dem::find_motion_kernel<3, double>(0)(task, 0, bodies.count())));
    }
  });
}

template <int D>
bool batches_agree(dem::EffectSet effects) {
  constexpr int32_t kCount = 200;
  const auto bodies = random_bodies<D>(kCount, 0);
  dem::Boundary<D, double> boundary;
  const double period = 12;
  if (dem::has(effects, dem::kPeriodic)) {
    boundary.period[0] = period;
    boundary.inverse_period[0] = 1 / period;
  }
  std::vector<hg_pair> pairs;
  for (int32_t a = 0; a < kCount; a++) {
    for (int32_t b = a + 1; b < kCount; b++) pairs.push_back({a, b});
  }
  const dem::BatchTask<D, double> task{bodies.places.data(), &boundary, pairs.data(), 0.1};
  const auto filler = dem::find_batch_filler<D, double>(effects);
  static dem::ContactBatch<double> batch;
  size_t met = 0, p = 0;
  for (size_t next = 0; next < pairs.size();) {
    next = filler(task, next, pairs.size(), batch);
    size_t found = 0;
    for (; p < next; p++) {
      const auto a = static_cast<size_t>(pairs[p].a), b = static_cast<size_t>(pairs[p].b);
      double separation[3] = {0, 0, 0}, square = 0;
      for (int k = 0; k < D; k++) separation[k] = bodies.position(b)[k] - bodies.position(a)[k];
      if (dem::has(effects, dem::kPeriodic)) separation[0] -= period * std::nearbyint(separation[0] * (1 / period));
      for (const double component : separation) square += component * component;
      const double touching = bodies.radius(b) + bodies.radius(a), distance = std::sqrt(square);
      if (!(square < (touching + 0.1) * (touching + 0.1))) continue;
      if (found == batch.count || batch.place[found] != p) return false;
      if (!same_bits(batch.touching[found], touching) || !same_bits(batch.distance[found], distance)) return false;
      for (int k = 0; k < D; k++) {
        if (!same_bits(batch.normal[k][found], separation[k] * (1 / distance))) return false;
      }
      found++;
    }
    if (found != batch.count) return false;
    met += found;
  }
  return met > 50;
}

void batches_hold_the_pairs_that_touch(void **) {
  for_widths([] {
    for (const dem::EffectSet effects : {0u, unsigned{dem::kPeriodic}}) {
      assert_true(batches_agree<2>(effects));
      assert_true(batches_agree<3>(effects));
    }
  });
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(rough_contacts_side_by_side_are_contacts),
      cmocka_unit_test(rows_move_as_numbers_do),
      cmocka_unit_test(a_velocity_that_is_no_number_is_told),
      cmocka_unit_test(batches_hold_the_pairs_that_touch),
  };
  return cmocka_run_group_tests_name("kernels", tests, nullptr, nullptr);
}
