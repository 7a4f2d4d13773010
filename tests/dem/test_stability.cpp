// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Time steps that are taken are stable: the theorem of docs/theory/time-step.md against eigenvalues of whole systems,
// the bound on the network against them, and packings and beds that come to rest at any restitution.
#include "packing/packing.hpp"
#include "tests/dem/gas.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace {

constexpr uint64_t kSeed = 71;

// A random matrix of springs between `count` points on a line, each also tied to the ground: nothing drifts away.
Eigen::MatrixXd random_springs(int count, packing::Random &random) {
  Eigen::MatrixXd matrix = 0.1 * Eigen::MatrixXd::Identity(count, count);
  for (int n = 0; n < 3 * count; n++) {
    const int a = n % count, b = static_cast<int>(random.uniform() * count);
    Eigen::VectorXd stretch = Eigen::VectorXd::Zero(count);
    stretch[a] += 1;
    stretch[b] -= 1;
    matrix += random.uniform() * stretch * stretch.transpose();
  }
  return matrix;
}

// What one step, v += -(K x + C v) dt, x += v dt, multiplies the fastest growing motion with.
double growth_per_step(const Eigen::MatrixXd &masses, const Eigen::MatrixXd &springs, const Eigen::MatrixXd &dashpots,
                       double step) {
  const Eigen::Index n = masses.rows();
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd pull = step * masses.inverse() * springs, drag = step * masses.inverse() * dashpots;
  Eigen::MatrixXd map(2 * n, 2 * n);
  map << unit - drag, -pull, step * (unit - drag), unit - step * pull;
  return map.eigenvalues().cwiseAbs().maxCoeff();
}

double largest_eigenvalue(const Eigen::MatrixXd &matrix, const Eigen::MatrixXd &masses) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, masses).eigenvalues().maxCoeff();
}

// Springs, dashpots and masses of no relation: the step is stable exactly up to where dt^2 K + 2 dt C reaches 4 M.
void steps_are_stable_exactly_below_the_limit(void **) {
  packing::Random random(kSeed);
  for (int round = 0; round < 50; round++) {
    const int count = 3 + round % 8;
    Eigen::MatrixXd masses = Eigen::MatrixXd::Zero(count, count);
    for (int k = 0; k < count; k++) masses(k, k) = std::pow(10, 3 * random.uniform());
    const Eigen::MatrixXd springs = random_springs(count, random),
                          dashpots = std::pow(10, 4 * random.uniform() - 2) * random_springs(count, random);
    const auto load = [&](double dt) { return largest_eigenvalue(dt * dt * springs + 2 * dt * dashpots, masses) / 4; };
    double low = 0, high = 1e4;
    while (high - low > 1e-12 * high) (load((low + high) / 2) < 1 ? low : high) = (low + high) / 2;
    assert_true(growth_per_step(masses, springs, dashpots, 0.999 * low) < 1 + 1e-9);
    assert_true(growth_per_step(masses, springs, dashpots, 1.001 * low) > 1 + 1e-6);
  }
}

