// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// hgrid_selection: what one rank of many does in libhgrid_mpi, on one process. How long it takes to choose the ghosts
// of its neighbours, and its search, for ranks of an even periodic system. Prints CSV.
#include "mpi/selection.hpp"

#include "particles/insert.hpp"
#include "programs/bench/program.hpp"
#include "programs/bench/thrown.hpp"
#include "programs/measure/statistics.hpp"
#include "programs/ranks/repeated.hpp"

#include <hgrid/hgrid.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

namespace {

using hgrid::mpi::BoxesOfRanks;
using hgrid::mpi::ReachRule;
using hgrid::mpi::Selection;
using ranks::Part;

struct Options {
  bench::Thrown thrown{"uniform-volume", 50, 500000};
  std::vector<int> ranks{8, 64};
  int repeats = 5;
};

// Median ns of processor time of so many turns of `work`, which is done `units` times in each.
template <class Work>
double nanoseconds(int repeats, double units, Work &&work) {
  std::vector<double> samples;
  for (int k = 0; k < repeats; k++) {
    const std::clock_t start = std::clock();
    work();
    samples.push_back(1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / units);
  }
  return measure::median(samples);
}

// All that one rank of some does when it chooses ghosts.
void time_selection(const Options &options, const hg_grid_def &def, const std::vector<Part> &parts) {
  const ReachRule rule(def);
  BoxesOfRanks boxes{{}, {0}};
  for (const Part &part : parts) {
    const auto own = make_size_classes(rule.cell(), part.count(), part.centers.data(), part.radii.data()).boxes;
    boxes.boxes.insert(boxes.boxes.end(), own.begin(), own.end());
    boxes.begin.push_back(boxes.boxes.size());
  }
  const size_t rank = parts.size() / 2;
  const Part &own = parts[rank];
  const Selection mine(rule, own.count(), own.centers.data(), own.radii.data());
  size_t neighbours = 0, rows = 0;
  for (const auto &chosen : mine.rows_for(boxes, rank)) {
    neighbours += chosen.empty() ? 0 : 1;
    rows += chosen.size();
  }
  const auto n = static_cast<double>(own.count());
  const double sizes = nanoseconds(
      options.repeats, n, [&] { const Selection again(rule, own.count(), own.centers.data(), own.radii.data()); });
  const double choice = nanoseconds(options.repeats, n, [&] { (void)mine.rows_for(boxes, rank); });
  std::printf("%s,%g,%zu,%zu,%zu,%.3f,%.1f,%.1f,%.2f\n", options.thrown.law.c_str(), options.thrown.ratio, parts.size(),
              own.count(), neighbours, static_cast<double>(rows) / n, sizes, choice,
              choice / static_cast<double>(neighbours));
}

// The search of a rank of 8^3 that stands at `faces` faces of the cell, so that ghosts lie at both of its ends, over
// that of the same particles in open space: places given anew and all pairs asked for.
void time_search(const Options &options, const hg_grid_def &def, const Part &part, size_t faces) {
  constexpr int kSide = 8;
  const ranks::Repeated repeated = ranks::repeat(def, part, kSide);
  std::vector<double> radii = part.radii, open = part.centers;
  radii.insert(radii.end(), repeated.ghosts.radii.begin(), repeated.ghosts.radii.end());
  open.insert(open.end(), repeated.ghosts.centers.begin(), repeated.ghosts.centers.end());
  std::vector<double> wrapped = open;
  hg_grid_def all = ranks::cell_of_all(def, kSide);
  for (size_t k = 0; k < wrapped.size(); k++) {
    if (k % 3 >= faces) continue;
    const double edge = all.box_max[k % 3] - all.box_min[k % 3];
    wrapped[k] -= edge * std::floor((wrapped[k] - all.box_min[k % 3]) / edge);
  }
  // As mpi/local_search.cpp does on axes that the rank and its ghosts do not span.
  for (size_t axis = faces; axis < 3; axis++) {
    all.periodic[axis] = 0;
    all.box_min[axis] = all.box_max[axis] = 0;
  }
  std::vector<int32_t> groups(radii.size(), 1);  // ghosts do not meet
  std::fill_n(groups.begin(), part.count(), 0);
  double cost[2] = {0, 0};
  size_t pairs[2] = {0, 0};
  for (const int periodic : {0, 1}) {
    hg_grid_def used = periodic != 0 ? all : hg_default_grid_def();
    used.thread_count = 1;
    hgrid::Grid grid(used);
    const std::vector<double> &places = periodic != 0 ? wrapped : open;
    grid.insert(radii.size(), places.data(), radii.data());
    grid.set_groups(groups.size(), groups.data());
    grid.set_group_pair(1, 1, false);
    cost[periodic] = nanoseconds(options.repeats, static_cast<double>(part.count()), [&] {
      grid.move(radii.size(), places.data());
      pairs[periodic] = grid.query_pairs().size();
    });
  }
  std::printf("%s,%g,%d,%zu,%zu,%zu,%zu,%zu,%.1f,%.1f,%.2f\n", options.thrown.law.c_str(), options.thrown.ratio,
              kSide * kSide * kSide, faces, part.count(), repeated.ghosts.count(), pairs[1], pairs[0], cost[0], cost[1],
              cost[1] / cost[0]);
}

int measure_all(const Options &options) {
  const particles::ParticleSet set = bench::throw_particles(options.thrown);
  hg_grid_def def = hg_default_grid_def();
  particles::set_box(set, def);
  std::printf(
      "law,ratio,ranks,owned,neighbours,sent per owned,ns per particle for its classes,"
      "ns per particle for the choice,of it per neighbour\n");
  const std::vector<double> ones(set.count(), 1.0);
  for (const int ranks : options.ranks) {
    time_selection(options, def, ranks::parts_of(set, ranks::bisect(set, ones, ranks), ranks));
    std::fflush(stdout);
  }
  std::printf(
      "law,ratio,ranks,faces,owned,ghosts,pairs,pairs in open space,ns per particle in open space,"
      "in the periodic cell,ratio of both\n");
  const std::vector<int32_t> owners(set.count(), 0);
  for (const size_t faces : {1, 2, 3}) time_search(options, def, ranks::parts_of(set, owners, 1)[0], faces);
  return 0;
}

void add_options(CLI::App &command, Options &options) {
  bench::add_thrown_options(command, options.thrown);
  command.add_option("--ranks", options.ranks, "Numbers of ranks")->delimiter(',')->capture_default_str();
  command.add_option("--repeats", options.repeats, "Turns, of which the median counts")->capture_default_str();
}

}  // namespace

int main(int argc, char **argv) {
  return bench::run_program("hgrid_selection", "Time what one rank of many does to choose ghosts", argc, argv,
                            add_options, measure_all);
}
