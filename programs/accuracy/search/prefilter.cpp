// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Varies whether boxes around the spheres are compared first. The library's own kernels have no such filter to be
// switched.
#include "programs/accuracy/search/prefilter.hpp"

#include "oracle/pairs.hpp"
#include "particles/text/formatted.hpp"
#include "programs/accuracy/contacts.hpp"
#include "programs/accuracy/search/studies.hpp"
#include "programs/accuracy/search/systems.hpp"
#include "programs/measure/search_timer.hpp"

#include <algorithm>
#include <cmath>

namespace accuracy {
namespace {

// New rows in the order in which the list of pairs first names them; particles without a pair come last.
std::vector<int32_t> rows_along(const std::vector<hg_pair> &pairs, size_t count) {
  std::vector<int32_t> rows(count, -1);
  int32_t next = 0;
  for (const hg_pair &pair : pairs) {
    for (const int32_t old : {pair.a, pair.b}) {
      if (rows[static_cast<size_t>(old)] < 0) rows[static_cast<size_t>(old)] = next++;
    }
  }
  for (int32_t &row : rows) {
    if (row < 0) row = next++;
  }
  return rows;
}

void measure_system(const particles::ParticleSet &input, Recorder &record) {
  const Candidates candidates = candidates_of(input);
  oracle::Pairs plain, filtered;
  std::vector<double> plain_seconds, filtered_seconds;
  size_t tested = 0;
  for (int repeat = 0; repeat < record.budget().repeats; repeat++) {
    plain.clear();
    filtered.clear();
    plain_seconds.push_back(measure::seconds_of([&] { filter_pairs(candidates.particles, candidates.pairs, plain); }));
    filtered_seconds.push_back(measure::seconds_of([&] { tested = filter_boxes_first(candidates, filtered); }));
  }
  const double ns = 1e9 / static_cast<double>(input.count()), pairs = static_cast<double>(candidates.pairs.size());
  record.add({"spheres at once",
              ns * measure::median(plain_seconds),
              {{"pairs that differ", 0,
                particles::formatted("%.1f candidates per particle", pairs / static_cast<double>(input.count()))}},
              true});
  std::sort(plain.begin(), plain.end(), oracle::pair_less);
  const auto wrong = static_cast<double>(oracle::difference(plain, filtered).count());
  const std::string note =
      particles::formatted("boxes keep %.1f %%, of which %.1f %% overlap", 100 * static_cast<double>(tested) / pairs,
                           100 * static_cast<double>(filtered.size()) / static_cast<double>(tested));
  record.add({"boxes first", ns * measure::median(filtered_seconds), {{"pairs that differ", wrong, note}}});
}

}  // namespace

size_t filter_boxes_first(const Candidates &candidates, std::vector<hg_pair> &pairs) {
  const double *centers = candidates.particles.centers.data(), *radii = candidates.particles.radii.data();
  size_t tested = 0;
  for (const hg_pair &pair : candidates.pairs) {
    const double *x = centers + 3 * size_t(pair.a), *y = centers + 3 * size_t(pair.b);
    const double dx = x[0] - y[0], dy = x[1] - y[1], dz = x[2] - y[2], reach = radii[pair.a] + radii[pair.b];
    if (!(std::max({std::fabs(dx), std::fabs(dy), std::fabs(dz)}) < reach)) continue;
    tested++;
    if (dx * dx + dy * dy + dz * dz < reach * reach) pairs.push_back(pair);
  }
  return tested;
}

Candidates candidates_of(const particles::ParticleSet &input) {
  const double largest = *std::max_element(input.radii.begin(), input.radii.end());
  hg_grid_def def = measure::def_of(input);
  def.margin = 2 * largest * (std::sqrt(3.0) - 1) * (1 + 1e-9);  // the corner of the box around two reaches
  Candidates result{input, found_pairs(def, input)};
  const std::vector<int32_t> rows = rows_along(result.pairs, input.count());
  for (size_t i = 0; i < rows.size(); i++) {
    const auto to = static_cast<size_t>(rows[i]);
    std::copy_n(input.center(i), 3, &result.particles.centers[3 * to]);
    result.particles.radii[to] = input.radii[i];
  }
  for (hg_pair &pair : result.pairs) {
    pair = {rows[static_cast<size_t>(pair.a)], rows[static_cast<size_t>(pair.b)]};
  }
  return result;
}

void measure_prefilter(Recorder &record) {
  record.begin("equal spheres, random places");
  measure_system(relaxed(kEqualSpheres.law, record.budget().timed_count, 0), record);
  record.begin("equal spheres, relaxed packing");
  measure_system(relaxed(kEqualSpheres.law, record.budget().timed_count), record);
}

}  // namespace accuracy
