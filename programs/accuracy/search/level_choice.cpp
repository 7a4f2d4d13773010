// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Varies how the cheapest levels are looked for: on a grid of m or by bisection, among all radii or a sample of them,
// and as the library does. What each choice costs by Eq. 7 with all radii counted, and how long choosing took.
#include "packing/random.hpp"
#include "particles/text/formatted.hpp"
#include "programs/accuracy/search/appendix_a.hpp"
#include "programs/accuracy/search/studies.hpp"
#include "programs/accuracy/search/systems.hpp"
#include "programs/measure/search_timer.hpp"

#include <algorithm>
#include <memory>

namespace accuracy {
namespace {

using packing::Random;
using Edges = std::vector<double>;  // the largest radius of each level

// One way to choose, from radii in no order.
struct Method {
  std::string name;
  std::function<Edges(Random &)> choose;
  std::function<double(Random &)> seconds_once;  // of a choice
  int draws;  // choices that depend on chance are made that often, and the mean excess counts
  std::vector<double> seconds{};
  Random random{2};

  void run() { seconds.push_back(seconds_once(random)); }
};

Sizes sizes_of(const particles::ParticleSet &particles, std::vector<double> radii) {
  std::sort(radii.begin(), radii.end());
  Sizes sizes;
  sizes.weight = static_cast<double>(particles.count()) / static_cast<double>(radii.size());
  sizes.radii = std::move(radii);
  sizes.edge = particles.box_max[0];
  return sizes;
}

Edges chosen_on_grid(const particles::ParticleSet &particles, double step) {
  const Sizes sizes = sizes_of(particles, particles.radii);
  return edges_of(sizes, cheapest_on_grid(sizes, kPaperOverhead, step).ends);
}

Edges chosen_from(const particles::ParticleSet &particles, std::vector<double> radii) {
  const Sizes sizes = sizes_of(particles, std::move(radii));
  return edges_of(sizes, cheapest_by_bisection(sizes, kPaperOverhead).ends);
}

std::vector<double> sample_of(const particles::ParticleSet &particles, size_t count, Random &random) {
  std::vector<double> radii;
  for (size_t k = 0; k < count; k++) radii.push_back(particles.radii[random.below(particles.count())]);
  return radii;
}

// A method of our own is timed as a whole.
Method own_method(const std::string &name, const std::function<Edges(Random &)> &choose, int draws = 1) {
  const auto once = [choose](Random &random) { return measure::seconds_of([&] { choose(random); }); };
  return {name, choose, once, draws};
}

double build_seconds(hgrid::Grid &grid, const particles::ParticleSet &particles) {
  grid.clear();
  return measure::seconds_of([&] {
    particles::insert(particles, grid);
    grid.build();
  });
}

// The library's choice, its time the difference to a grid that is told its cells.
Method library_method(const std::string &name, const particles::ParticleSet &particles, int32_t rule) {
  hg_grid_def def = measure::def_of(particles);
  def.thread_count = 1;
  def.level_rule = rule;
  def.cell_overhead = kPaperOverhead;
  const auto asked = std::make_shared<hgrid::Grid>(def);
  particles::insert(particles, *asked);
  Edges edges;
  std::vector<double> cell_sizes;
  for (const hg_level &level : asked->query_levels()) {
    edges.push_back(level.largest_radius);
    cell_sizes.push_back(level.cell_size);
  }
  def.level_rule = HG_LEVELS_USER;
  def.level_count = static_cast<int32_t>(cell_sizes.size());
  def.cell_sizes = cell_sizes.data();
  const auto told = std::make_shared<hgrid::Grid>(def);
  const auto once = [asked, told, &particles](Random &) {
    return build_seconds(*asked, particles) - build_seconds(*told, particles);
  };
  return {name, [edges](Random &) { return edges; }, once, 1};
}

std::vector<Method> methods_for(const particles::ParticleSet &particles, const Budget &budget) {
  std::vector<Method> methods;
  for (const double step : {1.0, 0.3, 0.1, 0.01, 0.001}) {
    methods.push_back(own_method(particles::formatted("all radii, grid of m, step %g", step),
                                 [&particles, step](Random &) { return chosen_on_grid(particles, step); }));
  }
  for (const size_t count : {100, 1000, 10000}) {
    if (count >= particles.count()) continue;
    const auto choose = [&particles, count](Random &random) {
      return chosen_from(particles, sample_of(particles, count, random));
    };
    methods.push_back(own_method(std::to_string(count) + " radii, bisection", choose, budget.quick ? 4 : 20));
  }
  methods.push_back(
      own_method("all radii, bisection", [&particles](Random &) { return chosen_from(particles, particles.radii); }));
  methods.push_back(library_method("library, HG_LEVELS_PAPER", particles, HG_LEVELS_PAPER));
  methods.push_back(library_method("library, HG_LEVELS_AUTO with K = 0.3", particles, HG_LEVELS_AUTO));
  return methods;
}

Finding finding_of(const Method &method, const Sizes &all, double least) {
  Random random(1);
  double excess = 0;
  size_t levels = 0;
  for (int draw = 0; draw < method.draws; draw++) {
    const Edges edges = method.choose(random);
    excess += (cost_of_edges(all, edges, kPaperOverhead) / least - 1) / method.draws;
    levels = edges.size();
  }
  const std::string note =
      method.draws > 1 ? "mean of " + std::to_string(method.draws) + " draws" : std::to_string(levels) + " levels";
  return {method.name,
          1e9 * measure::median(method.seconds) / static_cast<double>(all.radii.size()),
          {{"cost above the least", excess, note}}};
}

void measure_system(const particles::ParticleSet &particles, Recorder &record) {
  std::vector<Method> methods = methods_for(particles, record.budget());
  measure::in_turns(methods, record.budget().repeats);
  const Sizes all = sizes_of(particles, particles.radii);
  const double least = cheapest_by_bisection(all, kPaperOverhead).cost;
  for (const Method &method : methods) {
    const Finding finding = finding_of(method, all, least);
    if (finding.cost > 0) {
      record.add(finding);
    } else {
      record.tell(method.name + ": too quick to be told from noise, left out");
    }
  }
}

}  // namespace

void measure_level_choices(Recorder &record) {
  for (const auto &[name, law] : {kUniformVolume50, kUniformSize50}) {
    record.begin(name);
    measure_system(relaxed(law, record.budget().timed_count, 0), record);
  }
}

}  // namespace accuracy
