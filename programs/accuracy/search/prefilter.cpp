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

struct Gap {
  double d[3];
  double reach;
};

Gap gap_of(const particles::ParticleSet &particles, const hg_pair &pair) {
  const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
  const double *x = &particles.centers[3 * a], *y = &particles.centers[3 * b];
  return {{x[0] - y[0], x[1] - y[1], x[2] - y[2]}, particles.radii[a] + particles.radii[b]};
}

bool spheres_overlap(const Gap &gap) {
  return gap.d[0] * gap.d[0] + gap.d[1] * gap.d[1] + gap.d[2] * gap.d[2] < gap.reach * gap.reach;
}

bool boxes_overlap(const Gap &gap) {
  return std::max({std::fabs(gap.d[0]), std::fabs(gap.d[1]), std::fabs(gap.d[2])}) < gap.reach;
}

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

struct Loop {
  const Candidates *candidates;
  size_t (*find)(const Candidates &, std::vector<hg_pair> &);
  std::vector<hg_pair> pairs;
  size_t tested = 0;
  std::vector<double> seconds;

  void run() {
    pairs.clear();
    seconds.push_back(measure::seconds_of([this] { tested = find(*candidates, pairs); }));
  }
};

void measure_system(const particles::ParticleSet &input, Recorder &record) {
  const Candidates candidates = candidates_of(input);
  std::vector<Loop> loops = {{&candidates, overlapping, {}, 0, {}}, {&candidates, overlapping_boxes_first, {}, 0, {}}};
  measure::in_turns(loops, record.budget().repeats);
  const Loop &plain = loops[0], &filtered = loops[1];
  const auto count = static_cast<double>(input.count()), pairs = static_cast<double>(candidates.pairs.size());
  const auto ns = [count](const Loop &loop) { return 1e9 * measure::median(loop.seconds) / count; };
  const auto tested = static_cast<double>(filtered.tested);
  const std::string kept = particles::formatted("boxes keep %.1f %%, of which %.1f %% overlap", 100 * tested / pairs,
                                                100 * static_cast<double>(filtered.pairs.size()) / tested);
  std::vector<hg_pair> truth = plain.pairs;
  std::sort(truth.begin(), truth.end(), oracle::pair_less);
  const auto wrong = static_cast<double>(oracle::difference(truth, filtered.pairs).count());
  record.add({"spheres at once",
              ns(plain),
              {{"pairs that differ", 0, particles::formatted("%.1f candidates per particle", pairs / count)}},
              true});
  record.add({"boxes first", ns(filtered), {{"pairs that differ", wrong, kept}}});
}

}  // namespace

size_t overlapping(const Candidates &candidates, std::vector<hg_pair> &pairs) {
  for (const hg_pair &pair : candidates.pairs) {
    if (spheres_overlap(gap_of(candidates.particles, pair))) pairs.push_back(pair);
  }
  return candidates.pairs.size();
}

size_t overlapping_boxes_first(const Candidates &candidates, std::vector<hg_pair> &pairs) {
  size_t tested = 0;
  for (const hg_pair &pair : candidates.pairs) {
    const Gap gap = gap_of(candidates.particles, pair);
    if (!boxes_overlap(gap)) continue;
    tested++;
    if (spheres_overlap(gap)) pairs.push_back(pair);
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
  const packing::SizeLaw equal{packing::Law::kMono, 1, 3};
  record.begin("equal spheres, random places");
  measure_system(relaxed(equal, record.budget().timed_count, 0), record);
  record.begin("equal spheres, relaxed packing");
  measure_system(relaxed(equal, record.budget().timed_count), record);
}

}  // namespace accuracy
