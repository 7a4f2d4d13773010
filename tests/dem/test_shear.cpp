// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Periodic axes and Lees-Edwards shear: pairs across the faces against all images, and a sheared gas against a box of
// images in open space.
#include "dem/output/picture.hpp"
#include "dem/state/contact_search.hpp"
#include "packing/packing.hpp"
#include "particles/insert.hpp"
#include "tests/dem/gas.hpp"
#include "tests/support/frame.h"

#include <algorithm>
#include <cstdio>
#include <set>
#include <utility>

namespace {

constexpr uint64_t kSeed = 31;

using Pairs = std::set<std::pair<int, int>>;

dem::Setup sheared_gas(double rate, double largest = 1) {
  bodies::Gas gas;
  gas.edge = 6;
  gas.spacing = 2.0;
  gas.largest = largest;
  gas.temperature = 1;
  dem::Setup setup = bodies::make_sheared_gas(gas, rate, kSeed);
  for (size_t i = 0; i < setup.count(); i++) setup.velocities[3 * i] += rate * (setup.centers[3 * i + 1] - 6);
  return setup;
}

// All pairs that overlap through any of 27 images, of which those above are shifted by the offset.
Pairs pairs_by_images(const dem::Setup &setup, double offset) {
  Pairs pairs;
  const double length = setup.box_max[0];
  for (size_t i = 0; i < setup.count(); i++) {
    for (size_t j = i + 1; j < setup.count(); j++) {
      for (int image = 0; image < 27; image++) {
        const double shift[3] = {image % 3 - 1.0, image / 3 % 3 - 1.0, static_cast<double>(image / 9) - 1};
        double square = 0;
        for (size_t k = 0; k < 3; k++) {
          double d = setup.centers[3 * j + k] - setup.centers[3 * i + k] + shift[k] * length;
          if (k == 0) {
            d += shift[1] * offset;
            d -= length * std::round(d / length);
          }
          square += d * d;
        }
        if (square < std::pow(setup.radii[i] + setup.radii[j], 2)) {
          pairs.insert({static_cast<int>(i), static_cast<int>(j)});
        }
      }
    }
  }
  return pairs;
}

bool search_agrees(double offset) {
  const dem::Setup setup = sheared_gas(1, 1.3);
  dem::ContactSearch search(setup, 0);
  hg_array centers[3];
  for (size_t k = 0; k < 3; k++) centers[k] = {&setup.centers[k], 3 * sizeof(double), HG_REAL64, 0};
  const dem::PairView found = search.find(setup.count(), centers, nullptr, offset);
  Pairs listed;
  bool ascending = true;
  for (const hg_pair &pair : found) {
    ascending = ascending && (listed.empty() || *listed.rbegin() < std::make_pair(pair.a, pair.b));
    listed.insert({pair.a, pair.b});
  }
  const Pairs expected = pairs_by_images(setup, offset);
  std::printf("offset %g: %zu pairs, %zu by images\n", offset, listed.size(), expected.size());
  return ascending && !listed.empty() && listed.size() == found.size() && listed == expected;
}

void pairs_across_sheared_faces_are_all_found(void **) {
  // 6 is half a box length: an image to the left is as near as one to the right.
  for (const double offset : {0.0, 0.7, 6.0, 11.9}) assert_true(search_agrees(offset));
}

// Two particles that meet through the faces along y as their images say.
double speed_gained_across(double rate) {
  dem::Setup setup;
  setup.effects = dem::kShear;
  bodies::set_linear(setup, 1e4);
  for (int k = 0; k < 3; k++) bodies::set_periodic(setup, k, 0, 20);
  setup.shear_rate = rate;
  bodies::add(setup, {5, 19.5, 5}, {0, 4, 0}, 1, 1);
  setup.time_step = 1e-3;
  const auto engine = dem::make_engine(setup);
  engine->run(1000);
  const dem::Snapshot state = engine->snapshot();
  std::printf("crossed to (%g, %g) with u_x = %g\n", state.centers[0], state.centers[1], state.velocities[0]);
  return state.centers[1] < 10 ? state.velocities[0] : 1e9;
}

void crossing_a_face_takes_the_speed_of_the_image(void **) {
  assert_true(std::fabs(speed_gained_across(0.3) + 0.3 * 20) < 1e-12);
  assert_true(speed_gained_across(0) == 0);
}

// Shear of rate 0 is a periodic box.
double shear_at_rest_error() {
  const dem::Setup sheared = sheared_gas(0);
  dem::Setup periodic = sheared;
  periodic.effects &= ~static_cast<unsigned>(dem::kShear);
  const auto a = dem::make_engine(sheared), b = dem::make_engine(periodic);
  a->run(500);
  b->run(500);
  const dem::Snapshot one = a->snapshot(), other = b->snapshot();
  double worst = 0;
  for (size_t k = 0; k < one.velocities.size(); k++) {
    worst = std::max(worst, std::fabs(one.velocities[k] - other.velocities[k]));
  }
  std::printf("shear of rate 0 and periodic box: velocities within %.3g\n", worst);
  return worst;
}

void shear_at_rest_is_a_periodic_box(void **) { assert_true(shear_at_rest_error() < 1e-9); }

// Work of the shear stress heats an elastic gas, and the mean velocity keeps its profile.
void shear_heats_an_elastic_gas(void **) {
  double start = 0, end = 0, slope = 0;
  {
    const dem::Setup setup = sheared_gas(1);
    const auto engine = dem::make_engine(setup);
    start = engine->measure().translation;
    engine->run(8000);
    end = engine->measure().translation;
    const dem::Snapshot state = engine->snapshot();
    double xy = 0, yy = 0;
    for (size_t i = 0; i < state.radii.size(); i++) {
      const double y = state.centers[3 * i + 1] - 6;
      xy += state.masses[i] * y * state.velocities[3 * i];
      yy += state.masses[i] * y * y;
    }
    slope = xy / yy;
  }
  std::printf("kinetic energy from %.4g to %.4g, profile %.3f\n", start, end, slope);
  assert_true(end > 1.2 * start);
  assert_true(slope > 0.5 && slope < 1.5);
}

// What is shown of a sheared gas is a tilted cell, in which the contacts are those of the simulation.
void pictures_tell_the_tilt(void **) {
  size_t contacts = 0, found = 0;
  double tilt = 0;
  {
    const dem::Setup setup = sheared_gas(0.3, 1.3);
    const auto engine = dem::make_engine(setup);
    engine->run(2000);
    contacts = engine->measure().contacts;
    const particles::ParticleSet set = output::picture_of(setup, 2000, engine->snapshot());
    hg_grid_def def = hg_default_grid_def();
    particles::set_box(set, def);
    hgrid::Grid grid(def);
    particles::insert(set, grid);
    found = grid.query_pairs().size();
    tilt = set.tilt[0] - std::remainder(0.3 * 12 * engine->measure().time, 12);
    std::printf("%zu contacts, %zu in the picture, tilt %g\n", contacts, found, set.tilt[0]);
  }
  assert_true(contacts > 0 && found == contacts);
  assert_true(std::fabs(tilt) < 1e-9);
}

// The mean square of the velocities relative to the flow, over 3, that shear at the rate 1 keeps up: the heat that the
// viscosity of Garzo & Dufty, Phys. Rev. E 59 (1999) 5895, makes is what collisions take. Their kinetic part is of
// first order in the rate; here it is that of Grad's moments of a gas in uniform shear, which is of any order.
double theory_of_shear(double restitution, double density, double diameter) {
  const double a = restitution, phi = density, chi = (1 - phi / 2) / std::pow(1 - phi, 3);
  const double c = 32 * (1 - a) * (1 - 2 * a * a) / (81 - 17 * a + 30 * a * a * (1 - a));
  const double cooling = 5.0 / 12 * chi * (1 - a * a) * (1 + 3 * c / 32);
  const double collisions = chi * (1 - std::pow(1 - a, 2) / 4) * (1 - c / 64);
  const double kinetic = collisions / std::pow(collisions + cooling, 2) * (1 - 0.4 * (1 + a) * (1 - 3 * a) * phi * chi);
  const double bulk = 128 / (5 * bodies::kPi) * phi * phi * chi * (1 + a) * (1 - c / 32);
  const double viscosity = kinetic * (1 + 0.8 * phi * chi * (1 + a)) + 0.6 * bulk;
  const double number = 6 * phi / (bodies::kPi * std::pow(diameter, 3));
  return 25 * viscosity / (384 * bodies::kPi * std::pow(diameter, 4) * number * number * cooling);
}

double temperature_of_shear(double restitution, double density) {
  packing::Request request;
  request.law = packing::usual_law("mono");
  request.count = 1000;
  request.density = density;
  for (int k = 0; k < 3; k++) request.periodic[static_cast<size_t>(k)] = true;
  const particles::ParticleSet set = packing::make_packing(request, [](int, const packing::Overlaps &) {}).particles;
  dem::Setup setup;
  setup.effects = dem::kShear;
  setup.shear_rate = 1;
  bodies::set_linear(setup, 1e5, restitution);
  for (int k = 0; k < 3; k++) bodies::set_periodic(setup, k, set.box_min[k], set.box_max[k]);
  const double middle = (set.box_min[1] + set.box_max[1]) / 2;
  packing::Random random(kSeed);
  for (size_t i = 0; i < set.count(); i++) {
    const double *x = &set.centers[3 * i];
    const double u = 1.4 * random.normal(), v = 1.4 * random.normal(), w = 1.4 * random.normal();
    bodies::add(setup, {x[0], x[1], x[2]}, {u + x[1] - middle, v, w}, 1, 1);
  }
  bodies::set_steps_per_contact(setup, 50);
  const auto engine = dem::make_engine(setup);
  const auto look = static_cast<uint64_t>(0.2 / setup.time_step);
  engine->run(30 * look);
  double sum = 0;
  for (int k = 0; k < 40; k++) {
    engine->run(look);
    const dem::Snapshot state = engine->snapshot();
    for (size_t i = 0; i < state.count(); i++) {
      const double *v = &state.velocities[3 * i];
      const double along = v[0] - (state.centers[3 * i + 1] - middle);
      sum += (along * along + v[1] * v[1] + v[2] * v[2]) / 3;
    }
  }
  return sum / (40 * static_cast<double>(setup.count()));
}

void sheared_gases_are_as_hot_as_theory_says(void **) {
  for (const double restitution : {0.8, 0.9}) {
    const double found = temperature_of_shear(restitution, 0.3), expected = theory_of_shear(restitution, 0.3, 2);
    std::printf("e = %g: %.3f (%.3f)\n", restitution, found, expected);
    assert_true(std::fabs(found / expected - 1) < 0.08);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(pairs_across_sheared_faces_are_all_found),
      cmocka_unit_test(crossing_a_face_takes_the_speed_of_the_image),
      cmocka_unit_test(shear_at_rest_is_a_periodic_box),
      cmocka_unit_test(shear_heats_an_elastic_gas),
      cmocka_unit_test(pictures_tell_the_tilt),
      cmocka_unit_test(sheared_gases_are_as_hot_as_theory_says),
  };
  return cmocka_run_group_tests_name("shear", tests, nullptr, nullptr);
}
