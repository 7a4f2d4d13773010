// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Packings from end to end: density, walls, periodic images, progress of the relaxation, reproducibility, refusals.
#include "oracle/pairs.hpp"
#include "packing/packing.hpp"
#include "tests/packing/bytes.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace {

using packing::Law;

constexpr uint64_t kSeed = 4711;

packing::Request request_of(Law law, double ratio, int dimension) {
  packing::Request request;
  request.law = {law, ratio, dimension};
  request.count = 2000;
  request.density = 0.55;
  request.seed = kSeed;
  return request;
}

double volume_of(const particles::ParticleSet &set) {
  double volume = 0;
  for (const double r : set.radii) volume += set.dimension == 2 ? M_PI * r * r : 4 * M_PI / 3 * r * r * r;
  return volume;
}

bool inside_walls(const particles::ParticleSet &set) {
  const size_t d = static_cast<size_t>(set.dimension);
  for (size_t i = 0; i < set.count(); i++) {
    for (size_t k = 0; k < d; k++) {
      const double x = set.centers[i * d + k];
      const double room = set.periodic[k] != 0 ? 0 : set.radii[i];
      if (!(x >= room) || !(x <= set.box_max[k] - room)) {
        std::fprintf(stderr, "particle %zu (radius %g): coordinate %zu is %g\n", i, set.radii[i], k, x);
        return false;
      }
    }
  }
  return true;
}

// The overlaps over the smaller radius, of the pairs that the oracle decides exactly.
packing::Overlaps overlaps_of(const particles::ParticleSet &set) {
  hg_grid_def def = hg_default_grid_def();
  def.dimension = set.dimension;
  std::copy_n(set.box_min, 3, def.box_min);
  std::copy_n(set.box_max, 3, def.box_max);
  std::copy_n(set.periodic, 3, def.periodic);
  packing::Overlaps found;
  for (const hg_pair &pair : oracle::all_pairs(def, set, oracle::exact_interact)) {
    const auto i = static_cast<size_t>(pair.a), j = static_cast<size_t>(pair.b);
    double square = 0;
    for (int axis = 0; axis < set.dimension; axis++) {
      double x = set.center(i)[axis] - set.center(j)[axis];
      if (set.periodic[axis] != 0) x = std::remainder(x, set.box_max[axis]);
      square += x * x;
    }
    const double overlap = (set.radii[i] + set.radii[j] - std::sqrt(square)) / std::min(set.radii[i], set.radii[j]);
    found.contacts++;
    found.mean += overlap;
    found.largest = std::max(found.largest, overlap);
  }
  if (found.contacts > 0) found.mean /= static_cast<double>(found.contacts);
  return found;
}

bool good_packing(const packing::Request &request) {
  packing::Overlaps first;
  const packing::Packing made = packing::make_packing(request, [&first](int done, const packing::Overlaps &overlaps) {
    if (done == 0) first = overlaps;
  });
  const particles::ParticleSet &set = made.particles;
  double box = set.box_max[0] * set.box_max[1];
  if (set.dimension == 3) box *= set.box_max[2];
  const packing::Overlaps found = overlaps_of(set);
  const bool same_overlaps = found.contacts == made.overlaps.contacts &&
                             std::fabs(found.mean - made.overlaps.mean) <= 1e-9 * found.mean &&
                             std::fabs(found.largest - made.overlaps.largest) <= 1e-9 * found.largest;
  const bool relaxed = made.overlaps.mean < 0.5 * first.mean;
  const bool dense = std::fabs(volume_of(set) / box - request.density) < 1e-12;
  if (same_overlaps && relaxed && dense && set.count() == request.count && inside_walls(set)) return true;
  std::fprintf(stderr,
               "law %d, dimension %d, seed %llu: %zu contacts (reported %zu), mean %g (%g, at first %g), density %g\n",
               static_cast<int>(request.law.law), set.dimension, static_cast<unsigned long long>(kSeed), found.contacts,
               made.overlaps.contacts, found.mean, made.overlaps.mean, first.mean, volume_of(set) / box);
  return false;
}

bool laws_of_the_paper(int dimension) {
  return good_packing(request_of(Law::kMono, 1, dimension)) && good_packing(request_of(Law::kTwoSizes, 5, dimension)) &&
         good_packing(request_of(Law::kUniformSize, 8, dimension)) &&
         good_packing(request_of(Law::kUniformVolume, 8, dimension));
}

bool spheres_of_the_paper() { return laws_of_the_paper(3); }
bool disks_of_the_paper() { return laws_of_the_paper(2); }

bool spheres_of_other_laws() {
  packing::Request log_normal = request_of(Law::kLogNormal, 1, 3);
  log_normal.law.sigma = 0.4;
  return good_packing(log_normal) && good_packing(request_of(Law::kPowerLaw, 8, 3)) &&
         good_packing(request_of(Law::kOneGiant, 8, 3));
}

bool good_periodic_packing(int dimension, std::array<bool, 3> periodic) {
  packing::Request request = request_of(Law::kUniformVolume, 4, dimension);
  request.periodic = periodic;
  return good_packing(request);
}

bool periodic_axes() {
  return good_periodic_packing(3, {true, true, true}) && good_periodic_packing(3, {false, true, false}) &&
         good_periodic_packing(2, {true, false, false});
}

