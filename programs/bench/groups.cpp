// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What pairs cost that are not wanted: parked particles, walls that overlap themselves, clumps. Each scene is searched
// with what hg_set_groups and hg_set_bodies know, without it and its unwanted pairs thrown away, and beside both a
// reference that has no unwanted pair to begin with; in turns, in one process. Prints CSV: hgrid_groups [REPEATS].
#include "programs/measure/statistics.hpp"
#include "programs/measure/timing.hpp"

#include <hgrid/hgrid.hpp>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace {

struct Scene {
  std::string name;
  std::vector<double> centers, radii;
  std::vector<int32_t> groups, bodies;  // empty: none

  size_t count() const { return radii.size(); }
  void add(double x, double y, double z, double radius, int32_t group) {
    centers.insert(centers.end(), {x, y, z});
    radii.push_back(radius);
    groups.push_back(group);
  }
  bool is_wanted(const hg_pair &pair) const {
    const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
    if (!bodies.empty()) return bodies[a] != bodies[b];
    return groups[a] >= 0 && groups[b] >= 0 && groups[a] + groups[b] < 2;
  }
};

// A step of a host: particles have moved, all pairs are wanted anew.
class Search {
 public:
  Search(std::string name, const Scene &scene, bool knows, bool filters)
      : name_(std::move(name)), scene_(&scene), filters_(filters) {
    hg_grid_def def = hg_default_grid_def();
    def.thread_count = 1;
    grid_ = hgrid::Grid(def);
    grid_.insert(scene.count(), scene.centers.data(), scene.radii.data());
    if (!knows) return;
    if (!scene.groups.empty()) grid_.set_groups(scene.count(), scene.groups.data());
    if (!scene.bodies.empty()) grid_.set_bodies(scene.count(), scene.bodies.data());
    grid_.set_group_pair(1, 1, false);
  }

  void run() {
    seconds_.push_back(measure::seconds_of([this] {
      grid_.move(scene_->count(), scene_->centers.data());
      const auto pairs = grid_.query_pairs();
      wanted_.clear();
      pairs_ = pairs.size();
      if (!filters_) return;
      for (const hg_pair &pair : pairs) {
        if (scene_->is_wanted(pair)) wanted_.push_back(pair);
      }
      pairs_ = wanted_.size();
    }));
  }

  void print() const {
    const double median = measure::median(seconds_);
    std::printf("%s,%s,%zu,%zu,%.3f,%.1f\n", scene_->name.c_str(), name_.c_str(), scene_->count(), pairs_, 1e3 * median,
                1e9 * median / static_cast<double>(scene_->count()));
  }

 private:
  std::string name_;
  const Scene *scene_;
  bool filters_;
  hgrid::Grid grid_;
  std::vector<double> seconds_;
  std::vector<hg_pair> wanted_;
  size_t pairs_ = 0;
};

class Numbers {
 public:
  double below(double limit) { return std::uniform_real_distribution<double>(0, limit)(engine_); }

 private:
  std::mt19937_64 engine_{1};
};

void add_gas(Scene &scene, size_t count, const double (&box)[3], Numbers &numbers) {
  for (size_t i = 0; i < count; i++) {
    const double x = numbers.below(box[0]), y = numbers.below(box[1]), z = numbers.below(box[2]);
    scene.add(x, y, z, 1, 0);
  }
}

void compare(const Scene &scene, const Scene &reference, const char *reference_name, bool has_unwanted, int repeats) {
  std::vector<Search> searches;
  searches.reserve(3);
  searches.emplace_back("told", scene, true, false);
  if (has_unwanted) searches.emplace_back("thrown away", scene, false, true);
  searches.emplace_back(reference_name, reference, false, false);
  measure::in_turns(searches, repeats);
  for (const Search &search : searches) search.print();
}

// 100 000 spheres, and 10 000 more at one point: 5e7 pairs, which nobody searches for.
void parked(int repeats) {
  Numbers numbers;
  Scene all{"parked", {}, {}, {}, {}};
  add_gas(all, 100000, {100, 100, 100}, numbers);
  Scene without = all;
  for (int i = 0; i < 10000; i++) all.add(-50, -50, -50, 1, -1);
  compare(all, without, "without the parked", false, repeats);
}

// A floor of a million spheres, each of which overlaps some twenty others, under a gas. The reference has the same
// particles, but the floor's lie so far apart that none overlaps another and as many meet the gas.
void walls(int repeats) {
  constexpr int kEdge = 1000;
  constexpr double kSpacing = 0.5, kApart = 2.01;
  Numbers numbers;
  Scene overlapping{"walls", {}, {}, {}, {}}, apart{"walls", {}, {}, {}, {}};
  for (int i = 0; i < kEdge * kEdge; i++) {
    const double x = i / kEdge, y = i % kEdge;
    overlapping.add(kSpacing * x, kSpacing * y, 0, 1, 1);
    apart.add(kApart * x, kApart * y, 0, 1, 1);
  }
  add_gas(overlapping, 300000, {kSpacing * kEdge, kSpacing * kEdge, 20}, numbers);
  add_gas(apart, 300000, {kApart * kEdge, kApart * kEdge, 20 * kSpacing * kSpacing / (kApart * kApart)}, numbers);
  compare(overlapping, apart, "walls that do not overlap", true, repeats);
}

// 20 000 clumps of ten spheres that overlap each other. The reference: as many spheres, spread evenly, with about as
// many pairs as clumps have between them.
void clumps(int repeats) {
  constexpr double kBox = 100, kClump = 0.8;
  Numbers numbers;
  Scene scene{"clumps", {}, {}, {}, {}}, even{"clumps", {}, {}, {}, {}};
  for (int32_t clump = 0; clump < 20000; clump++) {
    const double x = numbers.below(kBox), y = numbers.below(kBox), z = numbers.below(kBox);
    for (int k = 0; k < 10; k++) {
      const double dx = numbers.below(kClump), dy = numbers.below(kClump), dz = numbers.below(kClump);
      scene.add(x + dx, y + dy, z + dz, 0.5, 0);
      scene.bodies.push_back(clump);
      even.add(numbers.below(kBox), numbers.below(kBox), numbers.below(kBox), 0.5, 0);
    }
  }
  compare(scene, even, "spheres spread evenly", true, repeats);
}

}  // namespace

int main(int argc, char **argv) {
  const int repeats = argc > 1 ? std::atoi(argv[1]) : 15;
  std::printf("scene,search,particles,pairs,ms,ns_per_particle\n");
  parked(repeats);
  walls(repeats);
  clumps(repeats);
  return 0;
}
