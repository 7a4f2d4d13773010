// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Many spheres among equal ones at random places: all at once, one by one, and with nanoflann, if it is installed. What
// is counted is a query and its answer; trees and grids are ready. programs/bench/queries.py times SciPy on the same.
#include "packing/random.hpp"
#include "particles/text/output.hpp"
#include "programs/bench/csv_row.hpp"
#include "programs/bench/machine.hpp"
#include "programs/bench/program.hpp"
#if defined(HGRID_PEER_NANOFLANN)
#include "programs/bench/peers/nanoflann_spheres.hpp"
#endif

#include <hgrid/hgrid.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Options {
  size_t count = 100000, spheres = 20000;
  double density = 0.5, radius = 1, skin = 0;
  bool periodic = false;
  int32_t threads = 1;
  int runs = 31;
  std::string csv;
};

// Unit spheres and queries in a cube.
struct System {
  double edge;
  std::vector<double> centers, radii, queries, query_radii;

  explicit System(const Options &options)
      : edge(std::cbrt(4.0 / 3.0 * 3.14159265358979 * static_cast<double>(options.count) / options.density)),
        radii(options.count, 1.0),
        query_radii(options.spheres, options.radius) {
    packing::Random random(1);
    for (size_t k = 0; k < 3 * options.count; k++) centers.push_back(edge * random.uniform());
    for (size_t k = 0; k < 3 * options.spheres; k++) queries.push_back(edge * random.uniform());
  }
};

hgrid::Grid make_grid(const Options &options, const System &system) {
  hg_grid_def def = hg_default_grid_def();
  def.thread_count = options.threads;
  def.skin = options.skin;
  std::fill(def.periodic, def.periodic + 3, options.periodic ? 1 : 0);
  std::fill(def.box_max, def.box_max + 3, system.edge);
  hgrid::Grid grid(def);
  grid.insert(options.count, system.centers.data(), system.radii.data());
  grid.query_pairs();
  return grid;
}

// One way to ask all queries. Returns the number of hits.
struct Contestant {
  const char *name;
  std::function<size_t()> ask;
};

std::vector<Contestant> contestants_of(const Options &options, const System &system, hgrid::Grid &grid) {
  std::vector<Contestant> all;
  all.push_back({"hg_query_spheres", [&] {
                   return grid.query_spheres(options.spheres, system.queries.data(), system.query_radii.data())
                       .offsets[options.spheres];
                 }});
  all.push_back({"hg_query_sphere, one by one", [&] {
                   size_t hits = 0;
                   for (size_t k = 0; k < options.spheres; k++) {
                     hits += grid.query_sphere(&system.queries[3 * k], system.query_radii[k]).size();
                   }
                   return hits;
                 }});
#if defined(HGRID_PEER_NANOFLANN)
  if (!options.periodic) {
    all.push_back({"nanoflann", bench::nanoflann_spheres(system.centers, 1 + options.radius, system.queries)});
  }
#endif
  return all;
}

// Of each run, in us for each query, ascending at the end. A machine that others use, too, gives each a part of the
// wall time; the processor time is that of all threads.
struct Times {
  std::vector<double> wall, processor;

  void sort() {
    std::sort(wall.begin(), wall.end());
    std::sort(processor.begin(), processor.end());
  }
  static double median(const std::vector<double> &of) { return of[of.size() / 2]; }
};

void write_row(particles::Output &out, const Options &options, const char *name, double hits, const Times &times) {
  bench::CsvRow(out)
      .text(name)
      .number(options.count)
      .number(options.spheres)
      .number(options.density)
      .number(options.radius)
      .number(options.periodic ? 1 : 0)
      .number(options.skin)
      .number(options.threads)
      .number(hits)
      .number(Times::median(times.wall))
      .number(times.wall.front())
      .number(Times::median(times.processor))
      .number(times.processor.front())
      .number(options.runs)
      .text(bench::processor())
      .text(bench::compiler())
      .text(bench::commit());
}

int compare(const Options &options) {
  const System system(options);
  hgrid::Grid grid = make_grid(options, system);
  const std::vector<Contestant> contestants = contestants_of(options, system, grid);
  std::vector<Times> times(contestants.size());
  std::vector<size_t> hits(contestants.size());
  for (int run = 0; run < options.runs; run++) {  // in turns, so that all see the same machine
    for (size_t k = 0; k < contestants.size(); k++) {
      const std::clock_t processor = std::clock();
      const auto start = std::chrono::steady_clock::now();
      hits[k] = contestants[k].ask();
      const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
      const auto used = static_cast<double>(std::clock() - processor) * 1e6 / CLOCKS_PER_SEC;
      times[k].wall.push_back(time.count() / static_cast<double>(options.spheres));
      times[k].processor.push_back(used / static_cast<double>(options.spheres));
    }
  }
  std::optional<particles::Output> out;
  if (!options.csv.empty()) {
    out.emplace(options.csv);
    *out << "search,particles,spheres,density,radius,periodic,skin,threads,hits_per_sphere,median_us,min_us,processor_"
            "us,"
            "min_processor_us,runs,machine,compiler,commit\n";
  }
  for (size_t k = 0; k < contestants.size(); k++) {
    if (hits[k] != hits[0]) throw std::runtime_error(std::string(contestants[k].name) + " finds other particles");
    times[k].sort();
    const double per_sphere = static_cast<double>(hits[k]) / static_cast<double>(options.spheres);
    std::printf("%-28s %8.3f us each, %8.3f of processors, %8.3f at best, %g hits\n", contestants[k].name,
                Times::median(times[k].wall), Times::median(times[k].processor), times[k].processor.front(),
                per_sphere);
    if (out) write_row(*out, options, contestants[k].name, per_sphere, times[k]);
  }
  if (out) out->close();
  return 0;
}

void add_options(CLI::App &command, Options &options) {
  command.add_option("--count", options.count, "Number of particles")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--spheres", options.spheres, "Number of queries")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--density", options.density, "Volume of the particles over that of the cube")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--radius", options.radius, "Of the queries, in radii of particles")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_option("--skin", options.skin, "Of the grid")->check(CLI::NonNegativeNumber)->capture_default_str();
  command.add_flag("--periodic", options.periodic, "All axes are");
  command.add_option("--threads", options.threads, "Of the grid")->capture_default_str();
  command.add_option("--runs", options.runs, "How often all are timed")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--csv", options.csv, "Where to write the measurements");
}

}  // namespace

int main(int argc, char **argv) {
  return bench::run_program("hgrid_queries", "Time many spheres among particles", argc, argv, add_options, compare);
}
