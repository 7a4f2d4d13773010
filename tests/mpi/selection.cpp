// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_mpi_selection [ROUNDS]: the choice of ghosts between two ranks, on one process, beside the rule as ghosts.md
// writes it, by brute force over images in long double: nothing that is needed is left out, and nothing is sent that
// the rule does not ask for.
#include "mpi/selection.hpp"

#include "tests/support/rng.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

using hgrid::mpi::ReachRule;
using hgrid::mpi::Selection;
using hgrid::mpi::SizeBox;
using hgtest::Rng;

struct Side {
  std::vector<double> centers, radii;

  size_t count() const { return radii.size(); }
};

hg_grid_def random_def(Rng &rng) {
  hg_grid_def def = hg_default_grid_def();
  def.dimension = rng.chance(0.7) ? 3 : 2;
  def.interaction = rng.chance(0.5) ? HG_CONTACT : HG_MAX_RANGE;
  def.margin = rng.chance(0.5) ? rng.uniform(0.0, 0.1) : 0;
  def.skin = rng.chance(0.5) ? rng.uniform(0.0, 0.1) : 0;
  const double offset = rng.chance(0.3) ? 1e6 : 0;
  for (int axis = 0; axis < def.dimension; axis++) {
    def.periodic[axis] = rng.chance(0.6) ? 1 : 0;
    def.box_min[axis] = offset;
    def.box_max[axis] = offset + rng.uniform(0.5, 2.0);
  }
  const auto tilt = [&](int one, int other) {
    return def.periodic[one] != 0 && def.periodic[other] != 0 && rng.chance(0.3) ? rng.uniform(-0.5, 0.5) : 0.0;
  };
  def.tilt[0] = tilt(0, 1);
  def.tilt[1] = tilt(0, 2);
  def.tilt[2] = tilt(1, 2);
  return def;
}

// A cloud somewhere in the cell, perhaps across a face, perhaps with images of its own.
Side random_side(const hg_grid_def &def, Rng &rng) {
  Side side;
  const auto d = static_cast<size_t>(def.dimension);
  const double extent = rng.uniform(0.05, 1.0);
  double corner[3] = {rng.uniform(), rng.uniform(), rng.uniform()};
  for (int k = rng.integer(0, 40); k > 0; k--) {
    for (size_t axis = 0; axis < d; axis++) {
      const double edge = def.box_max[axis] - def.box_min[axis];
      double x = def.box_min[axis] + edge * (corner[axis] + extent * rng.uniform());
      if (def.periodic[axis] != 0 && rng.chance(0.2)) x += edge * rng.integer(-1, 1);
      side.centers.push_back(x);
    }
    side.radii.push_back(rng.chance(0.1) ? 0.0 : 0.2 / std::pow(10.0, rng.uniform(0.0, 2.0)));
  }
  return side;
}

// The least distance of a place to a box over periodic images.
long double distance_to(const hg_grid_def &def, const double *place, const double *low, const double *high) {
  long double least = INFINITY;
  const int turns[3] = {def.periodic[0] != 0 ? 5 : 0, def.periodic[1] != 0 ? 5 : 0, def.periodic[2] != 0 ? 5 : 0};
  for (int k = -turns[2]; k <= turns[2]; k++) {
    for (int j = -turns[1]; j <= turns[1]; j++) {
      for (int i = -turns[0]; i <= turns[0]; i++) {
        const int n[3] = {i, j, k};
        long double image[3] = {0, 0, 0}, squares = 0;
        for (int axis = 0; axis < def.dimension; axis++) {
          image[axis] = place[axis] + n[axis] * (static_cast<long double>(def.box_max[axis]) - def.box_min[axis]);
        }
        image[0] += j * static_cast<long double>(def.tilt[0]) + k * static_cast<long double>(def.tilt[1]);
        image[1] += k * static_cast<long double>(def.tilt[2]);
        for (int axis = 0; axis < def.dimension; axis++) {
          const long double gap = std::max({low[axis] - image[axis], image[axis] - high[axis], 0.0L});
          squares += gap * gap;
        }
        least = std::min(least, std::sqrt(squares));
      }
    }
  }
  return least;
}

long double reach(const hg_grid_def &def, double larger, double smaller) {
  return (def.interaction == HG_MAX_RANGE ? larger : static_cast<long double>(larger) + smaller) + def.margin +
         def.skin;
}

struct Counts {
  long needed = 0, sent = 0, missing = 0, needless = 0;
};

void compare(const hg_grid_def &def, const Side &own, const Side &theirs, Counts &counts) {
  const ReachRule rule(def);
  const Selection selection(rule, own.count(), own.centers.data(), own.radii.data());
  const std::vector<SizeBox> boxes =
      Selection(rule, theirs.count(), theirs.centers.data(), theirs.radii.data()).boxes();
  const std::vector<int32_t> rows = selection.rows_for({boxes, {0, 0, boxes.size()}}, 0)[1];
  if (!std::is_sorted(rows.begin(), rows.end())) counts.needless++;
  const auto d = static_cast<size_t>(def.dimension);
  for (size_t j = 0; j < own.count(); j++) {
    const double *place = &own.centers[j * d];
    const bool is_sent = std::binary_search(rows.begin(), rows.end(), static_cast<int32_t>(j));
    bool needed = false, asked = false;
    for (size_t i = 0; i < theirs.count(); i++) {
      const double *other = &theirs.centers[i * d];
      needed = needed || (theirs.radii[i] <= own.radii[j] &&
                          distance_to(def, place, other, other) <= reach(def, own.radii[j], theirs.radii[i]));
    }
    for (const SizeBox &box : boxes) {
      asked = asked || (box.smallest <= own.radii[j] &&
                        distance_to(def, place, box.box.low, box.box.high) <=
                            reach(def, own.radii[j], std::min(own.radii[j], box.largest)) + 1e-7L);
    }
    counts.needed += needed ? 1 : 0;
    counts.sent += is_sent ? 1 : 0;
    counts.missing += needed && !is_sent ? 1 : 0;
    counts.needless += is_sent && !asked ? 1 : 0;
  }
}

}  // namespace

int main(int argc, char **argv) {
  const long rounds = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 300;
  Counts counts;
  for (long round = 0; round < rounds; round++) {
    Rng rng(static_cast<uint64_t>(round) + 1);
    const hg_grid_def def = random_def(rng);
    const Side own = random_side(def, rng), theirs = random_side(def, rng);
    const Counts before = counts;
    compare(def, own, theirs, counts);
    if (counts.missing > before.missing || counts.needless > before.needless) {
      std::printf("seed %ld: %ld rows are missing, %ld needless\n", round + 1, counts.missing - before.missing,
                  counts.needless - before.needless);
    }
  }
  std::printf("%ld rounds: %ld rows needed, %ld sent\n", rounds, counts.needed, counts.sent);
  return counts.missing == 0 && counts.needless == 0 && counts.needed > rounds ? 0 : 1;
}
