// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Two plain loops over the same candidates. The library's own kernels have no such filter to be switched.
#include "programs/accuracy/prefilter_knob.hpp"

#include "particles/insert.hpp"
#include "programs/accuracy/systems.hpp"
#include "programs/measure/search_timer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

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

// Rows in the order in which the list of pairs first names them; particles without a pair come last.
std::vector<int32_t> places_along(const std::vector<hg_pair> &pairs, size_t count) {
  std::vector<int32_t> place(count, -1);
  int32_t next = 0;
  for (const hg_pair &pair : pairs) {
    for (const int32_t row : {pair.a, pair.b}) {
      if (place[static_cast<size_t>(row)] < 0) place[static_cast<size_t>(row)] = next++;
    }
  }
  for (int32_t &row : place) {
    if (row < 0) row = next++;
  }
  return place;
}

TradePoint point_of(const std::string &system, const char *setting, double seconds, size_t count, size_t wrong) {
  TradePoint point;
  point.knob = "prefilter";
  point.system = system;
  point.setting = setting;
  point.error_of = "pairs that differ";
  point.error = static_cast<double>(wrong);
  point.cost = 1e9 * seconds / static_cast<double>(count);
  return point;
}

size_t differences(const std::vector<hg_pair> &a, const std::vector<hg_pair> &b) {
  const auto same = [](const hg_pair &p, const hg_pair &q) { return p.a == q.a && p.b == q.b; };
  size_t count = std::max(a.size(), b.size()) - std::min(a.size(), b.size());
  for (size_t k = 0; k < std::min(a.size(), b.size()); k++) count += same(a[k], b[k]) ? 0 : 1;
  return count;
}

void measure_system(const std::string &system, const particles::ParticleSet &input, int repeats,
                    std::vector<TradePoint> &points) {
  const Candidates candidates = candidates_of(input);
  std::vector<hg_pair> without, with;
  std::vector<double> without_seconds, with_seconds;
  size_t tested = 0;
  for (int repeat = 0; repeat < repeats; repeat++) {
    without.clear();
    with.clear();
    without_seconds.push_back(
        measure::seconds_of([&] { overlapping(candidates.particles, candidates.pairs, without); }));
    with_seconds.push_back(
        measure::seconds_of([&] { tested = overlapping_boxes_first(candidates.particles, candidates.pairs, with); }));
  }
  const size_t count = input.count(), wrong = differences(without, with);
  points.push_back(point_of(system, "spheres at once", measure::median(without_seconds), count, 0));
  points.back().is_default = true;
  char note[100];
  std::snprintf(note, sizeof note, "%.1f candidates per particle",
                static_cast<double>(candidates.pairs.size()) / static_cast<double>(count));
  points.back().note = note;
  points.push_back(point_of(system, "boxes first", measure::median(with_seconds), count, wrong));
  std::snprintf(note, sizeof note, "boxes keep %.1f %%, of which %.1f %% overlap",
                100 * static_cast<double>(tested) / static_cast<double>(candidates.pairs.size()),
                100 * static_cast<double>(with.size()) / static_cast<double>(tested));
  points.back().note = note;
}

}  // namespace

size_t overlapping(const particles::ParticleSet &particles, const std::vector<hg_pair> &candidates,
                   std::vector<hg_pair> &pairs) {
  for (const hg_pair &pair : candidates) {
    if (spheres_overlap(gap_of(particles, pair))) pairs.push_back(pair);
  }
  return candidates.size();
}

size_t overlapping_boxes_first(const particles::ParticleSet &particles, const std::vector<hg_pair> &candidates,
                               std::vector<hg_pair> &pairs) {
  size_t tested = 0;
  for (const hg_pair &pair : candidates) {
    const Gap gap = gap_of(particles, pair);
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
  hgrid::Grid grid(def);
  particles::insert(input, grid);
  const hgrid::View<hg_pair> found = grid.query_pairs();
  Candidates result{input, {found.begin(), found.end()}};
  const std::vector<int32_t> place = places_along(result.pairs, input.count());
  for (size_t i = 0; i < place.size(); i++) {
    const auto to = static_cast<size_t>(place[i]);
    for (size_t k = 0; k < 3; k++) result.particles.centers[3 * to + k] = input.centers[3 * i + k];
    result.particles.radii[to] = input.radii[i];
  }
  for (hg_pair &pair : result.pairs) {
    pair = {place[static_cast<size_t>(pair.a)], place[static_cast<size_t>(pair.b)]};
  }
  return result;
}

std::vector<TradePoint> measure_prefilter(const Budget &budget, const Progress &progress) {
  const packing::SizeLaw equal{packing::Law::kMono, 1, 3};
  std::vector<TradePoint> points;
  progress("random places");
  measure_system("equal spheres, random places", relaxed(equal, budget.timed_count, 0), budget.repeats, points);
  progress("relaxed packing");
  measure_system("equal spheres, relaxed packing", relaxed(equal, budget.timed_count), budget.repeats, points);
  return points;
}

}  // namespace accuracy
