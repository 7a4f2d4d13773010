// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What holds for every arrangement of the table: count, sizes, reproducibility, and that space is stretched with them.
#include "packing/arrangement.hpp"
#include "packing/packing.hpp"
#include "tests/packing/bytes.hpp"
#include "tests/particles/page.hpp"
#include "tests/support/frame.h"
#include "tests/support/refusal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace {

using packing::Arrangement;

constexpr uint64_t kSeed = 99;
constexpr size_t kCount = 1009;  // no number of points of a cube

packing::Request request_of(const Arrangement &arrangement, const packing::SizeLaw &law, int dimension) {
  packing::Request request;
  request.law = law;
  request.law.dimension = dimension;
  request.arrangement = &arrangement;
  request.density = arrangement.density;
  request.count = kCount;
  request.seed = kSeed;
  return request;
}

// Runs a check for each arrangement but the even one, in both dimensions.
template <class Check>
bool for_uneven(Check check) {
  bool good = true;
  for (const Arrangement &arrangement : packing::arrangements()) {
    for (const int dimension : {2, 3}) {
      if (arrangement.is_even() || check(arrangement, dimension)) continue;
      std::fprintf(stderr, "arrangement %s in %d dimensions, seed %llu\n", arrangement.name, dimension,
                   static_cast<unsigned long long>(kSeed));
      good = false;
    }
  }
  return good;
}

