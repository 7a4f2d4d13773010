// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Appendix A in several ways, and the library's own: what each choice costs by Eq. 7 with all radii counted, and how
// long choosing took.
#include "programs/accuracy/optimiser_knob.hpp"

#include "packing/random.hpp"
#include "particles/insert.hpp"
#include "programs/accuracy/appendix_a.hpp"
#include "programs/accuracy/systems.hpp"
#include "programs/measure/search_timer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>

namespace accuracy {
namespace {

// One way to choose. `choose` starts from radii in no order and is timed as a whole; it returns the largest radius of
// each level.
struct Way {
  std::string name;
  std::function<std::vector<double>(packing::Random &random)> choose;
  int draws;  // choices that depend on chance are made that often, and the mean excess counts
  std::vector<double> seconds;
};

Sizes sizes_of(const particles::ParticleSet &particles, std::vector<double> radii) {
  std::sort(radii.begin(), radii.end());
  Sizes sizes;
  sizes.weight = static_cast<double>(particles.count()) / static_cast<double>(radii.size());
  sizes.radii = std::move(radii);
  sizes.edge = particles.box_max[0];
  return sizes;
}

std::vector<double> chosen_on_grid(const particles::ParticleSet &particles, double step) {
  const Sizes sizes = sizes_of(particles, particles.radii);
  return edges_of(sizes, cheapest_on_grid(sizes, kPaperOverhead, step).ends);
}

std::vector<double> chosen_from(const particles::ParticleSet &particles, std::vector<double> radii) {
  const Sizes sizes = sizes_of(particles, std::move(radii));
  return edges_of(sizes, cheapest_by_bisection(sizes, kPaperOverhead).ends);
}

std::vector<double> sample_of(const particles::ParticleSet &particles, size_t count, packing::Random &random) {
  std::vector<double> radii;
  for (size_t k = 0; k < count; k++) radii.push_back(particles.radii[random.below(particles.count())]);
  return radii;
}

std::vector<Way> ways_of(const particles::ParticleSet &particles, const Budget &budget) {
  std::vector<Way> ways;
  for (const double step : {1.0, 0.3, 0.1, 0.01, 0.001}) {
    char name[40];
    std::snprintf(name, sizeof name, "all radii, grid of m, step %g", step);
    ways.push_back({name, [&particles, step](auto &) { return chosen_on_grid(particles, step); }, 1, {}});
  }
  for (const size_t count : {100, 1000, 10000}) {
    if (count >= particles.count()) continue;
    const auto choose = [&particles, count](auto &random) {
      return chosen_from(particles, sample_of(particles, count, random));
    };
    ways.push_back({std::to_string(count) + " radii, bisection", choose, budget.quick ? 4 : 20, {}});
  }
  const auto exact = [&particles](auto &) { return chosen_from(particles, particles.radii); };
  ways.push_back({"all radii, bisection", exact, 1, {}});
  return ways;
}

TradePoint point_with(const std::string &system, const std::string &setting, double excess) {
  TradePoint point;
  point.knob = "optimiser";
  point.system = system;
  point.setting = setting;
  point.error_of = "cost above the least";
  point.error = excess;
  return point;
}

TradePoint point_of(const std::string &system, const Way &way, const Sizes &all, double least) {
  packing::Random random(1);
  double excess = 0;
  size_t levels = 0;
  for (int draw = 0; draw < way.draws; draw++) {
    const std::vector<double> edges = way.choose(random);
    excess += (cost_of_edges(all, edges, kPaperOverhead) / least - 1) / way.draws;
    levels = edges.size();
  }
  TradePoint point = point_with(system, way.name, excess);
  point.cost = 1e9 * measure::median(way.seconds) / static_cast<double>(all.radii.size());
  point.note = way.draws > 1 ? "mean of " + std::to_string(way.draws) + " draws" : std::to_string(levels) + " levels";
  return point;
}

// The library's choice, its time the difference to a grid that is told its cells.
class LibraryChoice {
 public:
  LibraryChoice(const particles::ParticleSet &particles, int32_t rule)
      : particles_(particles), asked_(def_of(particles, rule)), told_(told_def()) {}