bool same_seed_same_bytes() {
  packing::Request request = request_of(Law::kUniformVolume, 8, 3);
  request.sweeps = 5;
  const packing::Packing one = packing::make_packing(request, nullptr), again = packing::make_packing(request, nullptr);
  request.seed = kSeed + 1;
  const packing::Packing other = packing::make_packing(request, nullptr);
  return test::same_bytes(one.particles.centers, again.particles.centers) &&
         test::same_bytes(one.particles.radii, again.particles.radii) &&
         !test::same_bytes(one.particles.centers, other.particles.centers) &&
         !test::same_bytes(one.particles.radii, other.particles.radii);
}

bool hash_is(int dimension, uint64_t expected) {
  packing::Request request = request_of(Law::kUniformVolume, 8, dimension);
  request.sweeps = 5;
  const uint64_t hash = test::hash_of(packing::make_packing(request, nullptr).particles);
  if (hash == expected) return true;
  std::fprintf(stderr, "dimension %d, seed %llu: hash 0x%016llx\n", dimension, static_cast<unsigned long long>(kSeed),
               static_cast<unsigned long long>(hash));
  return false;
}

// Packings are test data of others: the same on every machine and for every later version.
bool packings_stay_what_they_were() { return hash_is(3, 0xc5f839201c9dbed4u) && hash_is(2, 0x854d53514629e1f8u); }

// Two disks at one place: each goes its way along x by its share of the push.
bool coincident_centers_part() {
  const packing::Box box(2, packing::Vector::Constant(20), {});
  particles::ParticleSet set = box.empty_set();
  set.centers = {10, 10, 10, 10};
  set.radii = {1, 1};
  const packing::Overlaps left = packing::relax(box, 60, nullptr, set);
  return left.largest < 1e-6 && set.centers[0] < 9.1 && set.centers[2] > 10.9 && set.centers[1] == 10 &&
         set.centers[3] == 10;
}

// The pushes of one contact leave the centre of mass, masses ~ r^d, where it was.
bool center_of_mass_stays(int dimension) {
  const packing::Box box(dimension, packing::Vector::Constant(100), {});
  particles::ParticleSet set = box.empty_set();
  const size_t d = static_cast<size_t>(dimension);
  set.centers.assign(2 * d, 50.0);
  set.centers[d] = 53.9;
  set.radii = {3, 1};
  packing::relax(box, 1, nullptr, set);
  const double heavy = dimension == 2 ? 9 : 27;
  const double before = heavy * 50 + 53.9, after = heavy * set.centers[0] + set.centers[d];
  return set.centers[d] > 53.9 && set.centers[0] < 50 && std::fabs(after - before) < 1e-9;
}

bool a_contact_keeps_the_center_of_mass() { return center_of_mass_stays(2) && center_of_mass_stays(3); }

template <class Change>
bool refuses(Change change, const std::string &text) {
  packing::Request request = request_of(Law::kUniformVolume, 8, 3);
  change(request);
  return test::is_refused(text, [&] { packing::make_packing(request, nullptr); });
}

bool nonsense_is_refused() {
  using packing::Request;
  return refuses([](Request &r) { r.count = 0; }, "count") && refuses([](Request &r) { r.density = 0; }, "density") &&
         refuses([](Request &r) { r.density = 1; }, "not at 1") &&
         refuses([](Request &r) { r.density = NAN; }, "not at nan") &&
         refuses([](Request &r) { r.law.ratio = 0.5; }, "not 0.5") &&
         refuses([](Request &r) { r.law.ratio = INFINITY; }, "not inf") &&
         refuses([](Request &r) { r.law.dimension = 4; }, "not 4") &&
         refuses([](Request &r) { r.offset = 1; }, "[0, 1)") && refuses([](Request &r) { r.sweeps = -1; }, "-1") &&
         refuses([](Request &r) { r.law = packing::law_with("power-law", 8), r.law.exponent = 1; }, "9, not 1") &&
         refuses([](Request &r) { r.law = packing::law_with("power-law", 8), r.law.exponent = 2.5; }, "not 2.5") &&
         refuses([](Request &r) { r.law = packing::law_with("log-normal", NAN); }, "up to 3, not nan") &&
         refuses(
             [](Request &r) {
               r.law = {Law::kTwoSizes, 50, 3};
             },
             "more than 2000 particles") &&
         refuses([](Request &r) { r.count = 1, r.density = 0.9; }, "smaller than the largest particle") &&
         refuses(
             [](Request &r) {
               r.count = 20, r.periodic = {true, true, true};
             },
             "two of the largest diameter");
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<spheres_of_the_paper>),    cmocka_unit_test(passes<disks_of_the_paper>),
      cmocka_unit_test(passes<spheres_of_other_laws>),   cmocka_unit_test(passes<periodic_axes>),
      cmocka_unit_test(passes<same_seed_same_bytes>),    cmocka_unit_test(passes<packings_stay_what_they_were>),
      cmocka_unit_test(passes<coincident_centers_part>), cmocka_unit_test(passes<a_contact_keeps_the_center_of_mass>),
      cmocka_unit_test(passes<nonsense_is_refused>),
  };
  return cmocka_run_group_tests_name("packing", tests, nullptr, nullptr);
}
