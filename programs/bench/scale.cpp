// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// One search among very many particles, with its time and the peak memory of the process. Radii of a size law in random
// order, places at random, density 0.62, nothing relaxed.
#include "packing/packing.hpp"
#include "particles/insert.hpp"
#include "particles/text/lists.hpp"
#include "programs/bench/program.hpp"

#include <hgrid/hgrid.h>

#include <CLI/CLI.hpp>
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <utility>

namespace {

struct Options {
  std::string law;
  double ratio = 0;
  size_t count = 0;
  int32_t threads = 1;
};

// No copy of the radii is made on the way: memory is what is measured.
particles::ParticleSet make_particles(const Options &options, double &edge) {
  packing::Request request;
  request.law = packing::law_with(options.law, options.ratio);
  request.count = options.count;
  packing::Beginning beginning = packing::begin_packing(request);
  edge = beginning.box.edge(0);
  particles::ParticleSet set;
  set.radii = std::move(beginning.radii);
  set.centers.resize(3 * set.count());
  for (double &x : set.centers) x = edge * beginning.random.uniform();
  return set;
}

int search(const Options &options) {
  double edge = 0;
  const particles::ParticleSet set = make_particles(options, edge);
  std::printf("%s, ratio %g: %zu particles in a box of edge %g\n", options.law.c_str(), options.ratio, set.count(),
              edge);
  std::fflush(stdout);

  hg_grid_def def = hg_default_grid_def();
  def.thread_count = options.threads;
  const auto start = std::chrono::steady_clock::now();
  hgrid::Grid grid(def);
  particles::insert(set, grid);
  const size_t pair_count = grid.query_pairs().size();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%zu pairs on %d levels in %.1f s, %.0f ns per particle\n", pair_count,
              static_cast<int>(grid.get_stats().level_count), seconds,
              1e9 * seconds / static_cast<double>(set.count()));
  std::printf("peak memory of the process %.2f GiB, 32 bytes per particle of it the input\n",
              static_cast<double>(usage.ru_maxrss) / 1048576.0);
  return 0;
}

void add_options(CLI::App &command, Options &options) {
  command.add_option("LAW", options.law, "Law of the sizes")
      ->required()
      ->check(CLI::IsMember(particles::names_of(packing::size_laws())));
  command.add_option("RATIO", options.ratio, "Its size ratio; the sigma of log-normal")->required();
  command.add_option("COUNT", options.count, "Number of particles")->required();
  command.add_option("THREADS", options.threads, "Threads of the search")->capture_default_str();
}

}  // namespace

int main(int argc, char **argv) {
  return bench::run_program("hgrid_scale", "Time one search among very many particles", argc, argv, add_options,
                            search);
}