  void run() {
    asked_seconds_.push_back(build_seconds(asked_));
    told_seconds_.push_back(build_seconds(told_));
  }

  // None where the difference drowns in the noise.
  std::optional<TradePoint> point(const std::string &system, const char *name, const Sizes &all, double least) {
    const double seconds = measure::median(asked_seconds_) - measure::median(told_seconds_);
    if (!(seconds > 0)) return std::nullopt;
    std::vector<double> edges;
    for (const hg_level &level : asked_.query_levels()) edges.push_back(level.largest_radius);
    TradePoint point = point_with(system, name, cost_of_edges(all, edges, kPaperOverhead) / least - 1);
    point.cost = 1e9 * seconds / static_cast<double>(particles_.count());
    point.note = std::to_string(edges.size()) + " levels";
    return point;
  }

 private:
  static hg_grid_def def_of(const particles::ParticleSet &particles, int32_t rule) {
    hg_grid_def def = measure::def_of(particles);
    def.thread_count = 1;
    def.level_rule = rule;
    def.cell_overhead = kPaperOverhead;
    return def;
  }

  hg_grid_def told_def() {
    particles::insert(particles_, asked_);
    for (const hg_level &level : asked_.query_levels()) cell_sizes_.push_back(level.cell_size);
    hg_grid_def def = def_of(particles_, HG_LEVELS_USER);
    def.level_count = static_cast<int32_t>(cell_sizes_.size());
    def.cell_sizes = cell_sizes_.data();
    return def;
  }

  double build_seconds(hgrid::Grid &grid) {
    grid.clear();
    return measure::seconds_of([&] {
      particles::insert(particles_, grid);
      grid.build();
    });
  }

  const particles::ParticleSet &particles_;
  std::vector<double> cell_sizes_;
  hgrid::Grid asked_, told_;
  std::vector<double> asked_seconds_, told_seconds_;
};

void measure_system(const std::string &name, const particles::ParticleSet &particles, const Budget &budget,
                    const Progress &progress, std::vector<TradePoint> &points) {
  std::vector<Way> ways = ways_of(particles, budget);
  LibraryChoice paper(particles, HG_LEVELS_PAPER), automatic(particles, HG_LEVELS_AUTO);
  packing::Random random(2);
  for (int repeat = 0; repeat < budget.repeats; repeat++) {
    for (Way &way : ways) way.seconds.push_back(measure::seconds_of([&] { way.choose(random); }));
    paper.run();
    automatic.run();
  }
  const Sizes all = sizes_of(particles, particles.radii);
  const double least = cheapest_by_bisection(all, kPaperOverhead).cost;
  for (const Way &way : ways) points.push_back(point_of(name, way, all, least));
  const auto add = [&](LibraryChoice &choice, const char *way) {
    const std::optional<TradePoint> point = choice.point(name, way, all, least);
    if (point) {
      points.push_back(*point);
    } else {
      progress(name + ", " + way + ": too quick to be told from noise, left out");
    }
  };
  add(paper, "library, HG_LEVELS_PAPER");
  add(automatic, "library, HG_LEVELS_AUTO with K = 0.3");
}

}  // namespace

std::vector<TradePoint> measure_optimisers(const Budget &budget, const Progress &progress) {
  using packing::Law;
  const std::vector<std::pair<std::string, packing::SizeLaw>> systems = {
      {"uniform volume, ratio 50", {Law::kUniformVolume, 50, 3}},
      {"uniform size, ratio 50", {Law::kUniformSize, 50, 3}}};
  std::vector<TradePoint> points;
  for (const auto &[name, law] : systems) {
    progress(name);
    measure_system(name, relaxed(law, budget.timed_count, 0), budget, progress, points);
  }
  return points;
}

}  // namespace accuracy
