// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Soft elastic fluids in equilibrium against the theory of hard spheres: pressure, and collisions as the number of
// contacts at a time.
//
// Springs of stiffness k let partners at kT = 1 approach by sqrt(pi / (2 k)) more on average, whatever their sizes and
// masses: theory is asked for hard spheres that are smaller by that (Barker & Henderson, J. Chem. Phys. 47 (1967)
// 4714). In equilibrium that is also the gap at touching which holds as many partners as are in contact. A contact of
// reduced mass mu lasts pi sqrt(mu / k), so contacts at a time are collisions per time times their duration.
#include "packing/box.hpp"
#include "packing/event/growth.hpp"
#include "packing/random.hpp"
#include "tests/dem/bodies.hpp"
#include "tests/packing/event/hard_spheres.hpp"
#include "tests/support/frame.h"

#include <cmath>
#include <cstdio>

namespace {

constexpr uint64_t kSeed = 77;
constexpr double kStiffness = 1e5;

// A fluid without overlaps in a periodic cube, masses as radii to some power, all degrees of freedom at kT = 1.
dem::Setup grown_fluid(const std::vector<double> &radii, double edge, int power) {
  packing::event::GrowthRequest request;
  request.radii = radii;
  request.seed = kSeed;
  request.rate = 0.05;
  const packing::Box box(3, packing::Vector::Constant(edge), {true, true, true});
  const std::vector<packing::Vector> centers = packing::event::grow(box, request).centers;
  dem::Setup setup;
  bodies::set_linear(setup, kStiffness);
  for (int axis = 0; axis < 3; axis++) bodies::set_periodic(setup, axis, 0, edge);
  packing::Random random(kSeed);
  for (size_t i = 0; i < radii.size(); i++) {
    const double mass = std::pow(radii[i], power), speed = 1 / std::sqrt(mass);
    const double x = random.normal(), y = random.normal(), z = random.normal();
    bodies::add(setup, {centers[i][0], centers[i][1], centers[i][2]}, {speed * x, speed * y, speed * z}, radii[i],
                mass);
  }
  setup.skin = 0.2;
  bodies::set_steps_per_contact(setup, 15);
  return setup;
}

struct Fluid {
  double compressibility = 0, contacts = 0;  // p V / (N kT), partners in contact of a particle; on average
};

// At the temperature that motion has; contacts hold a little of the energy.
Fluid measure(const dem::Setup &setup, uint64_t settle, int looks) {
  const auto engine = dem::make_engine(setup);
  engine->run(settle);
  double virial = 0, heat = 0, contacts = 0;
  for (int look = 0; look < looks; look++) {
    engine->run(8);
    const dem::Measurement m = engine->measure();
    virial += m.virial;
    heat += 2 * m.translation;  // 3 N kT
    contacts += static_cast<double>(m.contacts);
  }
  const double temperature = heat / (3.0 * looks * static_cast<double>(setup.count()));
  return {1 + virial / heat, 2 * contacts / (looks * static_cast<double>(setup.count()) * std::sqrt(temperature))};
}

struct Case {
  const char *what;
  double fraction;
  int power;        // of the radius: the mass
  uint64_t settle;  // steps
  int looks;
  double tolerance;
};

bool is_hard_sphere_fluid(const Case &run, std::vector<double> radii) {
  double volume = 0;
  for (const double r : radii) volume += 4 * bodies::kPi / 3 * r * r * r / run.fraction;
  const dem::Setup setup = grown_fluid(radii, std::cbrt(volume), run.power);
  const Fluid found = measure(setup, run.settle, run.looks);
  const double deeper = std::sqrt(bodies::kPi / (2 * kStiffness));
  for (double &r : radii) r -= deeper / 2;
  const theory::HardSpheres hard(radii, volume);
  const double rate = hard.rate(setup.masses), shortest = dem::shortest_contact(setup).duration;
  std::printf("%s at %g, seed %llu: Z = %.4f (%.4f), contacts per particle %.5f (%.5f), t_c %.4f of the time between\n",
              run.what, run.fraction, static_cast<unsigned long long>(kSeed), found.compressibility,
              hard.compressibility(), found.contacts, hard.neighbours(deeper), shortest * rate);
  return std::fabs(found.compressibility / hard.compressibility() - 1) < run.tolerance &&
         std::fabs(found.contacts / hard.neighbours(deeper) - 1) < run.tolerance;
}

void equal_spheres(void **) {
  assert_true(is_hard_sphere_fluid({"equal", 0.4, 3, 4000, 1200, 0.02}, std::vector<double>(1000, 1.0)));
}

void two_sizes(void **) {
  std::vector<double> radii(2000, 1.0);
  for (size_t i = 0; i < 200; i++) radii[10 * i] = 3;
  assert_true(is_hard_sphere_fluid({"two sizes, ratio 3", 0.4, 3, 4000, 800, 0.03}, radii));
}

// The paper's uniform volume: each size class has the same share of the volume. Equal masses, of which theory is free:
// giants a thousand times as heavy would not forget in this time how they were grown.
void uniform_volume_of_ratio_10(void **) {
  std::vector<double> radii(2000);
  for (size_t i = 0; i < radii.size(); i++) {
    radii[i] = 1 / std::sqrt(1 - (static_cast<double>(i) + 0.5) / 2000 * (1 - 0.01));
  }
  assert_true(is_hard_sphere_fluid({"uniform volume, ratio 10", 0.45, 0, 8000, 1500, 0.03}, radii));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(equal_spheres),
      cmocka_unit_test(two_sizes),
      cmocka_unit_test(uniform_volume_of_ratio_10),
  };
  return cmocka_run_group_tests_name("fluid", tests, nullptr, nullptr);
}