// All springs of overlapping pairs, with friction also those along the surfaces: strength = dt^2 k + 2 dt gamma.
template <int D>
double exact_load(const dem::Setup &setup, const dem::Snapshot &state) {
  constexpr int kSpin = D == 3 ? 3 : 1, kAll = D + kSpin;
  const bool rough = dem::has(setup.effects, dem::kFriction);
  const auto count = static_cast<int>(state.radii.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(kAll * count, kAll * count), masses = matrix;
  const double log_e = std::log(setup.contact.restitution), k = setup.contact.stiffness, dt = setup.time_step;
  using Vector = Eigen::Matrix<double, D, 1>;
  for (int i = 0; i < count; i++) {
    const double m = state.masses[static_cast<size_t>(i)], r = state.radii[static_cast<size_t>(i)];
    for (int c = 0; c < kAll; c++) masses(kAll * i + c, kAll * i + c) = c < D ? m : (D == 3 ? 0.4 : 0.5) * m * r * r;
    for (int j = 0; j < i; j++) {
      const double reach = r + state.radii[static_cast<size_t>(j)];
      const Vector away = Eigen::Map<const Vector>(&state.centers[static_cast<size_t>(D * i)]) -
                          Eigen::Map<const Vector>(&state.centers[static_cast<size_t>(D * j)]);
      if (!(away.norm() < reach)) continue;
      const double reduced = 1 / (1 / m + 1 / state.masses[static_cast<size_t>(j)]);
      const double gamma = -2 * log_e * std::sqrt(k * reduced / (bodies::kPi * bodies::kPi + log_e * log_e));
      const double strength = dt * dt * k + 2 * dt * gamma;
      const Vector normal = away.normalized();
      Eigen::VectorXd stretch = Eigen::VectorXd::Zero(kAll * count);
      stretch.block(kAll * i, 0, D, 1) = normal;
      stretch.block(kAll * j, 0, D, 1) = -normal;
      matrix += strength * stretch * stretch.transpose();
      if (!rough) continue;
      for (int c = 0; c < D; c++) {  // of the surface along each axis, less what is along the normal
        const Vector along = Vector::Unit(c) - normal * normal[c];
        stretch.setZero();
        stretch.block(kAll * i, 0, D, 1) = along;
        stretch.block(kAll * j, 0, D, 1) = -along;
        Eigen::Matrix<double, kSpin, 1> turn;  // normal x along
        if constexpr (D == 3) {
          turn = normal.cross(along);
        } else {
          turn[0] = normal[0] * along[1] - normal[1] * along[0];
        }
        stretch.template segment<kSpin>(kAll * i + D) = -r * turn;
        stretch.template segment<kSpin>(kAll * j + D) = -state.radii[static_cast<size_t>(j)] * turn;
        matrix += setup.contact.tangential_stiffness * strength * stretch * stretch.transpose();
      }
    }
  }
  return largest_eigenvalue(matrix, masses) / 4;
}

// Spheres thrown into a small box, of sizes up to the ratio.
template <int D>
dem::Setup crowded(dem::EffectSet effects, double ratio, packing::Random &random) {
  dem::Setup setup;
  setup.dimension = D;
  setup.effects = effects;
  bodies::set_linear(setup, 1e4, 0.2);
  for (int n = 0; n < 24; n++) {
    const double radius = n == 0 ? ratio : 1 + 0.3 * random.uniform();
    std::vector<double> center;
    for (int k = 0; k < D; k++) center.push_back((n == 0 ? 0 : 2 * random.uniform() - 1) * (ratio + 1));
    bodies::add(setup, center, std::vector<double>(D, 0), radius, std::pow(radius, D));
  }
  setup.time_step = dem::usual_step(setup);
  return setup;
}

template <int D>
bool is_bounded(dem::EffectSet effects, double ratio, packing::Random &random) {
  const dem::Setup setup = crowded<D>(effects, ratio, random);
  const auto engine = dem::make_engine(setup);
  const double exact = exact_load<D>(setup, engine->snapshot()), bound = engine->measure().step_load;
  std::printf("%d dimensions, %s, ratio %g: bound %.4f, exact %.4f\n", D, effects == 0 ? "smooth" : "rough", ratio,
              bound, exact);
  return bound >= exact * (1 - 1e-12) && bound < 3 * exact;
}

void the_load_is_above_the_stiffest_mode(void **) {
  packing::Random random(kSeed);
  for (const double ratio : {1.0, 4.0, 20.0}) {
    for (const dem::EffectSet effects : {0u, unsigned{dem::kFriction}}) {
      for (int round = 0; round < 3; round++) {
        assert_true(is_bounded<2>(effects, ratio, random));
        assert_true(is_bounded<3>(effects, ratio, random));
      }
    }
  }
}

// A packing of spheres that are larger by `swell` than it was made for, left to itself.
struct Rest {
  double contacts = 0, energy_rise = 0, load = 0, kinetic = 0;
};

Rest come_to_rest(int dimension, double density, double swell, double restitution, dem::EffectSet effects) {
  packing::Request request;
  request.law = packing::usual_law("mono");
  request.law.dimension = dimension;
  request.count = 200;
  request.density = density;
  for (int k = 0; k < dimension; k++) request.periodic[k] = true;
  const particles::ParticleSet set = packing::make_packing(request, [](int, const packing::Overlaps &) {}).particles;
  dem::Setup setup;
  setup.dimension = dimension;
  setup.effects = effects;
  bodies::set_linear(setup, 1e4, restitution);
  setup.contact.friction = 0.5;
  const auto size = static_cast<size_t>(dimension);
  for (size_t i = 0; i < set.count(); i++) {
    const auto from = set.centers.begin() + static_cast<ptrdiff_t>(i * size);
    bodies::add(setup, {from, from + dimension}, std::vector<double>(size, 0), swell, 1);
  }
  for (int k = 0; k < dimension; k++) bodies::set_periodic(setup, k, set.box_min[k], set.box_max[k]);
  setup.time_step = dem::usual_step(setup);
  const auto engine = dem::make_engine(setup);
  const double start = engine->measure().energy();
  Rest result;
  double last = start;
  for (int look = 0; look < 60; look++) {
    engine->run(100);
    const dem::Measurement m = engine->measure();
    result.energy_rise = std::max(result.energy_rise, (m.energy() - last) / start);
    result.load = std::max(result.load, m.step_load);
    last = m.energy();
    result.kinetic = (m.translation + m.rotation) / start;
    result.contacts = 2.0 * static_cast<double>(m.contacts) / static_cast<double>(setup.count());
  }
  std::printf("%d dimensions, density %.2f, e = %g, %s: %.1f contacts, load %.3f, kinetic %.2g, rise %.2g\n", dimension,
              density * std::pow(swell, dimension), restitution, effects == 0 ? "smooth" : "rough", result.contacts,
              result.load, result.kinetic, result.energy_rise);
  return result;
}

void packings_lose_energy_at_any_restitution(void **) {
  double fewest = 100, most = 0;
  for (const double restitution : {0.5, 0.1, 0.01, 0.001, 1e-15}) {
    for (const auto &[density, swell] : {std::pair(0.60, 1.0), {0.66, 1.0}, {0.8, 1.0}, {0.95, 1.1}}) {
      for (const dem::EffectSet effects : {0u, unsigned{dem::kFriction}}) {
        const Rest rest = come_to_rest(3, density, swell, restitution, effects);
        assert_true(rest.energy_rise < 1e-9 && rest.load < 1 && rest.kinetic < 2e-3);
        fewest = std::min(fewest, rest.contacts);
        most = std::max(most, rest.contacts);
      }
    }
    const Rest flat = come_to_rest(2, 0.95, 1, restitution, 0);
    assert_true(flat.energy_rise < 1e-9 && flat.load < 1);
  }
  std::printf("%.1f to %.1f contacts per particle\n", fewest, most);
  assert_true(fewest < 3 && most > 12);
}

// Layers on a floor under gravity.
void beds_come_to_rest_at_any_restitution(void **) {
  for (const double restitution : {0.5, 0.1, 0.01, 0.001}) {
    dem::Setup setup;
    setup.effects = dem::kGravity;
    bodies::set_linear(setup, 1e4, restitution);
    setup.gravity[2] = -1;
    for (int k = 0; k < 3; k++) bodies::set_walls(setup, k, 0, k == 2 ? 40 : 10);
    packing::Random random(kSeed);
    for (int n = 0; n < 200; n++) {
      const double x = 1.2 + 1.9 * (n % 5), y = 1.2 + 1.9 * (n / 5 % 5), z = 1.1 + 2.1 * static_cast<double>(n / 25);
      bodies::add(setup, {x + 0.1 * random.uniform(), y, z}, {0, 0, 0}, 0.9, 1);
    }
    setup.time_step = dem::usual_step(setup);
    const auto engine = dem::make_engine(setup);
    engine->run(static_cast<uint64_t>(100 / setup.time_step));
    const dem::Measurement m = engine->measure();
    std::printf("bed, e = %g: kinetic energy %.3g, load %.3f\n", restitution, m.translation, m.step_load);
    assert_true(m.translation < 1e-6 && m.step_load < 1);
  }
}

// A hundred at one place are more than the limit allows for: the load tells, and rightly.
void a_crowd_beyond_all_bounds_is_seen(void **) {
  dem::Setup setup;
  bodies::set_linear(setup, 1e4, 0.001);
  packing::Random random(kSeed);
  for (int n = 0; n < 100; n++) {
    bodies::add(setup, {0.1 * random.normal(), 0.1 * random.normal(), 0.1 * random.normal()}, {0, 0, 0}, 1, 1);
  }
  setup.time_step = dem::usual_step(setup);
  const auto engine = dem::make_engine(setup);
  const double exact = exact_load<3>(setup, engine->snapshot()), bound = engine->measure().step_load;
  std::printf("load %.3g, exact %.3g\n", bound, exact);
  assert_true(exact > 1 && bound > exact);
}

void the_limit_is_named(void **) {
  for (const double restitution : {1.0, 0.5, 0.1, 0.01, 0.001, 1e-15}) {
    dem::Setup setup;
    bodies::set_linear(setup, 1e4, restitution);
    bodies::add(setup, {0, 0, 0}, {0, 0, 0}, 1, 1);
    bodies::add(setup, {3, 0, 0}, {0, 0, 0}, 1, 1);
    const dem::StepLimit limit = dem::step_limit(setup);
    setup.time_step = 1.001 * limit.longest;
    assert_true(test::is_refused(dem::text(limit.longest) + " is the limit", [&] { dem::make_engine(setup); }));
    setup.time_step = 0.999 * limit.longest;
    assert_true(dem::make_engine(setup) != nullptr);
    assert_true(dem::usual_step(setup) <= limit.longest);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(steps_are_stable_exactly_below_the_limit),
      cmocka_unit_test(the_load_is_above_the_stiffest_mode),
      cmocka_unit_test(packings_lose_energy_at_any_restitution),
      cmocka_unit_test(beds_come_to_rest_at_any_restitution),
      cmocka_unit_test(a_crowd_beyond_all_bounds_is_seen),
      cmocka_unit_test(the_limit_is_named),
  };
  return cmocka_run_group_tests_name("stability", tests, nullptr, nullptr);
}
