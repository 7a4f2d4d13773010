// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// One search among very many particles, with its time and the peak memory of the process. Radii of a size law in random
// order, places at random, density 0.62, nothing relaxed.
#include "packing/packing.hpp"
#include "particles/error.hpp"
#include "particles/insert.hpp"
#include "particles/text/lists.hpp"
#include "particles/text/number.hpp"

#include <hgrid/hgrid.h>

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <new>
#include <string>
#include <utility>

namespace {

struct Arguments {
  std::string law;
  double ratio = 0;
  size_t count = 0;
  size_t threads = 1;
};

bool read_arguments(int argc, char **argv, Arguments &arguments) {
  if (argc < 4 || argc > 5) return false;
  arguments.law = argv[1];
  return particles::number_fault(argv[2], arguments.ratio) == nullptr &&
         particles::read_count(argv[3], arguments.count) &&
         (argc == 4 || particles::read_count(argv[4], arguments.threads));
}

// No copy of the radii is made on the way: memory is what is measured.
particles::ParticleSet make_particles(const Arguments &arguments, double &edge) {
  packing::Request request;
  request.law = packing::law_with(arguments.law, arguments.ratio);
  request.count = arguments.count;
  packing::Beginning beginning = packing::begin_packing(request);
  edge = beginning.box.edge(0);
  particles::ParticleSet set;
  set.radii = std::move(beginning.radii);
  set.centers.resize(3 * set.count());
  for (double &x : set.centers) x = edge * beginning.random.uniform();
  return set;
}

void search(const Arguments &arguments) {
  double edge = 0;
  const particles::ParticleSet set = make_particles(arguments, edge);
  std::printf("%s, ratio %g: %zu particles in a box of edge %g\n", arguments.law.c_str(), arguments.ratio, set.count(),
              edge);
  std::fflush(stdout);

  hg_grid_def def = hg_default_grid_def();
  def.thread_count = static_cast<int32_t>(arguments.threads);
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
}

}  // namespace

int main(int argc, char **argv) {
  Arguments arguments;
  if (!read_arguments(argc, argv, arguments)) {
    const std::string laws = particles::joined(particles::names_of(packing::size_laws()), " or ");
    std::fprintf(stderr, "usage: hgrid_scale LAW RATIO COUNT [THREADS (1)]\nLAW: %s (its sigma for RATIO)\n",
                 laws.c_str());
    return 2;
  }
  try {
    search(arguments);
    return 0;
  } catch (const particles::Error &error) {
    std::fprintf(stderr, "hgrid_scale: %s\n", error.what());
  } catch (const std::bad_alloc &) {
    std::fprintf(stderr, "hgrid_scale: no memory for %zu particles\n", arguments.count);
  }
  return 1;
}