std::vector<double> sorted(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

// The places of `set` are those of `equal` times the root of the mean volume.
bool is_stretched(const particles::ParticleSet &set, const particles::ParticleSet &equal) {
  const int d = set.dimension;
  double mean = 0;
  for (const double r : set.radii) mean += std::pow(r, d) / static_cast<double>(set.count());
  const double scale = std::pow(mean, 1.0 / d);
  for (size_t k = 0; k < set.centers.size(); k++) {
    const double expected = scale * equal.centers[k];
    if (!std::isfinite(set.centers[k]) || std::fabs(set.centers[k] - expected) > 1e-12 * (std::fabs(expected) + scale))
      return false;
  }
  return std::fabs(set.box_max[0] - scale * equal.box_max[0]) <= 1e-12 * set.box_max[0];
}

bool every_law_stretches_space() {
  return for_uneven([](const Arrangement &arrangement, int dimension) {
    const auto equal = packing::lay_particles(request_of(arrangement, packing::usual_law("mono"), dimension));
    return std::all_of(packing::size_laws().begin(), packing::size_laws().end(), [&](const packing::LawRow &row) {
      packing::SizeLaw law = packing::usual_law(row.name);
      law.table = std::make_shared<packing::SizeTable>(packing::SizeTable{{{1, 0}, {5, 1}}});
      if (row.law != packing::Law::kMono) law.ratio = 5;
      const packing::Request request = request_of(arrangement, law, dimension);
      const particles::ParticleSet set = packing::lay_particles(request);
      return set.dimension == dimension && set.count() == kCount &&
             set.centers.size() == kCount * static_cast<size_t>(dimension) &&
             sorted(set.radii) == packing::sample_radii(request.law, kCount, request.offset) &&
             is_stretched(set, equal);
    });
  });
}

bool any_count_is_laid() {
  return for_uneven([](const Arrangement &arrangement, int dimension) {
    const std::array<size_t, 6> counts = {1, 2, 3, 5, 31, 64};
    return std::all_of(counts.begin(), counts.end(), [&](size_t count) {
      packing::Request request = request_of(arrangement, packing::usual_law("mono"), dimension);
      request.count = count;
      const particles::ParticleSet set = packing::lay_particles(request);
      return set.count() == request.count &&
             std::all_of(set.centers.begin(), set.centers.end(), [](double x) { return std::isfinite(x); });
    });
  });
}

bool same_seed_same_bytes() {
  return for_uneven([](const Arrangement &arrangement, int dimension) {
    packing::Request request = request_of(arrangement, packing::law_with("uniform-volume", 8), dimension);
    const particles::ParticleSet one = packing::lay_particles(request), again = packing::lay_particles(request);
    request.seed = kSeed + 1;
    const particles::ParticleSet other = packing::lay_particles(request);
    return test::same_bytes(one.centers, again.centers) && test::same_bytes(one.radii, again.radii) &&
           !test::same_bytes(one.centers, other.centers) && !test::same_bytes(one.radii, other.radii);
  });
}

struct Hashes {
  const char *name;
  uint64_t flat, solid;
};

// Arrangements are test data of others: the same on every machine and for every later version.
constexpr Hashes kHashes[] = {
    {"gas", 0x67685acd4b5597b6, 0xcce4594dfcc6e223},       {"clusters", 0x578f486f2034ff23, 0x02b4f6544bae0c8b},
    {"clumps", 0xe059a1ebcd3fabe1, 0x27718ad4233da1ad},    {"crowd", 0x52178eb50f7dc608, 0x1934a0f184110457},
    {"filaments", 0x9bc1670cdeb5341e, 0xa236a9f832e191b1}, {"film", 0x0f031995c04f7ef3, 0xb448f91cbe764a8e},
    {"shell", 0xdea0412684fecbc6, 0x40297cbca5fd4e52},     {"jet", 0x17f0ba2d42b4a774, 0xf1b27f70ffc0fac7},
    {"far", 0x7e338e52390a7e6a, 0x92e947f303670c0f},       {"outliers", 0x0d1bd140b26d9874, 0x43f2f898ce4832e5},
    {"dust", 0xa5835a47b21e30b7, 0x3d25222dca85c97d},      {"scales", 0xf491eac5e56c7983, 0xa0c4723a036ff026},
    {"part", 0x6f3637e8b784807f, 0x41c64ed3a36b4f7f},      {"part-across", 0xefb2786b6c107312, 0x27593040ed060e39},
};

bool bytes_stay_what_they_were() {
  return for_uneven([](const Arrangement &arrangement, int dimension) {
    const auto request = request_of(arrangement, packing::law_with("uniform-volume", 8), dimension);
    const uint64_t hash = test::hash_of(packing::lay_particles(request));
    const auto row = std::find_if(std::begin(kHashes), std::end(kHashes),
                                  [&](const Hashes &hashes) { return arrangement.name == std::string(hashes.name); });
    if (row != std::end(kHashes) && hash == (dimension == 2 ? row->flat : row->solid)) return true;
    std::fprintf(stderr, "hash 0x%016llx\n", static_cast<unsigned long long>(hash));
    return false;
  });
}

bool packings_report_the_overlaps() {
  const packing::Request request = request_of(packing::arrangement_called("outliers"), packing::usual_law("mono"), 2);
  const packing::Packing made = packing::make_packing(request, nullptr);
  // The two outliers that overlap are one apart, by a last digit of 1e15.
  return made.overlaps.contacts > 0 && std::fabs(made.overlaps.largest - 1) <= 0.125;
}

// docs/guide/command.md has a line for every row of the table.
bool page_tells_all() {
  for (const Arrangement &row : packing::arrangements()) {
    if (!test::page_has(HGRID_COMMAND_PAGE, std::string("| ") + row.name + " | " + row.places + " |\n")) return false;
  }
  return true;
}

bool names() {
  const std::vector<Arrangement> &rows = packing::arrangements();
  return rows.front().is_even() &&
         std::all_of(rows.begin(), rows.end(),
                     [](const Arrangement &row) { return &packing::arrangement_called(row.name) == &row; }) &&
         test::is_refused("'heap'", [] { packing::arrangement_called("heap"); });
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(passes<every_law_stretches_space>),
      cmocka_unit_test(passes<any_count_is_laid>),
      cmocka_unit_test(passes<same_seed_same_bytes>),
      cmocka_unit_test(passes<bytes_stay_what_they_were>),
      cmocka_unit_test(passes<packings_report_the_overlaps>),
      cmocka_unit_test(passes<names>),
      cmocka_unit_test(passes<page_tells_all>),
  };
  return cmocka_run_group_tests_name("arrangement", tests, nullptr, nullptr);
}
